// What the default recipe reaches where the least energy is known: fullerenes, tubes, tori. Energies are
// REBO2's, above graphene's, in meV for each atom.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "nanocarbon/building/build_molecule.h"
#include "nanocarbon/mesh/nearest_point.h"
#include "nanocarbon/rebo2/rebo2.h"
#include "nanocarbon/structures/shapes.h"

namespace nanocarbon {
namespace {

constexpr double graphene = -7.3949972517;  // eV/atom: pair_style rebo, minimised

BuildResult built(const TriangleMesh& surface, const SizeRequest& size) {
  BuildOptions options;
  options.size = size;
  options.threads = 2;
  return build_molecule(surface, options);
}

// Of all atoms, by the full potential as LAMMPS evaluates it.
double above_graphene(const Molecule& molecule) {
  Rebo2 rebo2;
  const double energy = rebo2.evaluate(molecule.positions, molecule.elements).energy;
  return 1e3 * (energy / static_cast<double>(molecule.size()) - graphene);
}

double mean_distance(const BuildResult& result) {
  const NearestPoint surface(result.surface.mesh);
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

TEST_P(SphereTest, ComesCloseToTheIcosahedralFullerene) {
  const BuildResult result = built(make_sphere(1.0, 5), AtomCount{GetParam().atoms});
  // Bending costs a sphere the same whatever the count, so that the energy of an atom goes with its inverse.
  const double count = static_cast<double>(result.molecule.size()) / static_cast<double>(GetParam().atoms);
  EXPECT_NEAR(count, 1, 0.01);
  EXPECT_LT(above_graphene(result.molecule) * count, GetParam().icosahedral + 5);
  EXPECT_LT(mean_distance(result), 1);
}

INSTANTIATE_TEST_SUITE_P(Icosahedral, SphereTest, testing::Values(Sphere{960, 62.5}),
                         [](const auto& sphere) { return std::to_string(sphere.param.atoms); });

TEST(KnownEnergies, ATorusOf2180AtomsHasAtMost65) {
  const BuildResult result = built(make_torus(3.0, 1.2, 0.2), AtomCount{2180});
  EXPECT_LT(above_graphene(result.molecule), 65);
  EXPECT_LT(mean_distance(result), 1);
  EXPECT_EQ(rings_outside_5_to_7(result.molecule), 0u);
}

}  // namespace
}  // namespace nanocarbon
