// SPDX-License-Identifier: GPL-2.0-or-later
// For libFuzzer, built as mesh_fuzzer.cpp says: fuzz_molecule, for files of atoms of every format.
// The first byte of the input chooses the options, the rest is the file, packed or not.
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/check_molecule.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/molecule/formats/read_molecule.h"

namespace {

using nanocarbon::molecule::MoleculeReadOptions;

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

// Through a file, so that gzip is unpacked.
void read_packed(std::string_view contents, const MoleculeReadOptions& options) {
  const int file = memfd_create("packed", 0);
  if (file < 0) return;
  if (::write(file, contents.data(), contents.size()) == static_cast<ssize_t>(contents.size())) {
    try {
      nanocarbon::molecule::read_molecule("/proc/self/fd/" + std::to_string(file), options);
    } catch (const nanocarbon::UserError&) {
    }
  }
  ::close(file);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  static const std::vector<MoleculeReadOptions> options = all_options();
  const std::string_view contents(reinterpret_cast<const char*>(data) + 1, size - 1);
  const MoleculeReadOptions& chosen = options[data[0] % options.size()];
  if (contents.starts_with("\x1f\x8b")) {
    read_packed(contents, chosen);
    return 0;
  }
  constexpr const char* files[] = {"a.xyz", "a.data", "a.dump", "a.cif", "POSCAR", "fuzz"};
  const std::string broken = nanocarbon::test::broken_promise(contents, files[(data[0] / 8) % 6], chosen);
  if (!broken.empty()) {
    std::fprintf(stderr, "%s\n", broken.c_str());
    std::abort();
  }
  return 0;
}
