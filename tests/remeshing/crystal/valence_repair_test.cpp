// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/crystal/valence_repair.h"

#include <gtest/gtest.h>

#include <random>

#include "nanocarbon/remeshing/thesis/edge_lengths.h"
#include "nanocarbon/remeshing/thesis/valence_optimiser.h"
#include "remeshing/shapes.h"
#include "remeshing/topology.h"

namespace nanocarbon::crystal {
namespace {

// Flips that fold nothing, in random places.
thesis::Triangulation disordered(const TriangleMesh& mesh, int flips, unsigned seed) {
  thesis::Triangulation result = thesis::to_triangulation(mesh);
  std::mt19937_64 random(seed);
  for (int k = 0; k < flips; ++k)
    thesis::flip_edge(result, thesis::EdgeHandle(static_cast<int>(random() % result.n_edges())), {});
  return result;
}

// Algorithm 4 stops where no single flip lowers the error, and leaves an 8 or a 4 here and there.
TEST(ValenceRepair, BringsValencesInto5To7WhereSingleFlipsCannot) {
  const TriangleMesh torus = test::torus(3.0, 1.0, 60, 20);
  std::size_t left_by_single_flips = 0;
  for (const unsigned seed : {1u, 2u, 3u, 4u, 5u, 6u}) {
    thesis::Triangulation mesh = disordered(torus, 2000, seed);
    thesis::optimise_valences(mesh, {});
    left_by_single_flips += thesis::count_valences(mesh).outside_5_to_7();
    const ValenceRepair repair = thesis::repair_valences(mesh);
    EXPECT_EQ(repair.left, 0u);
    EXPECT_EQ(thesis::count_valences(mesh).outside_5_to_7(), 0u);
    const TriangleMesh result = thesis::to_triangle_mesh(mesh);
    EXPECT_EQ(test::topology_of(result), test::topology_of(torus));
    EXPECT_EQ(result.points, torus.points);
  }
  EXPECT_GT(left_by_single_flips, 0u);
}

TEST(ValenceRepair, LeavesWhatIsRightAlone) {
  thesis::Triangulation mesh = thesis::to_triangulation(test::torus(3.0, 1.0, 24, 12));
  EXPECT_EQ(thesis::repair_valences(mesh).flips, 0u);
  EXPECT_EQ(thesis::count_valences(mesh).inner[6], 288u);
}

}  // namespace
}  // namespace nanocarbon::crystal
