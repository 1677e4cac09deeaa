// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/bond_shells.h"

#include <gmock/gmock.h>

#include "nanocarbon/annealing/fixed_bond_graph.h"
#include "nanocarbon/structures/fullerene.h"

namespace nanocarbon::annealing {
namespace {

// Atoms of C60 at 0, 1, 2, ... bonds from one: Hosoya's distance degrees.
TEST(BondShells, ThoseOfC60) {
  const FixedBondGraph graph = fixed_bond_graph(structures::fullerene(1, 1));
  std::vector<AtomIndex> atoms = {17};
  std::vector<bool> taken(60, false);
  taken[17] = true;
  std::size_t shell = 0;
  std::vector<std::size_t> sizes;
  for (int k = 0; k < 10; ++k) {
    const std::size_t before = atoms.size();
    add_bond_shell(graph, atoms, shell, FirstTime(taken));
    EXPECT_EQ(shell, before);
    sizes.push_back(atoms.size() - before);
  }
  EXPECT_THAT(sizes, testing::ElementsAre(3, 6, 8, 10, 10, 10, 8, 3, 1, 0));
  EXPECT_EQ(atoms.size(), 60u);
}

// A patch of C60: what is within three bonds of an atom.
TEST(BondShells, APartHasTheBondsWithinIt) {
  const FixedBondGraph whole = fixed_bond_graph(structures::fullerene(1, 1));
  std::vector<AtomIndex> atoms = {42};
  std::vector<bool> taken(60, false);
  taken[42] = true;
  std::size_t shell = 0;
  for (int k = 0; k < 3; ++k) add_bond_shell(whole, atoms, shell, FirstTime(taken));
  std::vector<AtomIndex> number(60, no_atom);
  const FixedBondGraph part = part_of(whole, atoms, 10, number);
  ASSERT_EQ(part.neighbours.size(), atoms.size());
  EXPECT_EQ(part.inner, 10u);
  for (AtomIndex k = 0; k < atoms.size(); ++k) {
    EXPECT_EQ(number[atoms[k]], k);
    for (int s = 0; s < 3; ++s) {
      const AtomIndex there = whole.neighbours[atoms[k]][s], here = part.neighbours[k][s];
      if (here == no_atom)
        EXPECT_FALSE(taken[there]);
      else
        EXPECT_EQ(atoms[here], there);
    }
  }
}

}  // namespace
}  // namespace nanocarbon::annealing
