// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/thesis/valence_optimiser.h"

#include <gmock/gmock.h>

#include <random>

#include "nanocarbon/remeshing/thesis/edge_lengths.h"
#include "remeshing/shapes.h"
#include "remeshing/topology.h"

namespace nanocarbon::thesis {
namespace {

StellarLimits any_geometry() {
  StellarLimits limits;
  limits.min_normal_cosine = -2.0;
  return limits;
}

void flip_at_random(Triangulation& mesh, int flips, unsigned seed) {
  std::mt19937_64 random(seed);
  for (int done = 0; done < flips;)
    done += static_cast<bool>(
        flip_edge(mesh, EdgeHandle(static_cast<int>(random() % mesh.n_edges())), any_geometry()));
}

int square_error(const Triangulation& mesh) {
  int sum = 0;
  for (const VertexHandle v : mesh.vertices()) {
    const int d = static_cast<int>(mesh.valence(v)) - (mesh.is_boundary(v) ? 4 : 6);
    sum += d * d;
  }
  return sum;
}

TEST(ValenceOptimiser, LeavesARegularTorusAlone) {
  Triangulation mesh = to_triangulation(test::torus(3.0, 1.0, 20, 10));
  const ValenceTotals totals = optimise_valences(mesh, {});
  EXPECT_EQ(totals.flips, 0u);
  EXPECT_EQ(totals.passes, 1u);
  EXPECT_EQ(count_valences(mesh).inner[6], 200u);
}

TEST(ValenceOptimiser, UndoesASingleFlip) {
  Triangulation mesh = to_triangulation(test::torus(3.0, 1.0, 20, 10));
  ASSERT_TRUE(flip_edge(mesh, EdgeHandle(77), any_geometry()));
  EXPECT_EQ(count_valences(mesh).inner[6], 196u);
  EXPECT_EQ(optimise_valences(mesh, {ValenceError::quadratic, true, any_geometry()}).flips, 1u);
  EXPECT_EQ(count_valences(mesh).inner[6], 200u);
}

// Euler: the sum of (6 - valence) over a closed triangulation is six times its characteristic, whatever is
// flipped.
TEST(ValenceOptimiser, LowersTheErrorAndKeepsEulersSum) {
  for (const ValenceError error : {ValenceError::linear, ValenceError::quadratic}) {
    Triangulation mesh = to_triangulation(test::sphere(1.0, 3));
    flip_at_random(mesh, 500, 3);
    const int before = square_error(mesh);
    const ValenceTotals totals = optimise_valences(mesh, {error, true, any_geometry()});
    EXPECT_GT(totals.flips, 100u);
    EXPECT_LT(square_error(mesh), before / 4);
    int sum = 0;
    for (const VertexHandle v : mesh.vertices()) sum += 6 - static_cast<int>(mesh.valence(v));
    EXPECT_EQ(sum, 12);
    EXPECT_EQ(test::topology_of(to_triangle_mesh(mesh)), test::topology_of(test::sphere(1.0, 3)));
  }
}

// Ended means: no flip is left that lowers the quadratic error. Equal ones are, and must not be taken for
// ever.
TEST(ValenceOptimiser, EndsWhereNoFlipImproves) {
  Triangulation mesh = to_triangulation(test::torus(3.0, 1.0, 24, 12));
  flip_at_random(mesh, 300, 9);
  const ValenceOptions options{ValenceError::quadratic, true, any_geometry()};
  optimise_valences(mesh, options);
  const int reached = square_error(mesh);
  for (int e = 0; e < static_cast<int>(mesh.n_edges()); ++e) {
    Triangulation tried = mesh;
    flip_edge(tried, EdgeHandle(e), any_geometry());
    EXPECT_GE(square_error(tried), reached);
  }
  EXPECT_EQ(optimise_valences(mesh, options).flips, 0u);
}

TEST(ValenceOptimiser, OnePassIsOnePass) {
  Triangulation mesh = to_triangulation(test::sphere(1.0, 3));
  flip_at_random(mesh, 500, 3);
  EXPECT_EQ(optimise_valences(mesh, {ValenceError::linear, false, any_geometry()}).passes, 1u);
}

TEST(ValenceOptimiser, BoundariesAimAtFour) {
  Triangulation mesh = to_triangulation(test::equilateral_sheet(1.0, 8, 8));
  EXPECT_EQ(optimise_valences(mesh, {ValenceError::quadratic, true, any_geometry()}).flips, 0u);
}

}  // namespace
}  // namespace nanocarbon::thesis
