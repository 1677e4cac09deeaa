// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/thesis/thesis_recipe.h"

#include <gmock/gmock.h>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/measures.h"
#include "remeshing/shapes.h"
#include "remeshing/topology.h"
#include "support/small_meshes.h"

namespace nanocarbon::thesis {
namespace {

ThesisResult remeshed(const TriangleMesh& surface, std::size_t triangles, ThesisOptions options = {}) {
  return remesh_by_thesis(test::sized(surface, static_cast<double>(triangles)), options);
}

TEST(ThesisRecipe, KeepsTheTopologyOfShapesFinerAndCoarserThanTheTarget) {
  ThesisOptions options;
  options.iterations = 15;
  const std::vector<TriangleMesh> shapes = {
      test::sphere(1.0, 3), test::torus(3.0, 1.0, 60, 20), test::open_tube(1.0, 6.0, 20, 20),
      test::sheet(3.0, 2.0, 15, 10), test::together(test::sphere(1.0, 2), test::torus(3.0, 1.0, 30, 10))};
  for (const TriangleMesh& shape : shapes) {
    const test::Topology before = test::topology_of(shape);
    ASSERT_TRUE(before.manifold);
    for (const std::size_t triangles : {shape.triangles.size() / 100, shape.triangles.size() / 5,
                                        shape.triangles.size(), 5 * shape.triangles.size()}) {
      const ThesisResult result = remeshed(shape, triangles, options);
      EXPECT_EQ(test::topology_of(result.mesh), before) << triangles << " triangles";
      for (const Vec3& p : result.mesh.points) ASSERT_TRUE(p.allFinite());
    }
  }
}

// Five to eight vertices, all of them within two rings of each other.
TEST(ThesisRecipe, KeepsTheSizeOfShapesWithAHandfulOfVertices) {
  TriangleMesh bipyramid;
  bipyramid.points = {{1, 0, 0}, {-0.5, 0.866, 0}, {-0.5, -0.866, 0}, {0, 0, 1}, {0, 0, -1}};
  bipyramid.triangles = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}};
  for (const TriangleMesh& shape : {bipyramid, test::tetrahedron(), test::icosahedron(1.0)}) {
    ThesisOptions options;
    options.projection_interval = 0;
    const ThesisResult result = remeshed(shape, 1000, options);
    const TriangleMesh surface = test::sized(shape, 1000);
    EXPECT_EQ(test::topology_of(result.mesh), test::topology_of(shape));
    // Chords cut off the tetrahedron's sharp edges and corners; an edge of it is eighteen target edges long.
    EXPECT_NEAR(static_cast<double>(result.mesh.triangles.size()), 1000.0, 200.0);
    EXPECT_GT(mesh::area(result.mesh), 0.8 * mesh::area(surface));
  }
}

TEST(ThesisRecipe, TellsWhatItDid) {
  ThesisOptions options;
  unsigned calls = 0;
  options.progress = [&](const ThesisProgress& p) {
    EXPECT_EQ(p.iteration, ++calls);
    EXPECT_EQ(p.max_iterations, 150u);
  };
  const TriangleMesh shape = test::torus(3.0, 1.0, 40, 15);
  const ThesisResult result = remeshed(shape, 1300, options);
  EXPECT_EQ(calls, result.record.iterations);
  EXPECT_EQ(result.record.history.size(), result.record.iterations + 1);
  EXPECT_EQ(result.record.low_pass_iterations + result.record.local_iterations, result.record.iterations);
  EXPECT_EQ(result.record.projection_replacements, (result.record.iterations - 1) / 10);
  EXPECT_EQ(result.mesh.triangles.size(),
            shape.triangles.size() + 2 * result.record.stellar.splits - 2 * result.record.stellar.collapses);
  EXPECT_EQ(result.record.edges.edges, result.mesh.triangles.size() * 3 / 2);
  EXPECT_EQ(result.scale, 1.0);
}

TEST(ThesisRecipe, EveryRunGivesTheSameBits) {
  const TriangleMesh shape = test::torus(3.0, 1.0, 30, 12);
  const ThesisResult first = remeshed(shape, 3000), second = remeshed(shape, 3000);
  EXPECT_EQ(first.mesh.points, second.mesh.points);
  EXPECT_EQ(first.mesh.triangles, second.mesh.triangles);
}

// With the projection mesh never replaced all points stay on the surface as given: on a sheet, in its plane.
TEST(ThesisRecipe, StaysOnTheSurfaceWhereTheProjectionMeshIsNeverReplaced) {
  ThesisOptions options;
  options.projection_interval = 0;
  options.iterations = 20;
  options.post_processing = PostProcessing::none;
  const ThesisResult result = remeshed(test::sheet(1.0, 1.0, 20, 20), 1600, options);
  EXPECT_GT(result.record.stellar.splits + result.record.stellar.collapses, 0u);
  EXPECT_EQ(result.record.projection_replacements, 0u);
  for (const Vec3& p : result.mesh.points) EXPECT_NEAR(p.z(), 0.0, 1e-9);
}

// Points in one place, on one line, or too far apart for their squares: no crash, no NaN, no loop without
// end.
TEST(ThesisRecipe, SurvivesDegenerateGeometry) {
  ThesisOptions options;
  options.iterations = 5;
  TriangleMesh collapsed = test::torus(3.0, 1.0, 12, 6), flat = collapsed, needle = collapsed;
  for (Vec3& p : collapsed.points) p = Vec3(1, 2, 3);
  for (Vec3& p : flat.points) p = Vec3(p.x(), 0.0, 0.0);
  for (Vec3& p : needle.points) p.x() *= 1e-7;
  for (const TriangleMesh& shape : {collapsed, flat, needle}) {
    const ThesisResult result = remesh_by_thesis(shape, options);
    EXPECT_EQ(test::topology_of(result.mesh), test::topology_of(shape));
    for (const Vec3& p : result.mesh.points) EXPECT_TRUE(p.allFinite());
  }
}

TEST(ThesisRecipe, RefusesASurfaceWithAnInfinitePoint) {
  TriangleMesh shape = test::icosahedron(1.0);
  shape.points[4].x() = std::numeric_limits<double>::infinity();
  EXPECT_THROW(remesh_by_thesis(shape, {}), UserError);
}

}  // namespace
}  // namespace nanocarbon::thesis
