#include "nanocarbon/remeshing/thesis_recipe.h"

#include <gmock/gmock.h>

#include "nanocarbon/core/error.h"
#include "remeshing/shapes.h"
#include "remeshing/topology.h"

namespace nanocarbon {
namespace {

ThesisResult remeshed(const TriangleMesh& surface, std::size_t atoms, ThesisOptions options = {}) {
  return remesh_by_thesis(test::sized(surface, static_cast<double>(atoms)), options);
}

TEST(ThesisRecipe, KeepsTheTopologyOfShapesFinerAndCoarserThanTheTarget) {
  ThesisOptions options;
  options.iterations = 30;
  const std::vector<TriangleMesh> shapes = {test::sphere(1.0, 3), test::torus(3.0, 1.0, 60, 20),
                                            test::open_tube(1.0, 6.0, 20, 20), test::sheet(3.0, 2.0, 15, 10)};
  for (const TriangleMesh& shape : shapes) {
    const test::Topology before = test::topology_of(shape);
    ASSERT_TRUE(before.manifold);
    for (const std::size_t atoms :
         {shape.triangles.size() / 5, shape.triangles.size(), 5 * shape.triangles.size()}) {
      const ThesisResult result = remeshed(shape, atoms, options);
      EXPECT_EQ(test::topology_of(result.mesh), before) << atoms << " atoms";
      for (const Vec3& p : result.mesh.points) ASSERT_TRUE(p.allFinite());
    }
  }
}

TEST(ThesisRecipe, RefusesASurfaceWithAnInfinitePoint) {
  TriangleMesh shape = test::icosahedron(1.0);
  shape.points[4].x() = std::numeric_limits<double>::infinity();
  EXPECT_THROW(remesh_by_thesis(shape, {}), UserError);
}

}  // namespace
}  // namespace nanocarbon
