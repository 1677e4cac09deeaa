// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/topology/bridges.h"

#include <gtest/gtest.h>

#include <random>

#include "nanocarbon/molecule/molecule_graph.h"
#include "nanocarbon/topology/connected_components.h"

namespace nanocarbon::topology {
namespace {

// Atoms anywhere, with bonds between them at will: only who is bonded counts.
Molecule random_network(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Molecule molecule;
  for (int i = 0; i < 24; ++i) {
    molecule.positions.emplace_back(1.3 * i, 0.7 * (i * i % 7), 0.9 * (i * i * i % 11));
    molecule.elements.push_back(Element::carbon);
  }
  std::vector<int> degree(molecule.size(), 0);
  for (int trial = 0; trial < 40; ++trial) {
    auto a = static_cast<AtomIndex>(random() % molecule.size()),
         b = static_cast<AtomIndex>(random() % molecule.size());
    if (a > b) std::swap(a, b);
    const Bond bond{a, b, {0, 0, 0}};
    if (a == b || degree[a] == 3 || degree[b] == 3) continue;
    if (std::find(molecule.bonds.begin(), molecule.bonds.end(), bond) != molecule.bonds.end()) continue;
    ++degree[a], ++degree[b];
    molecule.bonds.push_back(bond);
  }
  std::sort(molecule.bonds.begin(), molecule.bonds.end());
  return molecule;
}

TEST(Bridges, AreTheBondsWithoutWhichThereIsOneComponentMore) {
  std::size_t bridges = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const Molecule molecule = random_network(seed);
    const EmbeddedGraph graph = molecule::embedded_graph(molecule);
    const Skeleton skeleton = find_skeleton(graph);
    ASSERT_FALSE(skeleton.problem);
    const std::vector<std::uint8_t> is_bridge = find_bridges(graph, skeleton);
    const std::uint32_t components = connected_components(molecule.size(), molecule.bonds).count;
    for (AtomIndex a = 0; a < graph.atoms(); ++a)
      for (std::uint32_t h = graph.offsets[a]; h < graph.offsets[a + 1]; ++h) {
        if (skeleton.twin[h] == Skeleton::none) {
          EXPECT_FALSE(is_bridge[h]);
          continue;
        }
        std::vector<Bond> others;
        for (const Bond& bond : molecule.bonds)
          if (std::minmax(bond.first, bond.second) != std::minmax(a, graph.ends[h])) others.push_back(bond);
        const bool parts = connected_components(molecule.size(), others).count > components;
        EXPECT_EQ(is_bridge[h] != 0, parts) << "seed " << seed << ", atoms " << a << " and " << graph.ends[h];
        bridges += parts;
      }
  }
  EXPECT_GT(bridges, 50u);
}

TEST(Bridges, TwoBondsBetweenTheSameAtomsThroughImagesAreNone) {
  Molecule molecule;
  molecule.positions = {Vec3(0, 0, 0), Vec3(1.4, 0, 0)};
  molecule.elements.assign(2, Element::carbon);
  molecule.cell = orthogonal_cell(Vec3(2.8, 20, 20), {true, false, false});
  molecule.bonds = {{0, 1, {-1, 0, 0}}, {0, 1, {0, 0, 0}}};
  const EmbeddedGraph graph = molecule::embedded_graph(molecule);
  for (const std::uint8_t bridge : find_bridges(graph, find_skeleton(graph))) EXPECT_FALSE(bridge);
}

}  // namespace
}  // namespace nanocarbon::topology
