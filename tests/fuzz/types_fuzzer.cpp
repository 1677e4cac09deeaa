// SPDX-License-Identifier: GPL-2.0-or-later
// For libFuzzer, run by run.sh: fuzz_types, for what a user says by --types, one word a line, and for atoms' names.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "nanocarbon/core/error.h"
#include "nanocarbon/molecule/formats/read_molecule.h"
#include "nanocarbon/molecule/formats/species.h"

namespace {

using nanocarbon::molecule::MoleculeFile;
using nanocarbon::molecule::MoleculeReadOptions;

void require(bool kept, const char* promise) {
  if (kept) return;
  std::fprintf(stderr, "broken: %s\n", promise);
  std::abort();
}

// Two types without masses, and names of all kinds.
constexpr const char* data =
    "two types\n\n2 atoms\n2 atom types\n0 9 xlo xhi\n0 9 ylo yhi\n0 9 zlo zhi\n\nAtoms # atomic\n\n"
    "1 1 0 0 0\n2 2 1.1 0 0\n";
constexpr const char* xyz = "4\nnames\nC1 0 0 0\nCA 1.4 0 0\nhc 2.4 0 0\n1 3.4 0 0\n";

void read(const char* contents, const MoleculeReadOptions& options) {
  try {
    MoleculeFile file(contents, "file", options);
    const auto frame = file.next();
    require(frame && frame->molecule.size() == frame->molecule.elements.size(), "an element for each atom");
    file.unused_types();
  } catch (const nanocarbon::UserError& error) {
    require(
        error.failure() == nanocarbon::Failure::usage || error.failure() == nanocarbon::Failure::unsuitable,
        "a sound file is not called malformed");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  std::istringstream input(std::string(bytes, bytes + size));
  MoleculeReadOptions options;
  for (std::string word; std::getline(input, word);) {
    const auto element = nanocarbon::molecule::atomic_number_of_label(word);
    require(!element || (*element >= 1 && *element <= 118), "an element has an atomic number");
    options.types.push_back(word);
  }
  try {
    nanocarbon::molecule::TypeNames names(options.types);
    const std::vector<std::string> unused = names.unused();
    for (const std::string& name : unused)
      require(names.find(name).has_value(), "a name that is unused is known");
    require(names.unused().empty(), "a name that was asked for is used");
  } catch (const nanocarbon::UserError& error) {
    require(error.failure() == nanocarbon::Failure::usage, "wrong types are the command line's fault");
    require(std::string(error.what()).find("--types") != std::string::npos, "the message names the option");
  }
  read(data, options);
  read(xyz, options);
  return 0;
}
