// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/topology/short_cycles.h"

#include <gmock/gmock.h>

#include "molecule/cases.h"
#include "nanocarbon/molecule/molecule_graph.h"
#include "nanocarbon/structures/graphene.h"

namespace nanocarbon::topology {
namespace {

bool first_bond_is_on_cycle(const Molecule& molecule, int most, std::vector<std::uint32_t> without = {}) {
  const EmbeddedGraph graph = molecule::embedded_graph(molecule);
  const Skeleton skeleton = find_skeleton(graph);
  std::vector<std::uint8_t> excluded(graph.ends.size(), 0);
  for (const std::uint32_t h : without) excluded[h] = excluded[skeleton.twin[h]] = 1;
  return is_on_short_cycle(graph, skeleton, 0, graph.offsets[0], most, excluded);
}

TEST(ShortCycles, AHexagonHasSixBonds) {
  const Molecule ring = structures::graphene_flake(1.5);
  EXPECT_TRUE(first_bond_is_on_cycle(ring, 6));
  EXPECT_FALSE(first_bond_is_on_cycle(ring, 5));
  EXPECT_FALSE(first_bond_is_on_cycle(ring, 12, {1}));  // the other bond of atom 0
}

TEST(ShortCycles, OfGrapheneAreAroundRingsInSmallCellsToo) {
  for (const Molecule& sheet :
       {structures::graphene(1, 1), structures::graphene(2, 1), structures::graphene(6, 4)}) {
    EXPECT_TRUE(first_bond_is_on_cycle(sheet, 6));
    EXPECT_FALSE(first_bond_is_on_cycle(sheet, 5));
  }
}

TEST(ShortCycles, DoNotCloseThroughTheBoundary) {
  Molecule chain;
  chain.positions = {Vec3(0, 0, 0), Vec3(1.4, 0, 0)};
  chain.elements.assign(2, Element::carbon);
  chain.cell = orthogonal_cell(Vec3(2.8, 20, 20), {true, false, false});
  EXPECT_FALSE(first_bond_is_on_cycle(test::with_bonds_by_distance(chain), 12));
}

}  // namespace
}  // namespace nanocarbon::topology
