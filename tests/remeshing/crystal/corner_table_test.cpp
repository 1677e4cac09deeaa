// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/crystal/corner_table.h"

#include <gtest/gtest.h>

#include <random>

#include "remeshing/shapes.h"
#include "remeshing/topology.h"

namespace nanocarbon::crystal {
namespace {

//! What the table says of twins, valences and boundaries must agree with its own triangles.
void expect_consistent(const CornerTable& table) {
  std::vector<int> valences(table.vertices(), 0);
  for (HalfEdgeIndex h = 0; h < table.half_edges(); ++h) {
    if (!table.alive(h)) continue;
    const HalfEdgeIndex o = table.twin(h);
    if (o != no_half_edge) {
      ASSERT_EQ(table.twin(o), h);
      ASSERT_EQ(table.origin(o), table.target(h));
      ASSERT_EQ(table.target(o), table.origin(h));
    }
    if (table.is_edge(h)) {
      ++valences[table.origin(h)];
      ++valences[table.target(h)];
    }
  }
  for (VertexIndex v = 0; v < table.vertices(); ++v) {
    if (!table.vertex_alive(v)) continue;
    ASSERT_EQ(table.valence(v), valences[v]);
    int met = 0;
    table.for_neighbours(v, [&](VertexIndex u) { met += table.adjacent(u, v) ? 1 : 0; });
    ASSERT_EQ(met, valences[v]);
  }
}

//! Random flips, splits and collapses, as many as the mesh has edges.
void shuffle(CornerTable& table, std::size_t operations, unsigned seed) {
  std::mt19937 random(seed);
  for (std::size_t k = 0; k < operations; ++k) {
    const HalfEdgeIndex h = static_cast<HalfEdgeIndex>(random() % table.half_edges());
    if (!table.alive(h)) continue;
    switch (random() % 3) {
      case 0:
        if (table.can_flip(h)) table.flip(h);
        break;
      case 1:
        table.split(h);
        break;
      default:
        if (table.can_collapse(h)) table.collapse(h);
    }
  }
}

void expect_topology_survives(const TriangleMesh& mesh) {
  const auto before = test::topology_of(mesh);
  CornerTable table(mesh);
  expect_consistent(table);
  for (unsigned seed = 1; seed <= 5; ++seed) {
    shuffle(table, 500, seed);
    expect_consistent(table);
    TriangleMesh now;
    now.triangles = table.triangles();
    now.points.resize(table.vertices());
    EXPECT_EQ(test::topology_of(now), before);
    const std::size_t vertices = table.live_vertices(), triangles = table.live_triangles();
    table.compact();
    expect_consistent(table);
    EXPECT_EQ(table.vertices(), vertices);
    EXPECT_EQ(table.half_edges(), 3 * triangles);
  }
}

TEST(CornerTable, RandomOperationsKeepTheTopologyOfClosedMeshes) {
  expect_topology_survives(test::icosahedron(1));
  expect_topology_survives(test::torus(3, 1, 12, 6));
}

TEST(CornerTable, RandomOperationsKeepTheTopologyOfOpenMeshes) {
  expect_topology_survives(test::open_tube(1, 3, 8, 6));
  expect_topology_survives(test::sheet(1, 1, 5, 5));
}

TEST(CornerTable, RefusesToCollapseATetrahedron) {
  const TriangleMesh tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                 {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
  const CornerTable table(tetrahedron);
  for (HalfEdgeIndex h = 0; h < table.half_edges(); ++h) {
    EXPECT_FALSE(table.can_collapse(h));
    EXPECT_FALSE(table.can_flip(h));
  }
}

}  // namespace
}  // namespace nanocarbon::crystal
