// SPDX-License-Identifier: GPL-2.0-or-later
// Hydrogen at boundaries without atoms of its own, against the full potential with hydrogen atoms.
#include "nanocarbon/annealing/open_atoms.h"

#include <gtest/gtest.h>

#include <random>

#include "nanocarbon/annealing/fixed_bond_rebo2.h"
#include "nanocarbon/minimisation/minimise_molecule.h"
#include "nanocarbon/molecule/hydrogens.h"
#include "nanocarbon/potential/rebo2/rebo2.h"
#include "nanocarbon/structures/graphene.h"
#include "nanocarbon/structures/tube.h"

namespace nanocarbon::annealing {
namespace {

FixedBondRebo2 with_hydrogen(const Molecule& carbon) {
  FixedBondGraph graph = fixed_bond_graph(carbon);
  graph.hydrogen = true;
  FixedBondRebo2 rebo2;
  rebo2.set_graph(graph);
  return rebo2;
}

Molecule rattled(Molecule molecule, double amplitude) {
  std::mt19937_64 random(5);
  for (Vec3& p : molecule.positions)
    for (int d = 0; d < 3; ++d) p[d] += amplitude * (static_cast<double>(random() >> 11) * 0x1p-52 - 1);
  return molecule;
}

struct Case {
  Molecule carbon;
  double gain;  // eV, at most, by which each hydrogen comes to rest below where the model has it
};

// Benzene, coronene, flakes and tubes with zigzag, armchair and chiral ends: minima of both, hydrogen counted as
// in benzene. Free hydrogen leaves the plane of the bonds beside it where the sheet is bent: never at a loss, but
// on narrow tubes at some gain.
TEST(OpenAtoms, MinimaAreThoseOfTheFullPotentialWithHydrogen) {
  const std::vector<Case> cases = {
      {structures::graphene_flake(1.5), 0.002},   {structures::graphene_flake(4.0), 0.01},
      {structures::graphene_flake(11.0), 0.02},   {structures::open_tube(9, 0, 12.0), 0.05},
      {structures::open_tube(18, 0, 12.0), 0.02}, {structures::open_tube(6, 6, 12.0), 0.03},
      {structures::open_tube(8, 3, 14.0), 0.04}};
  rebo2::Rebo2 full;
  for (const auto& [start, gain] : cases) {
    Molecule carbon = start, whole = molecule::saturated_with_hydrogen(start);
    const std::size_t hydrogens = molecule::hydrogen_count(whole);
    ASSERT_GT(hydrogens, 5u);
    const auto known = minimisation::minimise_molecule(whole, full, {.force_tolerance = 1e-5});
    ASSERT_TRUE(known.converged && known.intact);
    FixedBondRebo2 rebo2 = with_hydrogen(carbon);
    const auto relaxed =
        minimisation::minimise_lbfgs(carbon.positions, [&](auto x, auto g) { return rebo2.evaluate(x, g); },
                                     {.max_iterations = 3000, .force_tolerance = 1e-5});
    const double expected = known.energy - static_cast<double>(hydrogens) * full.hydrogen_energy();
    const double each = (relaxed.energy - expected) / static_cast<double>(hydrogens);
    EXPECT_GT(each, -1e-4) << carbon.size() << " atoms, " << hydrogens << " of hydrogen";
    EXPECT_LT(each, gain) << carbon.size() << " atoms, " << hydrogens << " of hydrogen";
  }
}

TEST(OpenAtoms, BenzeneHasTheEnergyOfSixAtomsOfGraphene) {
  Molecule ring = structures::graphene_flake(1.5);
  ASSERT_EQ(ring.size(), 6u);
  FixedBondRebo2 rebo2 = with_hydrogen(ring);
  const auto relaxed = minimisation::minimise_lbfgs(
      ring.positions, [&](auto x, auto g) { return rebo2.evaluate(x, g); }, {.force_tolerance = 1e-6});
  EXPECT_NEAR(relaxed.energy, 6 * rebo2::graphene_energy, 1e-3);
}

TEST(OpenAtoms, ForcesAreTheSlopeOfTheEnergy) {
  const Molecule carbon = rattled(structures::open_tube(6, 3, 14.0), 0.12);
  FixedBondRebo2 rebo2 = with_hydrogen(carbon);
  std::vector<Vec3> gradient(carbon.size(), Vec3::Zero()), unused = gradient;
  rebo2.evaluate(carbon.positions, gradient);
  for (std::size_t a = 0; a < carbon.size(); a += 3)
    for (int d = 0; d < 3; ++d) {
      const double h = 1e-5;
      std::vector<Vec3> moved = carbon.positions;
      moved[a][d] += h;
      const double ahead = rebo2.evaluate(moved, unused);
      moved[a][d] -= 2 * h;
      const double behind = rebo2.evaluate(moved, unused);
      EXPECT_NEAR(gradient[a][d], (ahead - behind) / (2 * h), 2e-7) << "atom " << a;
    }
}

TEST(OpenAtoms, BothEvaluationsAgree) {
  const Molecule carbon = rattled(structures::open_tube(7, 2, 14.0), 0.1);
  FixedBondRebo2 rebo2 = with_hydrogen(carbon);
  std::vector<Vec3> fast(carbon.size(), Vec3::Zero()), slow = fast;
  const double difference =
      rebo2.evaluate(carbon.positions, fast) - rebo2.evaluate_each_bond(carbon.positions, slow);
  EXPECT_NEAR(difference, 0, 1e-9 * static_cast<double>(carbon.size()));
  for (std::size_t a = 0; a < carbon.size(); ++a) EXPECT_LT((fast[a] - slow[a]).norm(), 1e-7);
}

// On a surface whose ends are bare nothing is added.
TEST(OpenAtoms, WithoutHydrogenEndsAreEachForThemselves) {
  const Molecule carbon = structures::open_tube(6, 6, 12.0);
  FixedBondRebo2 bare;
  bare.set_graph(fixed_bond_graph(carbon));
  std::vector<Vec3> unused(carbon.size(), Vec3::Zero());
  FixedBondRebo2 hydrogen = with_hydrogen(carbon);
  EXPECT_GT(std::abs(bare.evaluate(carbon.positions, unused) - hydrogen.evaluate(carbon.positions, unused)),
            1.0);
}

}  // namespace
}  // namespace nanocarbon::annealing
