// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/coarse_starts.h"

#include <gtest/gtest.h>

#include <tuple>

#include "nanocarbon/core/error.h"
#include "support/rough_sphere.h"

namespace nanocarbon::building {
namespace {

constexpr std::size_t atoms = 1280;  // a quarter of them is 20 * 4^2

// A sphere with room for as many atoms. \param horn Angstrom, from one vertex outwards
TriangleMesh sphere(double horn = 0) {
  TriangleMesh surface = test::unit_sphere(20);
  for (Vec3& p : surface.points) p *= test::scale_for(atoms, 4 * std::numbers::pi);
  surface.points[100] += horn * surface.points[100].normalized();
  return surface;
}

// Icosahedral, whatever the seed, on the sphere that most of the surface is.
TriangleMesh icosahedral(const TriangleMesh& surface, std::size_t faces, std::uint64_t) {
  TriangleMesh mesh = test::unit_sphere(static_cast<int>(std::lround(std::sqrt(faces / 20.0))));
  for (Vec3& p : mesh.points) p *= surface.points[0].norm();
  return mesh;
}

TEST(CoarseStarts, AQuarterOfTheAtomsOnHalfTheSphere) {
  CoarseStarts starts(sphere(), atoms, 1, icosahedral, {});
  ASSERT_TRUE(starts.left());
  const auto level = starts.next();
  ASSERT_TRUE(level.has_value());
  EXPECT_EQ(level->state.positions.size(), atoms / 4);
  EXPECT_TRUE(annealing::holds(*level));
  const double radius = sphere().points[0].norm() / 2;
  for (const Vec3& p : level->state.positions) EXPECT_NEAR(p.norm(), radius, 1);
  EXPECT_TRUE(starts.left());
  starts.next();
  EXPECT_FALSE(starts.left());
}

TEST(CoarseStarts, AreTwoAndFourForTheBestQuality) {
  for (const auto& [quality, most] : {std::pair{Quality::good, 2}, {Quality::best, 4}}) {
    std::vector<std::uint64_t> seeds;
    const Triangulator triangulate = [&](const TriangleMesh&, std::size_t,
                                         std::uint64_t seed) -> TriangleMesh {
      seeds.push_back(seed);
      throw UserError(Failure::size, "too few for the topology");
    };
    CoarseStarts starts(sphere(), atoms, 1, triangulate, {.quality = quality, .seed = 7});
    int tried = 0;
    for (; starts.left(); ++tried) EXPECT_FALSE(starts.next().has_value());
    EXPECT_EQ(tried, most);
    EXPECT_EQ(seeds.size(), static_cast<std::size_t>(most));
    for (std::size_t k = 0; k < seeds.size(); ++k) EXPECT_EQ(seeds[k], 7 + k);
  }
}

// A horn of 9 Angstrom that no triangulation shows: such a start is not worth annealing, unless there is room
// for the horn, which is made once.
TEST(CoarseStarts, WhatLeavesOutPartsOfTheShapeIsTriedOnceMoreWithRoom) {
  int rooms = 0;
  bool annealed = false;
  const AnnealOptions options{
      .make_room = [&](const TriangleMesh& surface) -> std::optional<TriangleMesh> {
        ++rooms;
        TriangleMesh roomy = surface;
        roomy.points[100] = surface.points[0].norm() * surface.points[100].normalized();
        return roomy;
      },
      .progress = [&](std::string_view stage,
                      double) { annealed = annealed || stage == "annealing coarsely"; }};
  AnnealOptions narrow = options;
  narrow.make_room = {};
  CoarseStarts without(sphere(9), atoms, 1, icosahedral, narrow);
  while (without.left()) EXPECT_FALSE(without.next().has_value());
  EXPECT_FALSE(annealed);
  CoarseStarts with(sphere(9), atoms, 1, icosahedral, options);
  while (with.left()) EXPECT_TRUE(with.next().has_value());
  EXPECT_EQ(rooms, 1);
}

// A sixteenth of the atoms: C60 has 0.55 eV an atom above graphene, C240 0.20.
TEST(CoarseStarts, AtASixteenthSheetsBentAsSharplyAsC60AreAnnealedForTheBestQualityOnly) {
  for (const auto& [quality, count, worth_it] :
       {std::tuple{Quality::good, 60, false}, {Quality::best, 60, true}, {Quality::good, 240, true}}) {
    TriangleMesh surface = test::unit_sphere(20);
    const auto all = 16 * static_cast<std::size_t>(count);
    for (Vec3& p : surface.points) p *= test::scale_for(all, 4 * std::numbers::pi);
    bool annealed = false;
    CoarseStarts starts(surface, all, 2,
                        [](const TriangleMesh& sphere, std::size_t faces, std::uint64_t) {
                          const int k = faces == 60 ? 1 : 2;
                          TriangleMesh cage = structures::icosahedral_triangulation(k, k);
                          for (Vec3& p : cage.points) p *= sphere.points[0].norm() / p.norm();
                          return cage;
                        },
                        {.quality = quality, .progress = [&](std::string_view, double) { annealed = true; }});
    starts.next();
    EXPECT_EQ(annealed, worth_it) << count;
  }
}

}  // namespace
}  // namespace nanocarbon::building
