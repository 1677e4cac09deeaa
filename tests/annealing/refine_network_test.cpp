// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/refine_network.h"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "support/rough_sphere.h"

namespace nanocarbon::annealing {
namespace {

TEST(RefinedInFour, QuadruplesTheAtomsAndAddsNoDefects) {
  const TriangleMesh sphere = test::unit_sphere(4);
  SwitchingState coarse;
  coarse.network = trivalent_network(sphere);
  for (const Triangle& t : sphere.triangles)
    coarse.positions.push_back(5 * (sphere.points[t[0]] + sphere.points[t[1]] + sphere.points[t[2]]) / 3);
  const TetherSurface surface(test::unit_sphere(12), 10);
  const SwitchingState fine = refined_in_four(coarse, surface);
  EXPECT_EQ(fine.network.atoms.size(), 4u * 320u);
  EXPECT_EQ(fine.positions.size(), 4u * 320u);
  const auto counts = ring_counts(fine.network);
  ASSERT_EQ(counts.size(), 7u);
  EXPECT_EQ(counts[5], 12u);
  EXPECT_EQ(counts[6], 2u * 320u + 2 - 12);
  for (const Vec3& p : fine.positions) EXPECT_LT(surface.distance(p), 0.5);
}

TEST(RefinedBy, MultipliesTheAtomsAndAddsNoDefects) {
  const TriangleMesh sphere = test::unit_sphere(4);
  SwitchingState coarse;
  coarse.network = trivalent_network(sphere);
  for (const Triangle& t : sphere.triangles)
    coarse.positions.push_back(5 * (sphere.points[t[0]] + sphere.points[t[1]] + sphere.points[t[2]]) / 3);
  for (const auto& [h, k, factor] : {std::tuple{1, 1, 3u}, {2, 0, 4u}, {2, 1, 7u}, {3, 0, 9u}}) {
    const TetherSurface surface(test::unit_sphere(12), 5 * std::sqrt(static_cast<double>(factor)));
    const SwitchingState fine = refined_by(coarse, h, k, surface);
    EXPECT_EQ(fine.positions.size(), factor * 320u);
    const auto counts = ring_counts(fine.network);
    ASSERT_EQ(counts.size(), 7u);
    EXPECT_EQ(counts[5], 12u);
    EXPECT_EQ(counts[6], factor * 320u / 2 + 2 - 12);
    for (const Vec3& p : fine.positions) EXPECT_LT(surface.distance(p), 0.5);
    // Bonds are as long as they were, to the evenness of the coarse triangles.
    for (AtomIndex a = 0; a < fine.positions.size(); ++a)
      for (const AtomIndex n : fine.network.atoms[a].neighbour)
        EXPECT_NEAR((fine.positions[n] - fine.positions[a]).norm(), 0.83, 0.4);
  }
}

TEST(RefinedBy, WorksAcrossTheFacesOfACell) {
  // A flat sheet of 6 by 6 cells of graphene: refined it is another, wherever the cell's faces are.
  TriangleMesh mesh;
  const double edge = 2.46, row = edge * std::sqrt(0.75);
  constexpr int cells = 6;
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) mesh.points.push_back(Vec3(edge * (i + 0.5 * j), row * j, 0));
  Cell cell;
  cell.vectors << cells * edge, 0.5 * cells * edge, 0, 0, cells * row, 0, 0, 0, 50;
  cell.periodic = {true, true, false};
  mesh.space = Space(cell);
  const auto at = [&](int i, int j) { return static_cast<VertexIndex>(j % cells * cells + i % cells); };
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
      mesh.triangles.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  SwitchingState coarse;
  coarse.network = trivalent_network(mesh);
  coarse.space = mesh.space;
  for (const Triangle& t : mesh.triangles) {
    const auto [a, b, c] = corners_of(mesh, t);
    coarse.positions.push_back((a + b + c) / 3);
  }
  for (const auto& [h, k] : {std::pair{1, 1}, {2, 0}, {2, 1}, {3, 0}}) {
    const double factor = h * h + h * k + k * k;
    const TetherSurface surface(mesh, std::sqrt(factor));
    const SwitchingState fine = refined_by(coarse, h, k, surface);
    EXPECT_EQ(fine.positions.size(), static_cast<std::size_t>(factor) * 2 * cells * cells);
    for (AtomIndex a = 0; a < fine.positions.size(); ++a)
      for (const AtomIndex n : fine.network.atoms[a].neighbour)
        EXPECT_NEAR(fine.space.displacement(fine.positions[a], fine.positions[n]).norm(),
                    edge / std::sqrt(3.0), 1e-9);
  }
}

}  // namespace
}  // namespace nanocarbon::annealing
