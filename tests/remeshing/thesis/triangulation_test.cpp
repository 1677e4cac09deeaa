// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/thesis/triangulation.h"

#include <gmock/gmock.h>

#include "nanocarbon/core/error.h"
#include "nanocarbon/remeshing/thesis/stellar_operations.h"
#include "remeshing/shapes.h"
#include "remeshing/topology.h"

namespace nanocarbon::thesis {
namespace {

TEST(Triangulation, GivesBackTheMeshItWasMadeOf) {
  for (const TriangleMesh& shape :
       {test::icosahedron(1.0), test::torus(3.0, 1.0, 12, 6), test::open_tube(1, 3, 8, 4)}) {
    const TriangleMesh back = to_triangle_mesh(to_triangulation(shape));
    EXPECT_EQ(back.points, shape.points);
    ASSERT_EQ(back.triangles.size(), shape.triangles.size());
    for (std::size_t t = 0; t < back.triangles.size(); ++t) {
      Triangle turned = back.triangles[t];
      while (turned[0] != shape.triangles[t][0])
        std::rotate(turned.begin(), turned.begin() + 1, turned.end());
      EXPECT_EQ(turned, shape.triangles[t]);
    }
  }
}

TEST(Triangulation, LeavesDeletedElementsOutAndCompactRemovesThem) {
  Triangulation mesh = to_triangulation(test::sphere(1.0, 2));
  const std::size_t faces = mesh.n_faces(), vertices = mesh.n_vertices();
  const EdgeHandle edge(17);
  const HalfedgeHandle h = mesh.halfedge_handle(edge, 0);
  const Vec3 middle = 0.5 * (mesh.point(mesh.from_vertex_handle(h)) + mesh.point(mesh.to_vertex_handle(h)));
  ASSERT_TRUE(collapse_edge(mesh, edge, middle, {}));
  EXPECT_EQ(to_triangle_mesh(mesh).triangles.size(), faces - 2);
  EXPECT_EQ(to_triangle_mesh(mesh).points.size(), vertices - 1);
  EXPECT_EQ(mesh.n_faces(), faces);
  compact(mesh);
  EXPECT_EQ(mesh.n_faces(), faces - 2);
  EXPECT_EQ(mesh.n_vertices(), vertices - 1);
  EXPECT_EQ(test::topology_of(to_triangle_mesh(mesh)), test::topology_of(test::sphere(1.0, 2)));
}

TEST(Triangulation, RefusesWhatIsNoOrientedManifold) {
  const std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1},
                                    {1, 1, 1}, {2, 2, 1}, {3, 2, 1}};
  const std::vector<TriangleMesh> wrong = {
      {points, {{0, 1, 2}, {0, 1, 3}}},             // the same direction twice
      {points, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}},  // three triangles at an edge
      {points, {{0, 1, 1}}},                        // a vertex twice
      {points, {{0, 1, 9}}},                        // no such vertex
      // A closed fan around vertex 0, touched by one more triangle.
      {points, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {0, 4, 5}}},
  };
  for (const TriangleMesh& mesh : wrong) EXPECT_THROW(to_triangulation(mesh), UserError);
}

}  // namespace
}  // namespace nanocarbon::thesis
