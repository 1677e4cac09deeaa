// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/crystal/patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "nanocarbon/remeshing/crystal/flips.h"
#include "nanocarbon/remeshing/crystal/isotropic.h"
#include "nanocarbon/remeshing/crystal/particle_annealing.h"
#include "nanocarbon/remeshing/crystal/soundness.h"
#include "nanocarbon/remeshing/crystal/tiling_moves.h"
#include "remeshing/shapes.h"
#include "remeshing/topology.h"

namespace nanocarbon::crystal {
namespace {

// Triangles as points, each from its least corner on, sorted: the same for any numbering.
std::vector<std::array<double, 9>> shape_of(const Tiling& tiling) {
  std::vector<std::array<double, 9>> shape;
  for (Triangle t : tiling.table.triangles()) {
    const auto less = [&](VertexIndex a, VertexIndex b) {
      const Vec3 &p = tiling.points[a], &q = tiling.points[b];
      return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end());
    };
    std::rotate(t.begin(), std::min_element(t.begin(), t.end(), less), t.end());
    std::array<double, 9>& corners = shape.emplace_back();
    for (std::size_t k = 0; k < 3; ++k)
      std::copy_n(tiling.points[t[k]].data(), 3, corners.begin() + static_cast<std::ptrdiff_t>(3 * k));
  }
  std::sort(shape.begin(), shape.end());
  return shape;
}

class PatchesOfATorus : public testing::Test {
 protected:
  PatchesOfATorus() : surface(test::torus(3, 1.2, 80, 40)), guide(surface, 1.0), tiling(tiling_of(guide)) {
    spacing = 0.2;
    remesh_isotropically(tiling, spacing, 6);
    compact(tiling);
  }

  TriangleMesh surface;
  SurfaceGuide guide;
  Tiling tiling;
  double spacing;
};

TEST_F(PatchesOfATorus, PutBackAsTheyWereChangeNothing) {
  const auto before = shape_of(tiling);
  const std::vector<VertexIndex> around = {3, 700, 1200};
  const std::vector<Patch> patches = surroundings(tiling, around, 6);
  replace(tiling, patches);
  EXPECT_EQ(shape_of(tiling), before);
}

TEST_F(PatchesOfATorus, OnesThatTouchAreOne) {
  const VertexIndex v = 100;
  VertexIndex neighbour = v;
  tiling.table.for_neighbours(v, [&](VertexIndex u) { neighbour = u; });
  EXPECT_EQ(surroundings(tiling, std::vector{v, neighbour}, 5).size(), 1u);
}

// Whatever is done to a patch, the whole stays a torus without folds beyond its edge.
TEST_F(PatchesOfATorus, WorkedOnTheyFitIn) {
  const std::size_t vertices = tiling.table.live_vertices();
  std::vector<Patch> patches = surroundings(tiling, std::vector<VertexIndex>{10, 900}, 9);
  for (Patch& patch : patches) {
    Tiling& part = patch.tiling;
    std::vector<std::pair<VertexIndex, Vec3>> held;
    for (VertexIndex v = 0; v < part.points.size(); ++v)
      if (part.is_held(v)) held.emplace_back(part.held[v], part.points[v]);
    ASSERT_FALSE(held.empty());
    anneal_particles(part, spacing, {400, 1.0, 0.2, 5});
    for (HalfEdgeIndex h = 0; h < 60; ++h)
      if (part.table.alive(h)) try_collapse(part, h, 2 * spacing);
    compact(part);
    reach_vertex_count(part, part.table.live_vertices() + 3);
    unfold(part, 10);
    flip_to_valences(part, 10);
    for (const auto& [number, point] : held) EXPECT_EQ(tiling.points[number], point);
  }
  replace(tiling, patches);
  EXPECT_EQ(test::topology_of(to_mesh(tiling)), test::topology_of(surface));
  EXPECT_NEAR(static_cast<double>(tiling.table.live_vertices()), static_cast<double>(vertices), 20);
  EXPECT_TRUE(unsound_vertices(tiling).empty());
}

TEST_F(PatchesOfATorus, OrderAlongTheSurfaceChangesNumbersAlone) {
  const auto before = shape_of(tiling);
  put_in_order(tiling);
  EXPECT_EQ(shape_of(tiling), before);
  // Corners of a triangle are a row or two of vertices apart, not anywhere.
  std::size_t apart = 0;
  for (const Triangle& t : tiling.table.triangles()) {
    const auto [least, most] = std::minmax({t[0], t[1], t[2]});
    apart = std::max<std::size_t>(apart, most - least);
  }
  EXPECT_LT(apart, tiling.points.size() / 4);
}

}  // namespace
}  // namespace nanocarbon::crystal
