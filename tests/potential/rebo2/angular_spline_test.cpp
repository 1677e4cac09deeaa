// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/rebo2/angular_spline.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

namespace nanocarbon::rebo2 {
namespace {

double g_carbon(double degrees, double coordination) {
  return angular_carbon(rebo2_parameters().carbon, std::cos(degrees * std::numbers::pi / 180.0), coordination)
      .value;
}

//! Table 3 of Brenner et al. 2002: G_C and gamma_C at the angles they were fitted at. At 180 degrees the
//! spline of Stuart et al. 2000, which LAMMPS has, is at -0.01 instead of -0.001.
TEST(AngularSpline, HasThePublishedValuesAtItsKnots) {
  EXPECT_NEAR(g_carbon(180.0, 2.0), -0.01, 1e-5);
  EXPECT_NEAR(g_carbon(120.0, 2.0), 0.05280, 1e-5);
  EXPECT_NEAR(g_carbon(109.47122, 2.0), 0.09733, 1e-5);
  EXPECT_NEAR(g_carbon(0.0, 2.0), 1.0, 1e-5);
  EXPECT_NEAR(g_carbon(0.0, 4.0), 8.0, 1e-5);
  EXPECT_NEAR(g_carbon(90.0, 4.0), 0.37545, 1e-5);
}

TEST(AngularSpline, BranchesAgreeBeyondTheTetrahedralAngle) {
  for (double degrees = 112.0; degrees < 180.0; degrees += 3.0)
    EXPECT_EQ(g_carbon(degrees, 2.0), g_carbon(degrees, 4.0));
}

TEST(AngularSpline, IsContinuousAcrossKnotsWithinTheFilesRounding) {
  for (const double knot : {-2.0 / 3.0, -0.5, -1.0 / 3.0})
    for (const double n : {2.0, 3.4, 4.0}) {
      const AngularValue below = angular_carbon(rebo2_parameters().carbon, knot - 1e-7, n);
      const AngularValue above = angular_carbon(rebo2_parameters().carbon, knot + 1e-7, n);
      EXPECT_NEAR(below.value, above.value, 1e-6);
      EXPECT_NEAR(below.by_cosine, above.by_cosine, 1e-5);
    }
}

TEST(AngularSpline, DerivativesAreThoseOfTheValue) {
  constexpr double step = 1e-6;
  const CarbonAngles& carbon = rebo2_parameters().carbon;
  for (double cosine = -0.97; cosine < 1.0; cosine += 0.11)
    for (const double n : {2.0, 3.25, 3.5, 3.69, 4.0}) {
      const AngularValue g = angular_carbon(carbon, cosine, n);
      const auto at = [&](double dc, double dn) { return angular_carbon(carbon, cosine + dc, n + dn).value; };
      EXPECT_NEAR(g.by_cosine, (at(step, 0) - at(-step, 0)) / (2 * step), 1e-7);
      EXPECT_NEAR(g.by_coordination, (at(0, step) - at(0, -step)) / (2 * step), 1e-7);
      const AngularValue h = angular_hydrogen(rebo2_parameters().hydrogen, cosine);
      EXPECT_NEAR(h.by_cosine,
                  (angular_hydrogen(rebo2_parameters().hydrogen, cosine + step).value -
                   angular_hydrogen(rebo2_parameters().hydrogen, cosine - step).value) /
                      (2 * step),
                  1e-6);
      EXPECT_EQ(h.by_coordination, 0.0);
    }
}

TEST(AngularSpline, EndsAreItsFirstAndLastPieces) {
  const CarbonAngles& carbon = rebo2_parameters().carbon;
  EXPECT_EQ(spline_piece(carbon.knots, -1.0), 0u);
  EXPECT_EQ(spline_piece(carbon.knots, -0.5), 2u);
  EXPECT_EQ(spline_piece(carbon.knots, 1.0), 3u);
}

}  // namespace
}  // namespace nanocarbon::rebo2
