// SPDX-License-Identifier: GPL-2.0-or-later
// Thousands of damaged files of atoms, always the same ones: each must be refused as the user's error or come out as
// promised, without a crash, a hang, or an allocation that the file's size does not justify.
#include <gmock/gmock.h>

#include <random>

#include "fuzz/allocation_watch.h"
#include "fuzz/check_molecule.h"
#include "fuzz/seeds.h"

namespace nanocarbon {
namespace {

std::string mutated(std::string text, std::mt19937_64& random) {
  static const std::vector<std::string> components = {"\n",
                                                      "\n\n",
                                                      " ",
                                                      "-1",
                                                      "0",
                                                      "99999999999999999999",
                                                      "1e308",
                                                      "-1e-308",
                                                      "nan",
                                                      "inf",
                                                      "C",
                                                      "H",
                                                      "Si",
                                                      "#",
                                                      "\"",
                                                      "{",
                                                      "=",
                                                      "Atoms",
                                                      "Bonds",
                                                      "atoms",
                                                      "Masses",
                                                      "xlo xhi",
                                                      "pbc",
                                                      "T",
                                                      "\t\r ",
                                                      "\xff",
                                                      "avec",
                                                      std::string(1, '\0'),
                                                      "4294967295",
                                                      "Properties=species:S:1:pos:R:3:x:R:999 ",
                                                      "ITEM: ATOMS id type x y z\n",
                                                      "loop_\n_atom_site_label\n",
                                                      "'",
                                                      ";\n",
                                                      "?",
                                                      "data_",
                                                      "Direct\n",
                                                      "\\"};
  const auto below = [&](std::size_t n) {
    return static_cast<std::size_t>(random() % std::max<std::size_t>(n, 1));
  };
  for (std::size_t edits = 1 + below(4); edits > 0; --edits) {
    const std::size_t at = below(text.size()), length = std::min(below(12), text.size() - at);
    switch (random() % 5) {
      case 0:
        text.erase(at, length);
        break;
      case 1:
        text.insert(at, components[below(components.size())]);
        break;
      case 2:
        text.replace(at, length, components[below(components.size())]);
        break;
      case 3:
        text.insert(at, text.substr(below(text.size()), 40));
        break;
      default:
        text.resize(at);
        break;
    }
  }
  return text;
}

class MoleculeMutants : public testing::TestWithParam<std::size_t> {};

TEST_P(MoleculeMutants, AreRefusedOrComeOutAsPromised) {
  const test::Seed seed = test::molecule_seeds()[GetParam()];
  EXPECT_EQ(test::broken_promise(seed.contents, seed.file, {}), "");
  std::mt19937_64 random(GetParam() + 1);
  const std::vector<molecule::MoleculeReadOptions> options = {
      {}, {.types = {"C", "H"}}, {.periodic = std::array{true, false, true}}};
  for (int mutant = 0; mutant < 1500; ++mutant) {
    const std::string text = mutated(seed.contents, random);
    test::reset_largest_allocation();
    ASSERT_EQ(
        test::broken_promise(text, seed.file, options[static_cast<std::size_t>(mutant) % options.size()]), "")
        << seed.file << " mutant " << mutant << ":\n"
        << text;
    // A reader has a block of the file at once, and makes room for some atoms.
    ASSERT_LT(test::largest_allocation(), 4'000'000 + 100 * text.size())
        << seed.file << " mutant " << mutant << ":\n"
        << text;
  }
}

TEST_P(MoleculeMutants, EveryTruncationIsRefusedOrComesOutAsPromised) {
  const test::Seed seed = test::molecule_seeds()[GetParam()];
  for (std::size_t size = 0; size < seed.contents.size(); ++size)
    ASSERT_EQ(test::broken_promise(seed.contents.substr(0, size), seed.file, {}), "")
        << seed.file << " cut to " << size;
}

// What is broken from the start tests no more than the first line of a reader.
TEST_P(MoleculeMutants, BeginFromWhatIsRead) {
  const test::Seed seed = test::molecule_seeds()[GetParam()];
  molecule::MoleculeReadOptions options;
  if (seed.file == "CONTCAR") options.types = {"C"};  // of VASP 4, without elements
  EXPECT_GT(test::atoms_read(seed.contents, seed.file, options), 0u) << seed.file;
}

INSTANTIATE_TEST_SUITE_P(EveryFormat, MoleculeMutants, testing::Range<std::size_t>(0, 17));

TEST(MoleculeMutantSeeds, AreAllUsed) { EXPECT_EQ(test::molecule_seeds().size(), 17u); }

}  // namespace
}  // namespace nanocarbon
