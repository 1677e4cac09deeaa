// SPDX-License-Identifier: GPL-2.0-or-later
// Pyramidalisation and curvature of spheres, tubes and sheets.
#include <gtest/gtest.h>

#include <numbers>

#include "bonded.h"
#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/structures/graphene.h"
#include "nanocarbon/structures/schwarzite.h"
#include "nanocarbon/structures/tube.h"

namespace nanocarbon::analysis {
namespace {

Molecule on_sphere(Molecule molecule, double radius) {
  for (Vec3& p : molecule.positions) p *= radius / p.norm();
  return test::bonded(molecule);
}

// Of all truncated icosahedra, the one with equal bonds has 11.64 degrees (Haddon 1986).
TEST(AtomGeometry, PyramidalisationOfC60IsHaddons) {
  const Analysis analysis = test::analysed(on_sphere(structures::fullerene(1, 1), 3.55));
  EXPECT_EQ(analysis.pyramidalisation.spread.count, 60u);
  EXPECT_NEAR(analysis.pyramidalisation.spread.mean, 11.64, 0.03);
}

TEST(AtomGeometry, ASphereCurvesByItsRadiusAndAddsUpToGaussBonnet) {
  const double radius = 18.0;
  const Molecule molecule = on_sphere(structures::fullerene(5, 5), radius);
  const Analysis analysis = test::analysed(molecule);
  ASSERT_EQ(analysis.mean_curvature.spread.count, molecule.size());
  EXPECT_NEAR(analysis.mean_curvature.spread.mean * radius, 1.0, 0.02);
  EXPECT_GT(analysis.mean_curvature.spread.min, 0.0);  // outwards
  const double area = 4.0 * std::numbers::pi * radius * radius / static_cast<double>(molecule.size());
  double sum = 0.0;
  for (const double k : analysis.geometry.gaussian_curvature) sum += k * area;
  EXPECT_NEAR(sum / (2.0 * std::numbers::pi * 2.0), 1.0, 0.03);  // 2 pi chi
}

TEST(AtomGeometry, ATubeCurvesOneWayOnly) {
  const double radius = structures::tube_geometry(10, 10).radius;
  const Analysis analysis = test::analysed(test::bonded(structures::periodic_tube(10, 10, 3)));
  EXPECT_NEAR(analysis.mean_curvature.spread.mean * 2.0 * radius, 1.0, 0.02);
  EXPECT_NEAR(analysis.gaussian_curvature.spread.mean * radius * radius, 0.0, 1e-3);
}

TEST(AtomGeometry, ASheetIsFlatAndASchwarziteASaddle) {
  const Analysis flat = test::analysed(test::bonded(structures::graphene(3, 2)));
  EXPECT_NEAR(flat.pyramidalisation.spread.max, 0.0, 1e-6);
  EXPECT_NEAR(flat.mean_curvature.spread.max, 0.0, 1e-12);
  EXPECT_LT(test::analysed(test::bonded(structures::schwarzite_p688(2, 2, 2))).gaussian_curvature.spread.max,
            0.0);
}

TEST(AtomGeometry, IsUnknownAtRims) {
  const Analysis flake = test::analysed(test::bonded(structures::graphene_flake(8.0)));
  for (AtomIndex a = 0; a < flake.rows.atoms(); ++a) {
    EXPECT_EQ(std::isnan(flake.geometry.pyramidalisation[a]), flake.rows.degree(a) != 3);
    if (flake.rows.degree(a) != 3) {
      EXPECT_TRUE(std::isnan(flake.geometry.gaussian_curvature[a]));
    }
  }
}

}  // namespace
}  // namespace nanocarbon::analysis
