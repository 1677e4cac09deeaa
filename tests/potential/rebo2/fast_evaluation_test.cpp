// SPDX-License-Identifier: GPL-2.0-or-later
// The fast loops against the general terms, which are themselves held against LAMMPS.
#include <gmock/gmock.h>

#include <random>

#include "nanocarbon/core/error.h"
#include "nanocarbon/potential/rebo2/rebo2.h"
#include "nanocarbon/potential/rebo2/kernels/sp2_dispatch.h"
#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/structures/graphene.h"
#include "nanocarbon/structures/schwarzite.h"
#include "nanocarbon/structures/tube.h"
#include "potential/rebo2/comparison_structures.h"

namespace nanocarbon::rebo2 {
namespace {

class FastEvaluation : public testing::TestWithParam<const Sp2Kernel*> {
 protected:
  Rebo2 fast_{rebo2_parameters(), GetParam()->name};
  Rebo2 general_;

  void expect_same(const Molecule& m) {
    const Cell* cell = m.cell ? &*m.cell : nullptr;
    const Rebo2Result& a = fast_.evaluate(m.positions, m.elements, cell, {.atom_energies = true});
    const Rebo2Result& b =
        general_.evaluate(m.positions, m.elements, cell, {.general_only = true, .atom_energies = true});
    const double scale = static_cast<double>(m.size());
    EXPECT_NEAR(a.energy, b.energy, 1e-12 * scale);
    EXPECT_NEAR(a.parts.repulsive, b.parts.repulsive, 1e-12 * scale);
    EXPECT_NEAR(a.parts.sigma_pi, b.parts.sigma_pi, 1e-12 * scale);
    EXPECT_NEAR(a.parts.conjugation, b.parts.conjugation, 1e-12 * scale);
    EXPECT_NEAR(a.parts.dihedral, b.parts.dihedral, 1e-12 * scale);
    EXPECT_LT((a.virial - b.virial).cwiseAbs().maxCoeff(), 1e-11 * scale);
    for (std::size_t i = 0; i < m.size(); ++i) {
      ASSERT_LT((a.forces[i] - b.forces[i]).lpNorm<Eigen::Infinity>(), 1e-10) << "atom " << i;
      ASSERT_NEAR(a.atom_energies[i], b.atom_energies[i], 1e-11) << "atom " << i;
    }
  }
};

//! Puts a hydrogen above every n-th atom of a molecule around the origin.
Molecule hydrogenated(Molecule m, std::size_t n) {
  for (std::size_t i = n / 2, carbons = m.size(); i < carbons; i += n) {
    m.positions.push_back(m.positions[i] + 1.1 * m.positions[i].normalized());
    m.elements.push_back(Element::hydrogen);
  }
  return m;
}

Molecule without_atom(Molecule m, std::size_t i) {
  m.positions.erase(m.positions.begin() + static_cast<std::ptrdiff_t>(i));
  m.elements.erase(m.elements.begin() + static_cast<std::ptrdiff_t>(i));
  return m;
}

TEST_P(FastEvaluation, TakesEveryAtomOfWholeSheetsAndCages) {
  for (Molecule m : {structures::graphene(4, 3), structures::fullerene(1, 1), structures::fullerene(3, 2),
                     structures::periodic_tube(6, 5, 1), structures::schwarzite_d688(1, 1, 1)}) {
    expect_same(m);
    EXPECT_EQ(fast_.general_atoms(), 0u);
    test::rattle(m, 0.03, 5);
    expect_same(m);
    EXPECT_EQ(fast_.general_atoms(), 0u);
  }
}

TEST_P(FastEvaluation, MixesWithTheGeneralTermsWithoutATrace) {
  for (const Molecule& whole :
       {structures::graphene(4, 3), hydrogenated(structures::fullerene(2, 2), 9),
        hydrogenated(structures::fullerene(1, 1), 4), without_atom(structures::graphene(5, 3), 17),
        structures::graphene_flake(9.0), structures::open_tube(5, 4, 12.0)})
    for (const double distance : {0.0, 0.1, 0.2, 0.3}) {
      Molecule m = whole;
      test::rattle(m, distance, 11);
      expect_same(m);
      EXPECT_LE(fast_.general_atoms(), m.size());
    }
}

TEST_P(FastEvaluation, NothingHappensWhereABondEntersItsWindow) {
  Molecule m = structures::fullerene(2, 2);
  const Rebo2Result before = fast_.evaluate(m.positions, m.elements);
  const Vec3 axis = (m.positions[m.bonds[0].second] - m.positions[m.bonds[0].first]).normalized();
  const double start = (m.positions[m.bonds[0].second] - m.positions[m.bonds[0].first]).norm();
  const auto stretched = [&](double length) {
    Molecule n = m;
    n.positions[n.bonds[0].second] += (length - start) * axis;
    expect_same(n);
    return fast_.evaluate(n.positions, n.elements);
  };
  const Rebo2Result inside = stretched(1.7 - 1e-9);
  EXPECT_EQ(fast_.general_atoms(), 0u);
  const Rebo2Result beyond = stretched(1.7 + 1e-9);
  EXPECT_GT(fast_.general_atoms(), 0u);
  EXPECT_GT(std::abs(inside.energy - before.energy), 0.1);
  // 2e-9 Angstrom times forces below 30 eV/Angstrom, and times a stiffness below 1e3 eV/Angstrom^2.
  EXPECT_NEAR(inside.energy, beyond.energy, 6e-8);
  for (std::size_t i = 0; i < m.size(); ++i) EXPECT_LT((inside.forces[i] - beyond.forces[i]).norm(), 2e-6);
}

TEST_P(FastEvaluation, KeepsItsListsWhileAtomsMoveLittle) {
  Molecule m = hydrogenated(structures::fullerene(2, 1), 20);
  std::mt19937_64 random(3);
  for (int step = 0; step < 60; ++step) {
    for (Vec3& p : m.positions)
      for (double& x : p) x += 0.03 * (static_cast<double>(random() >> 11) * 0x1.0p-53 - 0.5);
    expect_same(m);
  }
  EXPECT_LT(fast_.list_builds(), 30u);
}

INSTANTIATE_TEST_SUITE_P(Kernel, FastEvaluation, testing::ValuesIn(usable_sp2_kernels()),
                         [](const auto& kernel) { return std::string(kernel.param->name); });

TEST(Rebo2, RefusesInstructionsThatAreNotThere) { EXPECT_THROW(Rebo2(rebo2_parameters(), "mmx"), UserError); }

}  // namespace
}  // namespace nanocarbon::rebo2
