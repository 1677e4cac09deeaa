// SPDX-License-Identifier: GPL-2.0-or-later
// AIREBO's torsion energy: formulas and differences of the energy for the general terms, and these for the
// fast loops.
#include "nanocarbon/potential/rebo2/torsion_energy.h"

#include <gmock/gmock.h>

#include "nanocarbon/potential/periodic_copies.h"
#include "nanocarbon/potential/rebo2/mixed_evaluation.h"
#include "nanocarbon/potential/rebo2/kernels/sp2_dispatch.h"
#include "nanocarbon/structures/diamond.h"
#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/structures/graphene.h"
#include "nanocarbon/structures/hydrocarbons.h"
#include "nanocarbon/structures/schwarzite.h"
#include "nanocarbon/structures/tube.h"
#include "potential/rebo2/comparison_structures.h"

namespace nanocarbon::rebo2 {
namespace {

constexpr TorsionBarriers barriers = {{0.3078851086, 0.1786600912, 0.1249753356}};

//! REBO2's, but P_CC(2, 0) as AIREBO has it.
Rebo2Parameters parameters() {
  Rebo2Parameters p = rebo2_parameters();
  BicubicTable::Knots knots;
  for (int c = 0; c < 5; ++c)
    for (int h = 0; h < 5; ++h) knots[c][h] = p.tables.p_cc.evaluate(c, h).value;
  knots[2][0] = -0.0276030;
  p.tables.p_cc = BicubicTable(knots);
  return p;
}

struct Evaluated {
  EnergyParts parts;
  std::vector<Vec3> forces;
  std::vector<double> atom_energies;
  std::size_t general_atoms;
};

Evaluated evaluate(const Molecule& m, const Sp2Kernel& kernel, bool general_only) {
  const Cell* cell = m.cell ? &*m.cell : nullptr;
  const potential::NearAtoms near = potential::find_near_atoms(m.positions, cell, 2.3);
  std::vector<double> coordinates;
  potential::place_atoms(m.positions, cell, near, coordinates);
  std::vector<Element> elements = m.elements;
  for (const potential::PeriodicCopy& copy : near.copies) elements.push_back(m.elements[copy.of]);
  Evaluated e;
  e.forces.assign(elements.size(), Vec3::Zero());
  e.atom_energies.assign(elements.size(), 0.0);
  potential::AtomShares shares;
  // The loops do not share torsion energy out: with energies of atoms all of it would be general.
  if (general_only) shares.energies = e.atom_energies.data();
  MixedEvaluation evaluation(parameters(), kernel, barriers);
  e.parts = evaluation.evaluate(
      {coordinates.data(), elements.data(), near.own, static_cast<std::uint32_t>(elements.size())},
      near.pairs, e.forces.front().data(), shares, general_only);
  e.general_atoms = evaluation.general_atoms();
  for (std::size_t c = 0; c < near.copies.size(); ++c) {
    e.forces[near.copies[c].of] += e.forces[near.own + c];
    e.atom_energies[near.copies[c].of] += e.atom_energies[near.own + c];
  }
  e.forces.resize(near.own);
  e.atom_energies.resize(near.own);
  return e;
}

Evaluated evaluate_generally(const Molecule& m) { return evaluate(m, *usable_sp2_kernels().front(), true); }

double torsion(double cosine) { return 256.0 / 405.0 * std::pow(0.5 * (1.0 + cosine), 5) - 0.1; }

//! Two cis and two trans dihedrals around each bond.
TEST(TorsionEnergy, OfFlatGrapheneIsThatOfItsCisAndTransDihedrals) {
  const Molecule sheet = structures::graphene(3, 2);
  EXPECT_NEAR(evaluate_generally(sheet).parts.torsion / static_cast<double>(sheet.size()),
              1.5 * barriers.barriers[0] * 2.0 * (torsion(1.0) + torsion(-1.0)), 1e-12);
}

TEST(TorsionEnergy, OfDiamondVanishes) {
  const Molecule crystal = structures::diamond(2, 2, 2);
  // Staggered: three trans and six gauche dihedrals around each bond.
  EXPECT_NEAR(evaluate_generally(crystal).parts.torsion / static_cast<double>(crystal.size()),
              2.0 * barriers.barriers[0] * (3.0 * torsion(-1.0) + 6.0 * torsion(0.5)), 1e-10);
  EXPECT_NEAR(3.0 * torsion(-1.0) + 6.0 * torsion(0.5), 0.0, 1e-12);
}

TEST(TorsionEnergy, OfEthyleneHasTheBarrierOfHydrogens) {
  const Molecule m = structures::ethylene();
  EXPECT_NEAR(evaluate_generally(m).parts.torsion,
              barriers.barriers[2] * 2.0 * (torsion(1.0) + torsion(-1.0)), 1e-9);
}

TEST(TorsionEnergy, ForcesAreItsDifferences) {
  std::vector<Molecule> molecules = {structures::ethane(), structures::cyclopropane(), structures::benzene(),
                                     structures::acetylene()};
  for (unsigned seed = 1; seed <= 20; ++seed) molecules.push_back(test::random_cluster(seed));
  for (Molecule& m : molecules) {
    test::rattle(m, 0.1, 7);
    const std::vector<Vec3> forces = evaluate_generally(m).forces;
    for (std::size_t i = 0; i < m.size(); ++i)
      for (int d = 0; d < 3; ++d) {
        constexpr double step = 1e-6;
        const double here = m.positions[i][d];
        m.positions[i][d] = here + step;
        const double up = evaluate_generally(m).parts.total();
        m.positions[i][d] = here - step;
        const double down = evaluate_generally(m).parts.total();
        m.positions[i][d] = here;
        EXPECT_NEAR(forces[i][d], (down - up) / (2.0 * step), 2e-5);
      }
  }
}

class FastTorsion : public testing::TestWithParam<const Sp2Kernel*> {
 protected:
  std::size_t expect_same(const Molecule& m) {
    const Evaluated a = evaluate(m, *GetParam(), false);
    const Evaluated b = evaluate_generally(m);
    const double scale = static_cast<double>(m.size());
    EXPECT_NEAR(a.parts.repulsive, b.parts.repulsive, 1e-12 * scale);
    EXPECT_NEAR(a.parts.sigma_pi, b.parts.sigma_pi, 1e-12 * scale);
    EXPECT_NEAR(a.parts.conjugation, b.parts.conjugation, 1e-12 * scale);
    EXPECT_NEAR(a.parts.dihedral, b.parts.dihedral, 1e-12 * scale);
    EXPECT_NEAR(a.parts.torsion, b.parts.torsion, 1e-12 * scale);
    EXPECT_GT(std::abs(b.parts.torsion), 0.01 * scale);
    for (std::size_t i = 0; i < m.size(); ++i) {
      EXPECT_LT((a.forces[i] - b.forces[i]).lpNorm<Eigen::Infinity>(), 1e-10) << "atom " << i;
    }
    return a.general_atoms;
  }
};

TEST_P(FastTorsion, TakesEveryAtomOfWholeSheetsAndCages) {
  for (Molecule m : {structures::graphene(4, 3), structures::fullerene(1, 1), structures::fullerene(3, 2),
                     structures::periodic_tube(6, 5, 1), structures::schwarzite_d688(1, 1, 1)}) {
    EXPECT_EQ(expect_same(m), 0u);
    test::rattle(m, 0.03, 5);
    EXPECT_EQ(expect_same(m), 0u);
  }
}

TEST_P(FastTorsion, MixesWithTheGeneralTermsWithoutATrace) {
  for (const Molecule& whole : {structures::graphene(4, 3), structures::fullerene(2, 2),
                                structures::graphene_flake(9.0), structures::open_tube(5, 4, 12.0)})
    for (const double distance : {0.0, 0.1, 0.2, 0.3}) {
      Molecule m = whole;
      for (std::size_t i = 5, carbons = m.size(); !m.cell && i < carbons; i += 13) {
        m.positions.push_back(m.positions[i] + 1.1 * (m.positions[i] + Vec3(0, 0, 1)).normalized());
        m.elements.push_back(Element::hydrogen);
      }
      test::rattle(m, distance, 11);
      EXPECT_LT(expect_same(m), m.size());
    }
}

INSTANTIATE_TEST_SUITE_P(Kernel, FastTorsion, testing::ValuesIn(usable_sp2_kernels()),
                         [](const auto& kernel) { return std::string(kernel.param->name); });

}  // namespace
}  // namespace nanocarbon::rebo2
