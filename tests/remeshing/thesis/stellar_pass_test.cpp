// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/thesis/stellar_pass.h"

#include <gmock/gmock.h>

#include "nanocarbon/remeshing/thesis/edge_lengths.h"
#include "remeshing/shapes.h"
#include "remeshing/topology.h"

namespace nanocarbon::thesis {
namespace {

StellarOptions options_for(LengthInterval interval) {
  StellarOptions options;
  options.interval = interval;
  options.target_length = interval.mean();
  return options;
}

TEST(StellarPriorityList, HoldsTheEdgesOutsideLargestDeviationFirst) {
  const Triangulation mesh = to_triangulation(test::torus(3.0, 1.0, 12, 7));
  const double mean = mean_edge_length(mesh);
  const LengthInterval interval{0.7 * mean, 1.3 * mean};
  const std::vector<EdgeHandle> list = stellar_priority_list(mesh, interval, mean);
  EXPECT_EQ(list.size(), count_edges(mesh, interval).outside());
  ASSERT_GT(list.size(), 10u);
  const auto deviation = [&](EdgeHandle e) { return std::abs(edge_length(mesh, e) - mean); };
  for (std::size_t i = 0; i < list.size(); ++i) {
    EXPECT_FALSE(interval.contains(edge_length(mesh, list[i])));
    EXPECT_GE(deviation(list[i > 0 ? i - 1 : 0]), deviation(list[i]));
  }
}

TEST(StellarPass, LeavesAMeshAloneWhoseEdgesAreAllInside) {
  Triangulation mesh = to_triangulation(test::icosahedron(1.0));
  const double edge = edge_length(mesh, EdgeHandle(0));
  const StellarTotals totals = stellar_pass(mesh, options_for({0.9 * edge, 1.1 * edge}));
  EXPECT_EQ(totals.candidates + totals.collapses + totals.splits, 0u);
  EXPECT_EQ(mesh.n_faces(), 20u);
}

// Each split touches two vertices that no other may touch: of the 12 vertices of an icosahedron at most 6
// pairs.
TEST(StellarPass, TouchesEveryVertexAtMostOnce) {
  Triangulation mesh = to_triangulation(test::icosahedron(1.0));
  const double edge = edge_length(mesh, EdgeHandle(0));
  const StellarTotals totals = stellar_pass(mesh, options_for({0.1 * edge, 0.5 * edge}));
  EXPECT_EQ(totals.candidates, 30u);
  EXPECT_LE(totals.splits, 6u);
  EXPECT_GE(totals.splits, 4u);  // no maximal matching of the icosahedron's edges is smaller
  EXPECT_EQ(mesh.n_vertices(), 12 + totals.splits);
}

// With the printed test every edge that still has an untouched end is split: all vertices end up touched.
TEST(StellarPass, TouchesEveryVertexWithTheMarksAsPrinted) {
  Triangulation mesh = to_triangulation(test::icosahedron(1.0));
  const double edge = edge_length(mesh, EdgeHandle(0));
  StellarOptions options = options_for({0.1 * edge, 0.5 * edge});
  options.marks = VisitedMarks::both_ends;
  const StellarTotals totals = stellar_pass(mesh, options);
  EXPECT_GE(totals.splits, 6u);
  EXPECT_LE(totals.splits, 11u);
}

TEST(StellarPass, CountsWhatItDid) {
  const TriangleMesh shape = test::torus(3.0, 1.0, 24, 12);
  Triangulation mesh = to_triangulation(shape);
  const double mean = mean_edge_length(mesh);
  const StellarTotals totals = stellar_pass(mesh, options_for({0.8 * mean, 1.2 * mean}));
  EXPECT_GT(totals.collapses, 0u);
  EXPECT_GT(totals.splits, 0u);
  EXPECT_EQ(mesh.n_vertices(), shape.points.size() - totals.collapses + totals.splits);
  EXPECT_EQ(mesh.n_faces(), shape.triangles.size() - 2 * totals.collapses + 2 * totals.splits);
  EXPECT_EQ(test::topology_of(to_triangle_mesh(mesh)), test::topology_of(shape));
}

TEST(StellarPass, SplitsAtTheMiddleWhereAskedTo) {
  // A sheet of two triangles: only its diagonal is long.
  Triangulation mesh = to_triangulation(test::sheet(1.0, 1.0, 1, 1));
  StellarOptions options = options_for({0.5, 1.2});
  options.position = StellarPosition::midpoint;
  EXPECT_EQ(stellar_pass(mesh, options).splits, 1u);
  EXPECT_TRUE(mesh.point(VertexHandle(4)).isApprox(Vec3(0.5, 0.5, 0.0)));
}

TEST(StellarPass, KeepsBoundaryVerticesInTheirPlaces) {
  const TriangleMesh shape = test::sheet(4.0, 4.0, 8, 8);
  Triangulation mesh = to_triangulation(shape);
  // Everything is short; what remains of the boundary must lie on the square's sides.
  EXPECT_GT(stellar_pass(mesh, options_for({1.0, 3.0})).collapses, 0u);
  for (const VertexHandle v : mesh.vertices()) {
    if (!mesh.is_boundary(v)) continue;
    const Vec3& p = mesh.point(v);
    const double to_side = std::min({p.x(), p.y(), 4.0 - p.x(), 4.0 - p.y()});
    EXPECT_GE(to_side, -1e-12);
    EXPECT_LE(to_side, 0.25 + 1e-12);  // a corner is cut by at most half of one edge
  }
}

}  // namespace
}  // namespace nanocarbon::thesis
