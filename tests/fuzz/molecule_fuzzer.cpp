// SPDX-License-Identifier: GPL-2.0-or-later
// For libFuzzer, run by run.sh: fuzz_molecule_data, fuzz_molecule_xyz, ..., one for each name.
// The last byte of the input chooses the options, so that any file is an input as it is; the rest is the file.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/check_molecule.h"
#include "fuzz/program_name.h"

namespace {

using nanocarbon::molecule::MoleculeReadOptions;

std::string file;

std::vector<MoleculeReadOptions> all_options() {
  return {{},
          {},
          {.types = {"C", "H"}},
          {.types = {"1=C", "CA=C", "2=H"}},
          {.atom_style = "full"},
          {.atom_style = "hybrid"},
          {.types = {"C"}, .periodic = std::array{true, true, false}},
          {.types = {"C"}, .periodic = std::array{false, false, false}}};
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char*** arguments) {
  file = "a." + nanocarbon::test::fuzzed_by(**arguments);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  static const std::vector<MoleculeReadOptions> options = all_options();
  const std::string_view contents(reinterpret_cast<const char*>(data), size - 1);
  const std::string broken =
      nanocarbon::test::broken_promise(contents, file, options[data[size - 1] % options.size()]);
  if (!broken.empty()) {
    std::fprintf(stderr, "%s\n", broken.c_str());
    std::abort();
  }
  return 0;
}
