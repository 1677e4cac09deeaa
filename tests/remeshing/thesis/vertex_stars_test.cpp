// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/thesis/vertex_stars.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <set>

#include "nanocarbon/remeshing/thesis/edge_lengths.h"
#include "remeshing/shapes.h"

namespace nanocarbon::thesis {
namespace {

VertexStars stars_of(const TriangleMesh& mesh) { return vertex_stars(to_triangulation(mesh)); }

// Consecutive neighbours and the vertex are a triangle of the mesh, wound as it is; at a boundary one
// triangle fewer.
TEST(VertexStars, NeighboursFollowTheTrianglesAround) {
  for (const TriangleMesh& mesh :
       {test::icosahedron(1.0), test::open_tube(1.0, 3.0, 7, 4), test::sheet(1, 1, 3, 3)}) {
    std::set<Triangle> triangles;
    for (Triangle t : mesh.triangles)
      for (int turn = 0; turn < 3; ++turn) {
        triangles.insert(t);
        std::rotate(t.begin(), t.begin() + 1, t.end());
      }
    const VertexStars stars = stars_of(mesh);
    std::size_t corners = 0;
    for (VertexIndex v = 0; v < stars.vertices(); ++v) {
      const auto ring = stars.of(v);
      const std::size_t faces = ring.size() - stars.on_boundary[v];
      for (std::size_t k = 0; k < faces; ++k)
        EXPECT_TRUE(triangles.contains({v, ring[k], ring[(k + 1) % ring.size()]}));
      corners += faces;
    }
    EXPECT_EQ(corners, 3 * mesh.triangles.size());
  }
}

TEST(VertexStars, NormalsPointOutOfASphere) {
  const VertexStars stars = stars_of(test::sphere(2.0, 4));
  for (std::size_t v = 0; v < stars.vertices(); ++v)
    EXPECT_GT(vertex_normal(stars, v).dot(stars.points[v].normalized()), 0.999);
}

TEST(VertexStars, APointWithoutAreaAroundItHasNoNormal) {
  TriangleMesh mesh = test::icosahedron(0.0);
  for (Vec3& p : mesh.points) p.setOnes();
  EXPECT_EQ(vertex_normal(stars_of(mesh), 0), Vec3(0, 0, 0));
}

// In a lattice of triangles the r-th ring of a vertex has 6 r vertices.
TEST(RingSearch, FindsTheRingsOfALattice) {
  const VertexStars stars = stars_of(test::torus(3.0, 1.0, 40, 30));
  RingSearch search(stars);
  for (const VertexIndex v : {0u, 617u, 617u, 1199u}) {
    const auto found = search.search({&v, 1}, 4);
    EXPECT_EQ(found.size(), 61u);
    EXPECT_EQ(found[0], v);
    for (unsigned r = 1; r <= 4; ++r) EXPECT_EQ(search.ring_begin(r + 1) - search.ring_begin(r), 6 * r);
    for (std::size_t k = 0; k < found.size(); ++k)
      EXPECT_EQ(search.place(found[k]), static_cast<std::int32_t>(k));
    std::size_t placed = 0;
    for (VertexIndex w = 0; w < stars.vertices(); ++w) placed += search.place(w) >= 0;
    EXPECT_EQ(placed, found.size());
  }
}

TEST(RingSearch, EndsWhereTheMeshEnds) {
  const VertexStars stars = stars_of(test::icosahedron(1.0));
  RingSearch search(stars);
  const VertexIndex v = 3;
  EXPECT_EQ(search.search({&v, 1}, 10).size(), 12u);  // 1, 5, 5, 1
  EXPECT_EQ(search.ring_begin(4), 12u);
}

TEST(EdgeCounts, CountsShortAndLongEdges) {
  // A unit square of two triangles: four sides of 1 and a diagonal of 1.41.
  const Triangulation mesh = to_triangulation(test::sheet(1.0, 1.0, 1, 1));
  EXPECT_EQ(count_edges(mesh, {0.9, 1.2}).too_long, 1u);
  EXPECT_EQ(count_edges(mesh, {1.1, 1.3}).too_short, 4u);
  EXPECT_EQ(count_edges(mesh, {1.1, 1.3}).outside(), 5u);
  EXPECT_DOUBLE_EQ(count_edges(mesh, {0.9, 1.2}).percent_outside(), 20.0);
  EXPECT_DOUBLE_EQ(mean_edge_length(mesh), (4.0 + std::sqrt(2.0)) / 5.0);
}

TEST(ValenceCounts, TheIcosahedronHasTwelveFives) {
  const ValenceCounts counts = count_valences(to_triangulation(test::icosahedron(1.0)));
  EXPECT_EQ(counts.inner[5], 12u);
  EXPECT_EQ(counts.outside_5_to_7(), 0u);
  EXPECT_EQ(count_valences(to_triangulation(test::sheet(1, 1, 3, 3))).boundary, 12u);
}

}  // namespace
}  // namespace nanocarbon::thesis
