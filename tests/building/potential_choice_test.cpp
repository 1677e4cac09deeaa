// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/potential_choice.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>

#include "nanocarbon/building/build_molecule.h"
#include "nanocarbon/core/neighbours_within.h"
#include "nanocarbon/minimisation/minimise_molecule.h"
#include "nanocarbon/potential/airebo/airebo.h"
#include "nanocarbon/shapes/shapes.h"
#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/topology/connected_components.h"
#include "support/rough_sphere.h"

namespace nanocarbon::building {
namespace {

//! Spheres around each other, Angstrom.
TriangleMesh nested_spheres(double radius, double gap, int count = 2) {
  return shapes::make_nested_spheres({.radius = radius, .gap = gap, .count = count, .edge = 0.8});
}

double closest_of_different_components(const Molecule& molecule) {
  const topology::Components components = topology::connected_components(molecule.size(), molecule.bonds);
  const NeighbourList near = neighbours_within(molecule.positions, nullptr, 8.0);
  double closest = std::numeric_limits<double>::infinity();
  for (AtomIndex a = 0; a < molecule.size(); ++a)
    for (const Neighbour& n : near.of(a))
      if (components.of_atom[a] != components.of_atom[n.atom])
        closest = std::min(closest, (molecule.positions[a] - molecule.positions[n.atom]).norm());
  return closest;
}

BuildOptions draft_at_scale(PotentialChoice potential) {
  BuildOptions options;
  options.size = UnitScale{1};
  options.potential = potential;
  options.quality = Quality::draft;
  return options;
}

// Graphite's layers are 3.36 Angstrom apart under AIREBO; below 2.9 no two sheets come at rest.
TEST(PotentialChoice, AireboKeepsNestedSpheresApart) {
  for (const double gap : {3.4, 4.5, 7.0})
    for (const PotentialChoice choice : {PotentialChoice::airebo, PotentialChoice::airebo_m}) {
      const BuildOptions options = draft_at_scale(choice);
      const BuildResult result = build_molecule(nested_spheres(8, gap), options);
      SCOPED_TRACE(gap);
      EXPECT_TRUE(result.rest->intact);
      EXPECT_GT(closest_of_different_components(result.molecule), 2.9);
      EXPECT_LT(closest_of_different_components(result.molecule), 8.0);
      // At rest under that potential and no other.
      double largest = 0.0;
      const auto potential = make_potential(choice);
      for (const Vec3& f :
           potential->evaluate(result.molecule.positions, result.molecule.elements, nullptr, {}).forces)
        largest = std::max(largest, f.norm());
      EXPECT_LT(largest, 1.1e-3);
    }
}

// More than 2,000 atoms: where minimisation is preconditioned, shells have flown hundreds of Angstrom apart.
TEST(PotentialChoice, ShellsStayWithinEachOther) {
  for (const PotentialChoice choice : {PotentialChoice::rebo2, PotentialChoice::airebo}) {
    const BuildResult result = build_molecule(nested_spheres(8, 3.5, 3), draft_at_scale(choice));
    ASSERT_GT(result.molecule.size(), 2000u);
    EXPECT_EQ(topology::connected_components(result.molecule.size(), result.molecule.bonds).count, 3u);
    for (const Vec3& p : result.molecule.positions) EXPECT_LT(p.norm(), 18);
  }
}

// Where pentagons of two shells met they came to 2.88 Angstrom at rest.
TEST(PotentialChoice, AireboKeepsATripleOnionApart) {
  BuildOptions options = draft_at_scale(PotentialChoice::airebo);
  options.quality = Quality::good;
  const BuildResult result = build_molecule(nested_spheres(8, 3.4, 3), options);
  EXPECT_TRUE(result.rest->intact);
  EXPECT_EQ(topology::connected_components(result.molecule.size(), result.molecule.bonds).count, 3u);
  EXPECT_GT(closest_of_different_components(result.molecule), 2.9);
}

// LAMMPS's energies an atom after minimisation by rebo, airebo and airebo/morse.
TEST(PotentialChoice, EachHasLammpssEnergyOfC60) {
  const std::pair<PotentialChoice, double> known[] = {{PotentialChoice::rebo2, -6.842065},
                                                      {PotentialChoice::airebo, -6.8080046},
                                                      {PotentialChoice::airebo_m, -6.8007720}};
  for (const auto& [choice, energy] : known) {
    Molecule c60 = structures::fullerene(1, 1);
    const auto potential = make_potential(choice);
    EXPECT_EQ(potential->name(), name(choice));
    const auto minimum = minimisation::minimise_molecule(c60, *potential);
    EXPECT_TRUE(minimum.converged);
    EXPECT_NEAR(minimum.energy / 60, energy, 1e-6);
  }
}

TEST(PotentialChoice, CertificatesAreOfIt) {
  BuildOptions options;
  options.size = AtomCount{120};
  options.quality = Quality::draft;
  options.potential = PotentialChoice::airebo;
  options.certify = true;
  options.force = true;
  const BuildResult result = build_molecule(test::unit_sphere(12), options);
  ASSERT_TRUE(result.certificate);
  EXPECT_TRUE(result.certificate->minimum());
  airebo::Airebo airebo;
  EXPECT_NEAR(airebo.evaluate(result.molecule.positions, result.molecule.elements).energy,
              result.certificate->energy, 1e-8);
}

}  // namespace
}  // namespace nanocarbon::building
