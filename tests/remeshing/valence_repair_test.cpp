#include "nanocarbon/remeshing/valence_repair.h"

#include <gtest/gtest.h>

#include <random>

#include "nanocarbon/remeshing/edge_lengths.h"
#include "nanocarbon/remeshing/valence_optimiser.h"
#include "remeshing/shapes.h"
#include "remeshing/topology.h"

namespace nanocarbon {
namespace {

// Flips that fold nothing, in random places.
Triangulation disordered(const TriangleMesh& mesh, int flips, unsigned seed) {
  Triangulation result = to_triangulation(mesh);
  std::mt19937_64 random(seed);
  for (int k = 0; k < flips; ++k)
    flip_edge(result, EdgeHandle(static_cast<int>(random() % result.n_edges())), {});
  return result;
}

// Algorithm 4 stops where no single flip lowers the error, and leaves an 8 or a 4 here and there.
TEST(ValenceRepair, BringsValencesInto5To7WhereSingleFlipsCannot) {
  const TriangleMesh torus = test::torus(3.0, 1.0, 60, 20);
  std::size_t left_by_single_flips = 0;
  for (const unsigned seed : {1u, 2u, 3u, 4u, 5u, 6u}) {
    Triangulation mesh = disordered(torus, 2000, seed);
    optimise_valences(mesh, {});
    left_by_single_flips += count_valences(mesh).outside_5_to_7();
    const ValenceRepair repair = repair_valences(mesh);
    EXPECT_EQ(repair.left, 0u);
    EXPECT_EQ(count_valences(mesh).outside_5_to_7(), 0u);
    const TriangleMesh result = to_triangle_mesh(mesh);
    EXPECT_EQ(test::topology_of(result), test::topology_of(torus));
    EXPECT_EQ(result.points, torus.points);
  }
  EXPECT_GT(left_by_single_flips, 0u);
}

TEST(ValenceRepair, LeavesWhatIsRightAlone) {
  Triangulation mesh = to_triangulation(test::torus(3.0, 1.0, 24, 12));
  EXPECT_EQ(repair_valences(mesh).flips, 0u);
  EXPECT_EQ(count_valences(mesh).inner[6], 288u);
}

}  // namespace
}  // namespace nanocarbon
