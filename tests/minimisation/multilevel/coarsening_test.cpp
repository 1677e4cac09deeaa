// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/minimisation/multilevel/coarsening.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "nanocarbon/structures/fullerene.h"

namespace nanocarbon::multilevel {
namespace {

NodeGraph bonds_of_c2160() {
  const Molecule molecule = structures::fullerene(6, 6);
  return bonded_atoms(molecule.size(), molecule.bonds);
}

// Steps from one node to all others.
std::vector<unsigned> steps_from(const NodeGraph& graph, std::uint32_t start) {
  std::vector<unsigned> steps(graph.size(), std::numeric_limits<unsigned>::max());
  std::vector<std::uint32_t> reached = {start};
  steps[start] = 0;
  for (std::size_t k = 0; k < reached.size(); ++k)
    for (const std::uint32_t n : graph.of(reached[k]))
      if (steps[n] == std::numeric_limits<unsigned>::max()) {
        steps[n] = steps[reached[k]] + 1;
        reached.push_back(n);
      }
  return steps;
}

TEST(Coarsen, ChosenNodesKeepTheirDistanceAndAreNearEveryNode) {
  const NodeGraph graph = bonds_of_c2160();
  const Coarsening coarsening = coarsen(graph, 4);
  std::vector<unsigned> nearest(graph.size(), std::numeric_limits<unsigned>::max());
  for (std::uint32_t c = 0; c < coarsening.chosen.size(); ++c) {
    const std::vector<unsigned> steps = steps_from(graph, coarsening.chosen[c]);
    for (const std::uint32_t other : coarsening.chosen)
      EXPECT_TRUE(other == coarsening.chosen[c] || steps[other] >= 4);
    for (std::size_t i = 0; i < graph.size(); ++i) nearest[i] = std::min(nearest[i], steps[i]);
  }
  for (std::uint32_t i = 0; i < graph.size(); ++i) {
    EXPECT_LT(nearest[i], 4u);
    EXPECT_EQ(steps_from(graph, i)[coarsening.chosen[coarsening.owner[i]]], nearest[i]);
  }
}

TEST(Coarsen, ComponentsStayApart) {
  const NodeGraph chains =
      graph_of_pairs(9, std::vector<std::pair<std::uint32_t, std::uint32_t>>{{0, 1}, {1, 2}, {3, 4}, {4, 5}});
  const Coarsening coarsening = coarsen(chains, 4);
  EXPECT_EQ(coarsening.chosen.size(), 5u);  // two chains and three nodes on their own
  EXPECT_TRUE(coarsening.graph.nodes.empty());
}

TEST(CompactOrder, IsAPermutationThatKeepsNeighboursTogether) {
  const NodeGraph graph = bonds_of_c2160();
  std::vector<std::uint32_t> order = compact_order(graph);
  const NodeGraph compact = renumbered(graph, order);
  // A stretch of 108 of a sheet's atoms that is as round as can be has a rim of about 26 bonds; these
  // have somewhat rough ones.
  std::size_t leaving = 0;
  for (std::uint32_t i = 0; i < 2160; ++i)
    for (const std::uint32_t n : compact.of(i)) leaving += n / 108 != i / 108;
  EXPECT_LT(leaving, 1.5 * 20 * 26 * 2);
  std::sort(order.begin(), order.end());
  for (std::uint32_t i = 0; i < order.size(); ++i) EXPECT_EQ(order[i], i);
}

}  // namespace
}  // namespace nanocarbon::multilevel
