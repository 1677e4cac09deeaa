// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "nanocarbon/building/build_molecule.h"
#include "nanocarbon/core/neighbours_within.h"
#include "nanocarbon/minimisation/minimise_molecule.h"
#include "nanocarbon/potential/rebo2/rebo2.h"
#include "nanocarbon/shapes/shapes.h"

namespace nanocarbon::building {
namespace {

// Least distance of two atoms that are not bonded to each other, within a reach.
double closest_unbonded(const Molecule& molecule, double reach) {
  double closest = reach;
  const NeighbourList near = neighbours_within(molecule.positions, nullptr, reach);
  for (AtomIndex a = 0; a < molecule.size(); ++a)
    for (const Neighbour& n : near.of(a)) {
      const Bond bond{std::min(a, n.atom), std::max(a, n.atom)};
      if (std::find(molecule.bonds.begin(), molecule.bonds.end(), bond) != molecule.bonds.end()) continue;
      closest = std::min(closest, (molecule.positions[a] - molecule.positions[n.atom]).norm());
    }
  return closest;
}

// A needle that is far too thin, stopped far from its minimum: the certificate's minimisation goes on to
// where atoms are pressed into REBO2's reach of each other.
TEST(CertifiedBuild, TellsOfTheMoleculeAtItsMinimumAndNotBefore) {
  TriangleMesh needle = shapes::make_sphere(1, 10);
  for (Vec3& p : needle.points) p = Vec3(0.02 * p.x(), 0.02 * p.y(), p.z());
  BuildOptions options;
  options.size = AtomCount{200};
  options.quality = Quality::draft;
  options.force = true;
  options.force_tolerance = 10;
  options.certify = true;
  const BuildResult result = build_molecule(needle, options);
  EXPECT_NEAR(result.rest->closest_unbonded, closest_unbonded(result.molecule, 2.2), 1e-9);
  Molecule again = result.molecule;
  rebo2::Rebo2 rebo2;
  EXPECT_EQ(result.rest->intact,
            minimisation::minimise_molecule(again, rebo2, {.force_tolerance = 1e-6}).intact);
}

}  // namespace
}  // namespace nanocarbon::building
