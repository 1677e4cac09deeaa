#include "nanocarbon/molecule/surface_topology.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numeric>

#include "molecule/shapes.h"
#include "nanocarbon/molecule/bond_graph.h"
#include "nanocarbon/molecule/dual.h"

namespace nanocarbon {
namespace {

SurfaceTopology topology(const Molecule& molecule, const TopologyOptions& options = {}) {
  return surface_topology(embedded_graph(molecule), options);
}

Molecule c60() { return dual(test::scaled_to_carbon(test::sqrt3_subdivided_sphere(test::icosahedron()))); }

void expect_piece(const SurfaceTopology& s, bool orientable, int genus, int boundary_loops) {
  ASSERT_FALSE(s.problem) << s.problem->reason;
  ASSERT_EQ(s.pieces.size(), 1u);
  EXPECT_TRUE(s.pieces[0].has_rings);
  EXPECT_EQ(s.pieces[0].orientable, orientable);
  EXPECT_EQ(s.pieces[0].genus, genus);
  EXPECT_EQ(s.pieces[0].boundary_loops, boundary_loops);
}

TEST(SurfaceTopology, OfC60) {
  const SurfaceTopology s = topology(c60());
  expect_piece(s, true, 0, 0);
  EXPECT_EQ(s.euler_characteristic, 2);
  EXPECT_EQ(s.ring_counts[5], 12u);
  EXPECT_EQ(s.ring_counts[6], 20u);
  EXPECT_EQ(std::accumulate(s.ring_counts.begin(), s.ring_counts.end(), 0u), 32u);
  EXPECT_THAT(s.coordination, testing::Each(3));
  EXPECT_THAT(s.smallest_ring, testing::Each(5));
}

TEST(SurfaceTopology, RingsAreThoseOfTheDual) {
  Molecule molecule = c60();
  SurfaceTopology s = topology(molecule);
  const auto sorted = [](const Rings& rings) {
    std::vector<std::vector<AtomIndex>> list;
    for (std::size_t r = 0; r < rings.size(); ++r) list.emplace_back(rings[r].begin(), rings[r].end());
    std::sort(list.begin(), list.end());
    return list;
  };
  // Also the same way round, counter-clockwise from outside.
  EXPECT_EQ(sorted(s.rings), sorted(molecule.rings));
}

TEST(SurfaceTopology, OfATorus) {
  const SurfaceTopology s = topology(dual(test::scaled_to_carbon(test::torus(16, 40, 3.0, 1.0))));
  expect_piece(s, true, 1, 0);
  EXPECT_EQ(s.euler_characteristic, 0);
  EXPECT_EQ(s.ring_counts[6], 640u);
}

TEST(SurfaceTopology, OfAnOpenTube) {
  const SurfaceTopology s = topology(dual(test::scaled_to_carbon(test::cylinder(10, 12))));
  expect_piece(s, true, 0, 2);
  EXPECT_EQ(s.euler_characteristic, 0);
}

TEST(SurfaceTopology, OfASheetWithTwoHoles) {
  const TriangleMesh sheet = test::sheet(14, 8);
  const auto at = [](int i, int j) { return static_cast<VertexIndex>(i + 15 * j); };
  const TriangleMesh holes = test::without_vertices(sheet, {at(4, 4), at(5, 4), at(10, 4), at(10, 3)});
  const SurfaceTopology s = topology(dual(test::scaled_to_carbon(holes)));
  expect_piece(s, true, 0, 3);
  EXPECT_EQ(s.euler_characteristic, -1);
}

}  // namespace
}  // namespace nanocarbon
