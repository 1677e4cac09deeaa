// SPDX-License-Identifier: GPL-2.0-or-later
// Readers meet files that were damaged at random: each must be read or refused with a UserError, quickly, and
// whatever is read must be sound. Run under the sanitizers this also finds what reads beyond its bounds.
#include <gmock/gmock.h>

#include <functional>
#include <random>
#include <sstream>

#include "molecule/cases.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/molecule/formats/lammps_data.h"
#include "nanocarbon/molecule/formats/xyz.h"
#include "nanocarbon/structures/graphene.h"
#include "nanocarbon/structures/hydrocarbons.h"
#include "support/read_text.h"

namespace nanocarbon::molecule {
namespace {

constexpr int rounds = 4000;

std::string mutated(std::string text, std::mt19937_64& random) {
  static const std::vector<std::string> components = {
      "\n",         "\n\n",
      " ",          "-1",
      "0",          "99999999999999999999",
      "1e308",      "-1e-308",
      "nan",        "inf",
      "C",          "H",
      "Si",         "#",
      "\"",         "{",
      "=",          "Atoms",
      "Bonds",      "atoms",
      "Masses",     "xlo xhi",
      "pbc",        "T",
      "\t\r ",      "\xff",
      "avec",       std::string(1, '\0'),
      "4294967295", "Properties=species:S:1:pos:R:3:x:R:999 "};
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

void expect_sound(const Molecule& m) {
  ASSERT_EQ(m.positions.size(), m.elements.size());
  for (const Vec3& p : m.positions) ASSERT_TRUE(p.allFinite());
  for (std::size_t b = 0; b < m.bonds.size(); ++b) {
    ASSERT_LE(m.bonds[b].first, m.bonds[b].second);
    ASSERT_LT(m.bonds[b].second, m.size());
    if (b > 0) {
      ASSERT_LT(m.bonds[b - 1], m.bonds[b]);
    }
  }
  if (m.cell) {
    ASSERT_GT(volume(*m.cell), 0.0);
  }
}

void mutate(const std::string& file, const std::function<void(const std::string&)>& read) {
  std::mt19937_64 random(1);
  int refused = 0;
  for (int round = 0; round < rounds; ++round) {
    const std::string text = mutated(file, random);
    try {
      read(text);
    } catch (const UserError&) {
      ++refused;
    } catch (const std::exception& error) {
      FAIL() << error.what() << "\n" << text;
    }
    if (testing::Test::HasFatalFailure()) FAIL() << text;
  }
  // The damage must matter, but not always.
  EXPECT_GT(refused, rounds / 10);
  EXPECT_LT(refused, rounds);
}

TEST(MutatedFiles, LammpsData) {
  for (const AtomStyle style : {AtomStyle::atomic, AtomStyle::full}) {
    std::ostringstream out;
    LammpsDataOptions options;
    options.atom_style = style;
    write_lammps_data(out, style == AtomStyle::full ? structures::graphene(2, 1) : structures::benzene(),
                      options);
    mutate(out.str(), [](const std::string& text) {
      for (const MoleculeFrame& frame : test::read_frames(text, "mutated.data")) expect_sound(frame.molecule);
    });
  }
}

TEST(MutatedFiles, Xyz) {
  std::ostringstream out;
  write_xyz(out, structures::benzene());
  write_xyz(out, structures::graphene(2, 1));
  mutate(out.str(), [](const std::string& text) {
    for (const MoleculeFrame& frame : test::read_frames(text, "mutated.xyz")) expect_sound(frame.molecule);
  });
}

}  // namespace
}  // namespace nanocarbon::molecule
