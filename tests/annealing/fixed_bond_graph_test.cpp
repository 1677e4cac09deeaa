// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/fixed_bond_graph.h"

#include <gmock/gmock.h>

#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/topology/bond_shells.h"

namespace nanocarbon::annealing {
namespace {

// A patch of C60: what is within three bonds of an atom.
TEST(FixedBondGraph, APartHasTheBondsWithinIt) {
  const FixedBondGraph whole = fixed_bond_graph(structures::fullerene(1, 1));
  std::vector<AtomIndex> atoms = {42};
  std::vector<bool> taken(60, false);
  taken[42] = true;
  std::size_t shell = 0;
  for (int k = 0; k < 3; ++k) topology::add_bond_shell(whole, atoms, shell, topology::FirstTime(taken));
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
