// SPDX-License-Identifier: GPL-2.0-or-later
// What the default recipe reaches where the least energy is known: fullerenes, tubes, tori, schwarzites. Energies are
// REBO2's, above graphene's, in meV for each atom.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "nanocarbon/building/build_molecule.h"
#include "nanocarbon/mesh/nearest_point.h"
#include "nanocarbon/potential/rebo2/rebo2.h"
#include "nanocarbon/shapes/periodic_shapes.h"
#include "nanocarbon/shapes/shapes.h"

namespace nanocarbon::building {
namespace {

constexpr double graphene = -7.3949972517;  // eV/atom: pair_style rebo, minimised

BuildResult built(const TriangleMesh& surface, const SizeRequest& size, std::uint64_t seed = 1) {
  BuildOptions options;
  options.seed = seed;
  options.size = size;
  options.threads = 2;
  return build_molecule(surface, options);
}

// Of all atoms, by the full potential as LAMMPS evaluates it.
double above_graphene(const Molecule& molecule) {
  rebo2::Rebo2 rebo2;
  const double energy = rebo2.evaluate(molecule.positions, molecule.elements).energy;
  return 1e3 * (energy / static_cast<double>(molecule.size()) - graphene);
}

double mean_distance(const BuildResult& result) {
  const mesh::NearestPoint surface(result.surface.mesh);
  double sum = 0;
  for (const Vec3& p : result.molecule.positions) sum += surface.nearest(p).distance;
  return sum / static_cast<double>(result.molecule.size());
}

std::size_t rings_outside_5_to_7(const Molecule& molecule) {
  std::size_t outside = 0;
  for (std::size_t r = 0; r < molecule.rings.size(); ++r)
    outside += molecule.rings[r].size() < 5 || molecule.rings[r].size() > 7;
  return outside;
}

struct Sphere {
  std::size_t atoms;
  double icosahedral;  // of the icosahedral fullerene with as many atoms, minimised by LAMMPS
};

class SphereTest : public testing::TestWithParam<Sphere> {};

// A search by chance, hence the better of two seeds: of four runs at 540 atoms two ended within the bar, the
// others 0.4 and 1.4 meV above it.
TEST_P(SphereTest, ComesCloseToTheIcosahedralFullerene) {
  double least = 1e3;
  for (std::uint64_t seed = 1; seed <= 2 && least > GetParam().icosahedral + 5; ++seed) {
    const BuildResult result = built(shapes::make_sphere(1.0, 10), AtomCount{GetParam().atoms}, seed);
    // Bending costs a sphere the same whatever the count: the energy of an atom goes with its inverse.
    const double count = static_cast<double>(result.molecule.size()) / static_cast<double>(GetParam().atoms);
    EXPECT_NEAR(count, 1, 0.01);
    EXPECT_LT(mean_distance(result), 1);
    least = std::min(least, above_graphene(result.molecule) * count);
  }
  EXPECT_LT(least, GetParam().icosahedral + 5);
}

INSTANTIATE_TEST_SUITE_P(Icosahedral, SphereTest, testing::Values(Sphere{540, 100.3}, Sphere{960, 62.5}),
                         [](const auto& sphere) { return std::to_string(sphere.param.atoms); });

TEST(KnownEnergies, ATorusOf2180AtomsHasAtMost65) {
  const BuildResult result = built(shapes::make_torus(3.0, 1.2, 0.2), AtomCount{2180});
  EXPECT_LT(above_graphene(result.molecule), 65);
  EXPECT_LT(mean_distance(result), 1);
  EXPECT_EQ(rings_outside_5_to_7(result.molecule), 0u);
}

// Far from its caps, a capsule of the (10,10) tube's radius is a tube, though not always that one.
TEST(KnownEnergies, ACapsulesCylinderIsATube) {
  constexpr double armchair = 39.1;  // the (10,10) tube, minimised by LAMMPS
  const BuildResult result = built(shapes::make_capsule(6.8, 45.0, 0.8), UnitScale{1.0});
  const Molecule& molecule = result.molecule;
  rebo2::Rebo2 rebo2;
  const rebo2::Rebo2Result& energies =
      rebo2.evaluate(molecule.positions, molecule.elements, nullptr, {.atom_energies = true});
  double centre = 0;
  for (const Vec3& p : molecule.positions) centre += p.z() / static_cast<double>(molecule.size());
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t a = 0; a < molecule.size(); ++a) {
    if (std::abs(molecule.positions[a].z() - centre) > 12) continue;
    sum += energies.atom_energies[a] - graphene;
    ++count;
  }
  ASSERT_GT(count, 300u);
  EXPECT_NEAR(1e3 * sum / static_cast<double>(count), armchair, 2);
  EXPECT_LT(mean_distance(result), 0.5);
}

// The network of octagons on P with 1,728 atoms, minimised by LAMMPS, has 34.8. Among starts refined from few atoms hardly any
// of this size is in good order, and to add the atoms that one lacks takes dislocations.
TEST(KnownEnergies, ASchwarziteOf1600AtomsIsWithin10OfTheNetworkOfOctagons) {
  shapes::MinimalSurface p;
  p.kind = shapes::MinimalSurface::Kind::schwarz_p;
  BuildOptions options;
  options.size = AtomCount{1600};
  options.relax_cell = minimisation::CellRelaxation::triclinic;
  options.threads = 2;
  const Molecule molecule = build_molecule(shapes::make_minimal_surface(p), options).molecule;
  const auto count = static_cast<double>(molecule.size());
  EXPECT_NEAR(count, 1600, 32);
  rebo2::Rebo2 rebo2;
  const double energy =
      rebo2.evaluate(molecule.positions, molecule.elements, &*molecule.cell, {}).energy / count;
  EXPECT_LT(1e3 * (energy - graphene) * count / 1728, 34.8 + 10);
}

}  // namespace
}  // namespace nanocarbon::building
