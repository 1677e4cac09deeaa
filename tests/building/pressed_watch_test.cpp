// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/pressed_watch.h"

#include <gtest/gtest.h>

#include <vector>

#include "nanocarbon/molecule/molecule.h"
#include "nanocarbon/structures/fullerene.h"

namespace nanocarbon::building {
namespace {

// Two cages of C60 side by side, one of them a given distance from the other, nearest atom to nearest atom.
Molecule two_cages(double apart) {
  Molecule both = structures::fullerene(1, 1);
  const std::size_t atoms = both.size();
  AtomIndex right = 0, left = 0;
  for (AtomIndex a = 0; a < atoms; ++a) {
    if (both.positions[a].x() > both.positions[right].x()) right = a;
    if (both.positions[a].x() < both.positions[left].x()) left = a;
  }
  const Vec3 shift = both.positions[right] - both.positions[left] + Vec3(apart, 0, 0);
  for (std::size_t a = 0; a < atoms; ++a) {
    both.positions.push_back(both.positions[a] + shift);
    both.elements.push_back(both.elements[a]);
  }
  for (std::size_t b = 0, bonds = both.bonds.size(); b < bonds; ++b)
    both.bonds.push_back({both.bonds[b].first + static_cast<AtomIndex>(atoms),
                          both.bonds[b].second + static_cast<AtomIndex>(atoms)});
  return both;
}

// The iteration at which it is told, of 1000.
int told_at(const std::vector<Vec3>& positions, const annealing::FixedBondGraph& graph) {
  PressedWatch watch(graph);
  for (int iteration = 1; iteration <= 1000; ++iteration)
    if (watch.for_good(iteration, positions)) return iteration;
  return 0;
}

TEST(PressedWatch, TellsCagesThatStayWithinTheCutOff) {
  const Molecule pressed = two_cages(1.95), apart = two_cages(2.05);
  EXPECT_EQ(told_at(pressed.positions, annealing::fixed_bond_graph(pressed)),
            PressedWatch::looks * PressedWatch::between);
  EXPECT_EQ(told_at(apart.positions, annealing::fixed_bond_graph(apart)), 0);
}

// Atoms that meet on the way and part again are none of its business; nor are hydrogens, which follow the carbons.
TEST(PressedWatch, WaitsForThoseThatMayPart) {
  const Molecule pressed = two_cages(1.95), apart = two_cages(2.05);
  const annealing::FixedBondGraph graph = annealing::fixed_bond_graph(pressed);
  PressedWatch watch(graph);
  for (int iteration = 1; iteration <= 10 * PressedWatch::looks * PressedWatch::between; ++iteration) {
    const bool meets = iteration / PressedWatch::between % PressedWatch::looks != 0;
    std::vector<Vec3> positions = meets ? pressed.positions : apart.positions;
    positions.push_back(positions.front() + Vec3(0.5, 0, 0));
    EXPECT_FALSE(watch.for_good(iteration, positions)) << iteration;
  }
}

}  // namespace
}  // namespace nanocarbon::building
