// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/thesis/local_optimiser.h"

#include <gmock/gmock.h>

#include "nanocarbon/remeshing/thesis/edge_lengths.h"
#include "remeshing/shapes.h"

namespace nanocarbon::thesis {
namespace {

constexpr VertexIndex moved = 4 * 13 + 6;  // inside a sheet of 12 columns

//! A lattice with edges of 1 of which one inner vertex was moved, so that some of its edges are short and
//! long.
VertexStars disturbed_lattice() {
  TriangleMesh lattice = test::equilateral_sheet(1.0, 12, 12);
  lattice.points[moved] += Vec3(0.35, 0.1, 0.0);
  return vertex_stars(to_triangulation(lattice));
}

LocalOptions options_for(LengthInterval interval) {
  LocalOptions options;
  options.interval = interval;
  return options;
}

std::size_t outside(const VertexStars& stars, const LengthInterval& interval) {
  std::size_t count = 0;
  for (VertexIndex v = 0; v < stars.vertices(); ++v)
    for (const VertexIndex w : stars.of(v))
      count += v < w && !interval.contains((stars.points[v] - stars.points[w]).norm());
  return count;
}

TEST(LocalPriorityList, HoldsTheEdgesOutside) {
  const VertexStars stars = disturbed_lattice();
  const LengthInterval interval{0.8, 1.2};
  const std::vector<StarEdge> list = local_priority_list(stars, interval, 4);
  EXPECT_EQ(list.size(), outside(stars, interval));
  ASSERT_GT(list.size(), 2u);
  for (const StarEdge e : list) EXPECT_TRUE(e.a == moved || e.b == moved);
}

// Two disturbances: a vertex moved far, with many edges outside around it, and one moved a little, a long way
// off.
TEST(LocalPriorityList, PutsTheWorstNeighbourhoodFirst) {
  TriangleMesh lattice = test::equilateral_sheet(1.0, 30, 12);
  const VertexIndex mild = 6 * 31 + 4, severe = 6 * 31 + 24;
  lattice.points[mild] += Vec3(0.25, 0.0, 0.0);
  lattice.points[severe] += Vec3(0.3, 0.3, 0.0);
  lattice.points[severe + 2] += Vec3(-0.3, 0.3, 0.0);
  const VertexStars stars = vertex_stars(to_triangulation(lattice));
  const std::vector<StarEdge> list = local_priority_list(stars, {0.8, 1.2}, 4);
  bool mild_seen = false;
  std::size_t severe_edges = 0;
  for (const StarEdge e : list) {
    const bool is_mild = e.a == mild || e.b == mild;
    mild_seen |= is_mild;
    if (!is_mild) {
      EXPECT_FALSE(mild_seen) << "an edge of the worse region came after one of the better";
      ++severe_edges;
    }
  }
  EXPECT_TRUE(mild_seen);
  EXPECT_GT(severe_edges, 3u);
}

TEST(LocalOptimiser, MendsADisturbedLattice) {
  VertexStars stars = disturbed_lattice();
  const LengthInterval interval{0.8, 1.2};
  ASSERT_GT(outside(stars, interval), 0u);
  const LocalTotals totals = optimise_locally(stars, options_for(interval));
  EXPECT_GT(totals.minimised, 0u);
  EXPECT_LE(totals.minimised, totals.candidates);
  EXPECT_EQ(outside(stars, interval), 0u);
  for (const Vec3& p : stars.points) EXPECT_NEAR(p.z(), 0.0, 1e-12);
}

TEST(LocalOptimiser, DoesNothingWhereNoEdgeIsOutside) {
  VertexStars stars = vertex_stars(to_triangulation(test::equilateral_sheet(1.0, 8, 8)));
  const std::vector<Vec3> before = stars.points;
  EXPECT_EQ(optimise_locally(stars, options_for({0.8, 1.2})).candidates, 0u);
  EXPECT_EQ(stars.points, before);
}

TEST(LocalOptimiser, BoundaryVerticesAndThoseBeyondTheFourthStarStay) {
  VertexStars stars = disturbed_lattice();
  const std::vector<Vec3> before = stars.points;
  RingSearch search(stars);
  std::vector<std::uint8_t> may_move(stars.vertices(), 0);
  // The edges outside all end at the moved vertex: five rings around it hold all their fourth stars.
  const VertexIndex start = moved;
  for (const VertexIndex v : search.search({&start, 1}, 5)) may_move[v] = !stars.on_boundary[v];
  optimise_locally(stars, options_for({0.8, 1.2}));
  for (std::size_t v = 0; v < stars.vertices(); ++v)
    EXPECT_TRUE(may_move[v] || stars.points[v] == before[v]) << "vertex " << v;
}

// Freed from the tangent plane, a flat sheet squeezed between fixed boundaries can reach the length it wants
// by bulging.
TEST(LocalOptimiser, WithoutConstraintPointsMayLeaveTheSurface) {
  TriangleMesh sheet = test::equilateral_sheet(0.8, 12, 12);
  sheet.points[moved].z() += 0.05;
  const LengthInterval interval{0.9, 1.1};
  VertexStars bound = vertex_stars(to_triangulation(sheet)), free = bound;
  LocalOptions options = options_for(interval);
  optimise_locally(bound, options);
  options.tangent_plane = false;
  options.minimiser = {200, 1e-6};
  optimise_locally(free, options);
  double highest = 0.0;
  for (const Vec3& p : free.points) highest = std::max(highest, std::abs(p.z()));
  EXPECT_GT(highest, 0.2);
  EXPECT_LT(outside(free, interval), outside(bound, interval));
}

// All points in one place, or on one line: nothing to divide by, nothing that must become a NaN.
TEST(LocalOptimiser, SurvivesCoincidentPoints) {
  for (const double scale : {0.0, 1e-200}) {
    TriangleMesh torus = test::torus(3.0, 1.0, 8, 4);
    for (Vec3& p : torus.points) p *= scale;
    VertexStars stars = vertex_stars(to_triangulation(torus));
    optimise_locally(stars, options_for({0.8, 1.2}));
    for (const Vec3& p : stars.points) EXPECT_TRUE(p.allFinite());
  }
}

}  // namespace
}  // namespace nanocarbon::thesis
