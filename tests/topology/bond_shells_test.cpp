// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/topology/bond_shells.h"

#include <gmock/gmock.h>

#include "nanocarbon/structures/fullerene.h"

namespace nanocarbon::topology {
namespace {

// Atoms of C60 at 0, 1, 2, ... bonds from one: Hosoya's distance degrees.
TEST(BondShells, ThoseOfC60) {
  const Molecule c60 = structures::fullerene(1, 1);
  std::vector<std::vector<AtomIndex>> graph(60);
  for (const Bond& b : c60.bonds) {
    graph[b.first].push_back(b.second);
    graph[b.second].push_back(b.first);
  }
  const auto neighbours_of = [&](AtomIndex a) { return graph[a]; };
  std::vector<AtomIndex> atoms = {17};
  std::vector<bool> taken(60, false);
  taken[17] = true;
  std::size_t shell = 0;
  std::vector<std::size_t> sizes;
  for (int k = 0; k < 10; ++k) {
    const std::size_t before = atoms.size();
    add_bond_shell(neighbours_of, atoms, shell, FirstTime(taken));
    EXPECT_EQ(shell, before);
    sizes.push_back(atoms.size() - before);
  }
  EXPECT_THAT(sizes, testing::ElementsAre(3, 6, 8, 10, 10, 10, 8, 3, 1, 0));
  EXPECT_EQ(atoms.size(), 60u);
}

}  // namespace
}  // namespace nanocarbon::topology
