// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/minimisation/multilevel/interpolation.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "nanocarbon/structures/fullerene.h"

namespace nanocarbon::multilevel {
namespace {

struct Errors {
  double largest = 0, mean = 0;
};

// Errors of interpolating a displacement from the coarse nodes of a molecule.
template <typename Displacement>
Errors errors_of(const Molecule& molecule, unsigned separation, Displacement displacement) {
  const Coarsening coarsening = coarsen(bonded_atoms(molecule.size(), molecule.bonds), separation);
  const Interpolation p = quadratic_interpolation(Space(), molecule.positions, coarsening);
  Errors errors;
  for (std::size_t i = 0; i < molecule.size(); ++i) {
    Vec3 sum = -displacement(molecule.positions[i]);
    for (std::uint32_t e = p.coarse.offsets[i]; e < p.coarse.offsets[i + 1]; ++e)
      sum += p.weights[e] * displacement(molecule.positions[coarsening.chosen[p.coarse.nodes[e]]]);
    errors.largest = std::max(errors.largest, sum.norm());
    errors.mean += sum.norm() / static_cast<double>(molecule.size());
  }
  return errors;
}

TEST(QuadraticInterpolation, TranslationsAreExact) {
  EXPECT_LT(errors_of(structures::fullerene(6, 6), 4, [](const Vec3&) { return Vec3(1, 2, 3); }).largest,
            1e-12);
}

TEST(QuadraticInterpolation, TurnsAreRightAlsoWhereTheSheetIsNarrowerThanCoarseNodesAreApart) {
  const auto turn = [](const Vec3& x) { return Vec3(Vec3(0.3, -0.5, 0.8).cross(x)); };  // by about one radian
  EXPECT_LT(errors_of(structures::fullerene(6, 6), 4, turn).largest, 0.02);
  EXPECT_LT(errors_of(structures::fullerene(6, 6), 10, turn).largest, 0.05);
}

TEST(QuadraticInterpolation, BendingOfAFlatSheetIsRight) {
  Molecule sheet = structures::fullerene(1, 1);
  sheet.positions.clear();
  sheet.bonds.clear();
  // Brick wall: the graph of graphene, 40 by 40 atoms on a square lattice.
  const AtomIndex side = 40;
  for (AtomIndex y = 0; y < side; ++y)
    for (AtomIndex x = 0; x < side; ++x) {
      sheet.positions.emplace_back(1.5 * x, 1.5 * y, 0);
      if (x + 1 < side) sheet.bonds.push_back({y * side + x, y * side + x + 1});
      if (y + 1 < side && (x + y) % 2 == 0) sheet.bonds.push_back({y * side + x, (y + 1) * side + x});
    }
  const auto bend = [](const Vec3& x) { return Vec3(0, 0, 0.01 * (x.x() * x.x() - x.x() * x.y())); };
  EXPECT_LT(errors_of(sheet, 4, bend).mean, 0.03);  // by first degree alone: about 0.2
}

}  // namespace
}  // namespace nanocarbon::multilevel
