// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/fixed_bond_rebo2.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "nanocarbon/annealing/network_guards.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/minimisation/lbfgs.h"
#include "nanocarbon/structures/fullerene.h"

namespace nanocarbon::annealing {
namespace {

Molecule rattled(Molecule molecule, double amplitude) {
  std::mt19937_64 random(5);
  for (Vec3& p : molecule.positions)
    for (int d = 0; d < 3; ++d) p[d] += amplitude * (static_cast<double>(random() >> 11) * 0x1p-52 - 1);
  return molecule;
}

// Energies at rest as LAMMPS's pair_style rebo gives them (CH.rebo, 29 Sep 2021), eV/atom.
struct Known {
  int h, k;
  double energy;
};

class FixedBondRebo2OfFullerenes : public testing::TestWithParam<Known> {};

TEST_P(FixedBondRebo2OfFullerenes, MinimaAreThoseOfTheFullPotential) {
  Molecule molecule = structures::fullerene(GetParam().h, GetParam().k);
  FixedBondRebo2 rebo2;
  rebo2.set_graph(fixed_bond_graph(molecule));
  const minimisation::LbfgsResult relaxed =
      minimisation::minimise_lbfgs(molecule.positions, [&](auto x, auto g) { return rebo2.evaluate(x, g); },
                                   {.max_iterations = 2000, .force_tolerance = 1e-7});
  EXPECT_TRUE(relaxed.converged);
  EXPECT_NEAR(relaxed.energy / static_cast<double>(molecule.size()), GetParam().energy, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Icosahedral, FixedBondRebo2OfFullerenes,
                         testing::Values(Known{1, 1, -6.8420645371}, Known{2, 2, -7.2050937785},
                                         Known{3, 3, -7.2946542624}));

TEST(FixedBondRebo2, ForcesAreTheSlopeOfTheEnergy) {
  const Molecule molecule = rattled(structures::fullerene(2, 0), 0.12);
  FixedBondRebo2 rebo2;
  rebo2.set_graph(fixed_bond_graph(molecule));
  std::vector<Vec3> gradient(molecule.size(), Vec3::Zero()), unused = gradient;
  rebo2.evaluate(molecule.positions, gradient);
  for (std::size_t a = 0; a < molecule.size(); a += 7)
    for (int d = 0; d < 3; ++d) {
      const double h = 1e-5;
      std::vector<Vec3> moved = molecule.positions;
      moved[a][d] += h;
      const double ahead = rebo2.evaluate(moved, unused);
      moved[a][d] -= 2 * h;
      const double behind = rebo2.evaluate(moved, unused);
      EXPECT_NEAR(gradient[a][d], (ahead - behind) / (2 * h), 2e-7) << "atom " << a;
    }
}

TEST(FixedBondRebo2, BondsStayHoweverFarTheyAreStretched) {
  Molecule molecule = structures::fullerene(1, 1);
  FixedBondRebo2 rebo2;
  rebo2.set_graph(fixed_bond_graph(molecule));
  for (Vec3& p : molecule.positions) p *= 1.6;  // every bond beyond the cut-off of 2.0 Angstrom
  std::vector<Vec3> gradient(molecule.size(), Vec3::Zero());
  rebo2.evaluate(molecule.positions, gradient);
  for (std::size_t a = 0; a < molecule.size(); ++a) EXPECT_GT(gradient[a].dot(molecule.positions[a]), 0) << a;
}

// Both ways share no code but the parameters.
void expect_both_ways_agree(FixedBondRebo2& rebo2, std::span<const Vec3> positions) {
  std::vector<Vec3> loops(positions.size(), Vec3::Zero()), each = loops;
  const double by_loops = rebo2.evaluate(positions, loops);
  const double by_bonds = rebo2.evaluate_each_bond(positions, each);
  EXPECT_NEAR(by_loops, by_bonds, 1e-9 * static_cast<double>(positions.size()));
  for (std::size_t a = 0; a < positions.size(); ++a) EXPECT_LT((loops[a] - each[a]).norm(), 1e-7) << a;
}

TEST(FixedBondRebo2, LoopsAgreeWithBondByBond) {
  for (const double amplitude : {0.0, 0.05, 0.15}) {
    const Molecule molecule = rattled(structures::fullerene(2, 1), amplitude);
    FixedBondRebo2 rebo2;
    rebo2.set_graph(fixed_bond_graph(molecule));
    expect_both_ways_agree(rebo2, molecule.positions);
  }
}

// A cap with a rim: atoms with one and two bonds among the others.
TEST(FixedBondRebo2, LoopsAgreeWithBondByBondAtBoundaries) {
  Molecule molecule = rattled(structures::fullerene(2, 1), 0.05);
  std::erase_if(molecule.bonds, [&](const Bond& b) {
    return molecule.positions[b.first].z() < 0 || molecule.positions[b.second].z() < 0;
  });
  FixedBondRebo2 rebo2;
  rebo2.set_graph(fixed_bond_graph(molecule));
  expect_both_ways_agree(rebo2, molecule.positions);
}

TEST(FixedBondRebo2, AtomsShareTheEnergyOfTheirBonds) {
  const Molecule molecule = rattled(structures::fullerene(2, 1), 0.05);
  FixedBondGraph graph = fixed_bond_graph(molecule);
  FixedBondRebo2 whole, part;
  whole.set_graph(graph);
  graph.inner = molecule.size() / 2;  // the other half only lends its positions
  part.set_graph(graph);
  expect_both_ways_agree(part, molecule.positions);
  std::vector<Vec3> unused(molecule.size(), Vec3::Zero());
  // Half of the energy but for the dihedrals of the cut bonds, which are small.
  const double all = whole.evaluate(molecule.positions, unused);
  EXPECT_NEAR(part.evaluate(molecule.positions, unused), 0.5 * all, 0.01 * std::abs(all));
}

// Molecules of several chunks, where only what is around such atoms is evaluated bond by bond.
class FarStretchedAtoms : public testing::Test {
 protected:
  FarStretchedAtoms() : molecule(rattled(structures::fullerene(7, 7), 0.03)) {
    for (const AtomIndex a : {5u, 6u, 900u, 2047u, 2048u, 2900u}) molecule.positions[a] *= 1.05;
    molecule.positions[1500] *= 0.94;
  }
  void set_graph(bool hydrogen = false) {
    FixedBondGraph graph = fixed_bond_graph(molecule);
    graph.hydrogen = hydrogen;
    rebo2.set_graph(graph);
    ASSERT_GT(rebo2.chunks().count(), 1u);
  }
  double longest_bond() const {
    double longest = 0;
    for (const Bond& b : molecule.bonds)
      longest = std::max(longest, (molecule.positions[b.first] - molecule.positions[b.second]).norm());
    return longest;
  }

  Molecule molecule;
  FixedBondRebo2 rebo2;
};

TEST_F(FarStretchedAtoms, AgreeWithBondByBond) {
  ASSERT_GT(longest_bond(), 2.0);
  set_graph();
  expect_both_ways_agree(rebo2, molecule.positions);
}

TEST_F(FarStretchedAtoms, AgreeWithBondByBondNextToBoundaries) {
  std::erase_if(molecule.bonds, [](const Bond& b) { return (b.first + b.second) % 11 == 0; });
  for (const bool hydrogen : {false, true}) {
    set_graph(hydrogen);
    expect_both_ways_agree(rebo2, molecule.positions);
  }
}

TEST_F(FarStretchedAtoms, GuardsAreTheSameWhereOnlyStrainedAtomsAreLookedAt) {
  std::erase_if(molecule.bonds, [](const Bond& b) { return (b.first + b.second) % 11 == 0; });
  set_graph();
  std::vector<Vec3> together(molecule.size(), Vec3::Zero()), apart = together;
  const double guarded = rebo2.evaluate_guarded(molecule.positions, together);
  const double guards = add_guards(rebo2.graph(), molecule.positions, apart);
  EXPECT_GT(guards, 0.1);
  EXPECT_NEAR(guarded, guards + rebo2.evaluate(molecule.positions, apart), 1e-8);
  for (std::size_t a = 0; a < molecule.size(); ++a) EXPECT_LT((together[a] - apart[a]).norm(), 1e-9) << a;
}

TEST_F(FarStretchedAtoms, AnyNumberOfThreadsGivesTheSameBits) {
  set_graph();
  std::vector<Vec3> alone(molecule.size(), Vec3::Zero());
  const double energy = rebo2.evaluate_guarded(molecule.positions, alone);
  for (const unsigned threads : {2u, 3u}) {
    ThreadTeam team(threads);
    std::vector<Vec3> shared(molecule.size(), Vec3::Zero());
    EXPECT_EQ(rebo2.evaluate_guarded(molecule.positions, shared, &team), energy);
    EXPECT_EQ(shared, alone);
  }
}

TEST(FixedBondRebo2, AFourthBondIsRefused) {
  Molecule molecule;
  molecule.positions.assign(5, Vec3::Zero());
  molecule.elements.assign(5, Element::carbon);
  molecule.bonds = {{0, 1}, {0, 2}, {0, 3}, {0, 4}};
  EXPECT_THROW(fixed_bond_graph(molecule), UserError);
}

}  // namespace
}  // namespace nanocarbon::annealing
