// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/thesis/stellar_operations.h"

#include <gmock/gmock.h>

#include <random>

#include "remeshing/shapes.h"
#include "remeshing/topology.h"
#include "support/small_meshes.h"

namespace nanocarbon::thesis {
namespace {

EdgeHandle edge_between(const Triangulation& mesh, int a, int b) {
  return mesh.edge_handle(mesh.find_halfedge(VertexHandle(a), VertexHandle(b)));
}

Vec3 middle(const Triangulation& mesh, EdgeHandle e) {
  const HalfedgeHandle h = mesh.halfedge_handle(e, 0);
  return 0.5 * (mesh.point(mesh.from_vertex_handle(h)) + mesh.point(mesh.to_vertex_handle(h)));
}

// Any order of operations that the wrapper lets pass must keep the surface a manifold of its topology.
TEST(StellarOperations, AnySequenceKeepsTheTopology) {
  const std::vector<TriangleMesh> shapes = {test::tetrahedron(), test::icosahedron(1.0),
                                            test::torus(3.0, 1.0, 9, 5), test::open_tube(1.0, 2.0, 6, 3),
                                            test::sheet(2.0, 2.0, 3, 3)};
  StellarLimits any_geometry;
  any_geometry.min_normal_cosine = -2.0;
  for (const TriangleMesh& shape : shapes) {
    const test::Topology before = test::topology_of(shape);
    ASSERT_TRUE(before.manifold);
    Triangulation mesh = to_triangulation(shape);
    std::mt19937_64 random(5);
    std::array<int, 3> done{};
    for (int step = 0; step < 3000; ++step) {
      const EdgeHandle e(static_cast<int>(random() % mesh.n_edges()));
      const int kind = static_cast<int>(random() % 3);
      // Collapses are tried more often than splits, so that the mesh comes down to the least it can be.
      bool happened = false;
      if (kind == 0 && random() % 4 == 0)
        happened = static_cast<bool>(split_edge(mesh, e, middle(mesh, e)));
      else if (kind == 1)
        happened = static_cast<bool>(flip_edge(mesh, e, any_geometry));
      else if (kind == 2)
        happened = static_cast<bool>(collapse_edge(mesh, e, middle(mesh, e), any_geometry));
      done[static_cast<std::size_t>(kind)] += happened;
      if (step % 100 == 99) {
        ASSERT_EQ(test::topology_of(to_triangle_mesh(mesh)), before) << "step " << step;
        compact(mesh);
      }
    }
    for (const int count : done) EXPECT_GT(count, 0);
  }
}

// OpenMesh's own is_collapse_ok() lets this one pass, and leaves two triangles back to back.
TEST(StellarOperations, ATetrahedronIsNotCollapsed) {
  Triangulation mesh = to_triangulation(test::tetrahedron());
  StellarLimits no_bounds;
  no_bounds.min_valence = 0;
  no_bounds.min_normal_cosine = -2.0;
  for (int e = 0; e < 6; ++e)
    EXPECT_EQ(collapse_edge(mesh, EdgeHandle(e), middle(mesh, EdgeHandle(e)), no_bounds).refusal,
              Refusal::link_condition);
  for (int e = 0; e < 6; ++e)
    EXPECT_EQ(flip_edge(mesh, EdgeHandle(e), no_bounds).refusal, Refusal::link_condition);
}

// The waist of a tube of three columns is a cycle of three edges that bounds no triangle: collapsing one of
// them would pinch it.
TEST(StellarOperations, AWaistOfThreeEdgesIsNotPinched) {
  Triangulation mesh = to_triangulation(test::open_tube(1.0, 6.0, 3, 6));
  const EdgeHandle waist = edge_between(mesh, 9, 10);
  StellarLimits any_geometry;
  any_geometry.min_normal_cosine = -2.0;
  EXPECT_EQ(collapse_edge(mesh, waist, middle(mesh, waist), any_geometry).refusal, Refusal::link_condition);
  // Nor is a boundary of three edges.
  const EdgeHandle rim = edge_between(mesh, 0, 1);
  EXPECT_EQ(collapse_edge(mesh, rim, middle(mesh, rim), any_geometry).refusal, Refusal::link_condition);
}

TEST(StellarOperations, AnEdgeFromBoundaryToBoundaryIsNotCollapsed) {
  Triangulation mesh = to_triangulation(test::sheet(2.0, 1.0, 2, 1));
  const EdgeHandle across = edge_between(mesh, 1, 4);
  EXPECT_EQ(collapse_edge(mesh, across, middle(mesh, across), {}).refusal, Refusal::boundary);
}

TEST(StellarOperations, ACollapseThatTurnsATriangleOverIsRefused) {
  Triangulation mesh = to_triangulation(test::sheet(4.0, 4.0, 4, 4));
  const EdgeHandle e = edge_between(mesh, 12, 13);
  EXPECT_EQ(collapse_edge(mesh, e, Vec3(5.0, 2.0, 0.0), {}).refusal, Refusal::fold_over);
  EXPECT_TRUE(collapse_edge(mesh, e, Vec3(2.5, 2.0, 0.0), {}));
}

// In a quadrilateral with a corner pushed in, the other diagonal lies outside.
TEST(StellarOperations, AFlipInAConcaveQuadrilateralIsRefused) {
  const auto quadrilateral = [] {
    // Two triangles 0 1 2 and 0 2 3 within a ring that lets every vertex keep a valence of three.
    TriangleMesh mesh{
        {{0, -1, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}, {-5, -5, 0}},
        {{0, 1, 2},
         {0, 2, 3},
         {0, 4, 1},
         {1, 4, 5},
         {1, 5, 2},
         {2, 5, 6},
         {2, 6, 3},
         {3, 6, 7},
         {3, 7, 0},
         {0, 7, 4}}};
    return to_triangulation(mesh);
  };
  Triangulation convex = quadrilateral();
  EXPECT_TRUE(flip_edge(convex, edge_between(convex, 0, 2), {}));
  EXPECT_TRUE(convex.find_halfedge(VertexHandle(1), VertexHandle(3)).is_valid());
  // An arrow head: the line from vertex 1 to vertex 3 runs outside, past vertex 2.
  Triangulation concave = quadrilateral();
  concave.set_point(VertexHandle(1), Vec3(1.0, 1.0, 0.0));
  concave.set_point(VertexHandle(2), Vec3(0.0, 0.0, 0.0));
  concave.set_point(VertexHandle(3), Vec3(-1.0, 1.0, 0.0));
  EXPECT_EQ(flip_edge(concave, edge_between(concave, 0, 2), {}).refusal, Refusal::fold_over);
}

TEST(StellarOperations, ValencesStayWithinTheBounds) {
  Triangulation mesh = to_triangulation(test::icosahedron(1.0));
  StellarLimits limits;
  limits.min_normal_cosine = -2.0;
  limits.min_valence = 5;
  EXPECT_EQ(flip_edge(mesh, EdgeHandle(0), limits).refusal, Refusal::valence);
  EXPECT_EQ(collapse_edge(mesh, EdgeHandle(0), middle(mesh, EdgeHandle(0)), limits).refusal,
            Refusal::valence);
  limits.min_valence = 3;
  limits.max_valence = 5;  // two vertices of five neighbours become one of six
  EXPECT_EQ(flip_edge(mesh, EdgeHandle(0), limits).refusal, Refusal::valence);
  EXPECT_EQ(collapse_edge(mesh, EdgeHandle(0), middle(mesh, EdgeHandle(0)), limits).refusal,
            Refusal::valence);
}

TEST(StellarOperations, NoEdgeIsMadeLongerThanAllowed) {
  Triangulation mesh = to_triangulation(test::equilateral_sheet(1.0, 6, 6));
  StellarLimits limits;
  limits.max_edge = 1.2;
  const EdgeHandle inner = edge_between(mesh, 24, 25);
  EXPECT_EQ(flip_edge(mesh, inner, limits).refusal, Refusal::edge_too_long);
  EXPECT_EQ(collapse_edge(mesh, inner, middle(mesh, inner), limits).refusal, Refusal::edge_too_long);
}

TEST(StellarOperations, DeletedEdgesAreRefused) {
  Triangulation mesh = to_triangulation(test::sphere(1.0, 1));
  const EdgeHandle e(3);
  ASSERT_TRUE(collapse_edge(mesh, e, middle(mesh, e), {}));
  EXPECT_EQ(collapse_edge(mesh, e, Vec3::Zero(), {}).refusal, Refusal::deleted);
  EXPECT_EQ(flip_edge(mesh, e, {}).refusal, Refusal::deleted);
  EXPECT_EQ(split_edge(mesh, e, Vec3::Zero()).refusal, Refusal::deleted);
}

TEST(StellarOperations, CollapsingTowardsABoundaryLeavesTheBoundaryVertex) {
  Triangulation mesh = to_triangulation(test::sheet(4.0, 4.0, 4, 4));
  const EdgeHandle e = edge_between(mesh, 2, 7);  // vertex 2 is on the lower side
  const Vec3 on_boundary = mesh.point(VertexHandle(2));
  const StellarOutcome outcome = collapse_edge(mesh, e, on_boundary, {});
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome.vertex, VertexHandle(2));
  EXPECT_EQ(test::topology_of(to_triangle_mesh(mesh)), test::topology_of(test::sheet(4.0, 4.0, 4, 4)));
}

}  // namespace
}  // namespace nanocarbon::thesis
