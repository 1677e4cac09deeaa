// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/coarse_starts.h"

#include <gtest/gtest.h>

#include <tuple>

#include "nanocarbon/shapes/shapes.h"
#include "support/plates.h"
#include "support/rough_sphere.h"

namespace nanocarbon::building {
namespace {

constexpr std::size_t atoms = 1280;  // a quarter of them is 20 * 4^2

// A sphere with room for so many atoms. \param horn Angstrom, from one vertex outwards
TriangleMesh sphere(std::size_t count, double horn = 0) {
  TriangleMesh surface = test::unit_sphere(20);
  for (Vec3& p : surface.points) p *= test::scale_for(count, 4 * std::numbers::pi);
  surface.points[100] += horn * surface.points[100].normalized();
  return surface;
}

// An icosahedral cage on a sphere.
annealing::AnnealingLevel cage(TriangleMesh triangulation, double radius) {
  for (Vec3& p : triangulation.points) p *= radius / p.norm();
  return *annealing::level_on(triangulation, {.tether = 3 * default_tether});
}

TEST(CoarseStarts, AreAQuarterOfTheAtomsOnHalfTheSphere) {
  ThreadTeam team(2);
  const CoarseStarts starts = coarse_starts(sphere(atoms), atoms, 1, {.running = {&team}});
  EXPECT_EQ(starts.tried, 2);
  EXPECT_EQ(starts.annealed, 2);
  EXPECT_FALSE(starts.widened);
  EXPECT_GT(starts.seconds, 0);
  ASSERT_EQ(starts.levels.size(), 2u);
  const double radius = sphere(atoms).points[0].norm() / 2;
  for (const annealing::AnnealingLevel& level : starts.levels) {
    EXPECT_NEAR(static_cast<double>(level.state.positions.size()), atoms / 4, 4);
    EXPECT_TRUE(annealing::holds(level));
    for (const Vec3& p : level.state.positions) EXPECT_NEAR(p.norm(), radius, 1);
  }
}

// Fourteen triangles are the least that a torus can have.
TEST(CoarseStarts, AreNoneWhereTheTopologyAsksForMore) {
  const TriangleMesh torus = shapes::make_torus(3, 1, 0.3);
  for (const auto& [quality, most] : {std::pair{Quality::good, 2}, {Quality::best, 4}}) {
    const CoarseStarts starts = coarse_starts(torus, 12 * 16, 2, {.quality = quality});
    EXPECT_TRUE(starts.levels.empty());
    EXPECT_EQ(starts.tried, most);
    EXPECT_EQ(starts.annealed, 0);
  }
}

// A plate as thick as sheets need at full size is half as thick, or a quarter, at the scale of a coarse level.
TEST(CoarseStarts, ThinPartsAreMadeWideEnoughForCoarseSheets) {
  ThreadTeam team(2);
  const TriangleMesh plate = test::pill(24, 5);
  const CoarseStarts starts = coarse_starts(plate, 1600, 1, {.running = {&team}});
  EXPECT_TRUE(starts.widened);
  EXPECT_FALSE(starts.levels.empty());
}

// A horn of 9 Angstrom at full size that the triangulation does not show.
TEST(CoarseStart, WhatLeavesOutPartsOfTheShapeIsNotAnnealed) {
  ThreadTeam team(2);
  for (const double horn : {0.0, 4.5}) {
    const TriangleMesh surface = sphere(atoms / 4, horn);
    const CoarseStart start = anneal_coarse_start(cage(test::unit_sphere(4), surface.points[0].norm()),
                                                  surface, atoms / 4, 1, {.running = {&team}}, 1);
    EXPECT_EQ(start.annealed, horn == 0);
    EXPECT_EQ(start.level.has_value(), horn == 0);
    EXPECT_FALSE(start.hopeless);
  }
}

// A sixteenth of the atoms: C60 has 0.55 eV an atom above graphene, C240 0.20.
TEST(CoarseStart, AtASixteenthSheetsBentAsSharplyAsC60AreAnnealedForTheBestQualityOnly) {
  for (const auto& [quality, k, worth_it] :
       {std::tuple{Quality::good, 1, false}, {Quality::best, 1, true}, {Quality::good, 2, true}}) {
    const auto count = 60 * static_cast<std::size_t>(k * k);
    const TriangleMesh surface = sphere(count);
    const CoarseStart start =
        anneal_coarse_start(cage(structures::icosahedral_triangulation(k, k), surface.points[0].norm()),
                            surface, count, 2, {.quality = quality}, 1);
    EXPECT_EQ(start.annealed, worth_it) << count;
  }
}

}  // namespace
}  // namespace nanocarbon::building
