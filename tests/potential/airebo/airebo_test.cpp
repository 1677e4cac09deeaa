// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/airebo/airebo.h"

#include <gmock/gmock.h>

#include <random>

#include "nanocarbon/structures/diamond.h"
#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/structures/hydrocarbons.h"
#include "potential/airebo/reference.h"
#include "potential/rebo2/comparison_structures.h"

namespace nanocarbon::airebo {
namespace {

using test::airebo_reference;
using test::airebo_style;
using test::random_cluster;
using test::rattle;

const Cell* cell_of(const Molecule& m) { return m.cell ? &*m.cell : nullptr; }

TEST(Airebo, AgreesWithLammpsOnEveryStructureOfTheTable) {
  for (const test::AireboReferenceStructure& s : airebo_reference())
    for (const test::AireboReference& r : s.references) {
      SCOPED_TRACE(s.name + ", " + r.style);
      const auto [parameters, terms] = airebo_style(r.style);
      Airebo airebo(*parameters, terms);
      const AireboResult& ours =
          airebo.evaluate(s.molecule.positions, s.molecule.elements, cell_of(s.molecule));
      const bool switches = test::is_in_switches(s.name);
      const double tolerance = (switches ? 1e-8 : 1e-10) * std::abs(r.total());
      EXPECT_NEAR(ours.energy_parts.rebo(), r.rebo, tolerance);
      EXPECT_NEAR(ours.energy_parts.long_range, r.long_range, tolerance);
      EXPECT_NEAR(ours.energy_parts.torsion(), r.torsion, tolerance);
      EXPECT_NEAR(ours.energy, r.total(), tolerance);
      EXPECT_LT((ours.virial - r.virial).cwiseAbs().maxCoeff(),
                (switches ? 1e-6 : 1e-8) * std::sqrt(static_cast<double>(s.molecule.size())) * 10.0);
      double largest = 100.0;
      for (const Vec3& f : r.forces) largest = std::max(largest, f.norm());
      for (std::size_t i = 0; i < r.forces.size(); ++i)
        EXPECT_LT((ours.forces[i] - r.forces[i]).norm(), switches ? 1e-8 * largest : 1e-8) << i;
    }
}

//! The largest difference between forces and slopes of the energy by fourth-order differences.
double worst_force(const Molecule& m, const AireboParameters& parameters) {
  Airebo airebo(parameters);
  const std::vector<Vec3> forces = airebo.evaluate(m.positions, m.elements, cell_of(m)).forces;
  constexpr double h = 2e-4;
  double worst = 0.0;
  std::vector<Vec3> x = m.positions;
  for (std::size_t i = 0; i < x.size(); ++i)
    for (int d = 0; d < 3; ++d) {
      const auto energy_at = [&](double step) {
        x[i][d] = m.positions[i][d] + step;
        const double energy = airebo.evaluate(x, m.elements, cell_of(m)).energy;
        x[i][d] = m.positions[i][d];
        return energy;
      };
      const double slope =
          (8.0 * (energy_at(h) - energy_at(-h)) - (energy_at(2.0 * h) - energy_at(-2.0 * h))) / (12.0 * h);
      worst = std::max(worst, std::abs(forces[i][d] + slope));
    }
  return worst;
}

TEST(Airebo, ForcesAreTheSlopesOfTheEnergy) {
  for (const AireboParameters* parameters : {&airebo_parameters(), &airebo_m_parameters()}) {
    Molecule benzenes = structures::benzene();
    const Molecule other = structures::benzene();
    for (std::size_t i = 0; i < other.size(); ++i) {
      benzenes.positions.push_back(other.positions[i] + Vec3(0.7, 0.3, 3.0));
      benzenes.elements.push_back(other.elements[i]);
    }
    rattle(benzenes, 0.1, 3);
    EXPECT_LT(worst_force(benzenes, *parameters), 1e-7);
    Molecule cell = structures::diamond(1, 1, 1);
    rattle(cell, 0.1, 5);
    EXPECT_LT(worst_force(cell, *parameters), 1e-7);
  }
}

// Dense clusters have most pairs within some switch. Differences across a kink (a tie of two paths, a knot of
// g) are not slopes, so a few may be off.
TEST(Airebo, ForcesOfClustersAreTheSlopesOfTheEnergy) {
  int off = 0;
  for (unsigned seed = 1; seed <= 60; ++seed)
    off += worst_force(random_cluster(seed), airebo_parameters()) > 2e-6;
  EXPECT_LE(off, 3);
}

TEST(Airebo, RepeatingACellRepeatsItsEnergyAndForces) {
  for (const bool morse : {false, true}) {
    Airebo airebo(morse ? airebo_m_parameters() : airebo_parameters());
    Molecule small = structures::diamond(1, 1, 1);
    rattle(small, 0.1, 11);
    Molecule large = small;
    large.positions.clear();
    large.elements.clear();
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 3; ++b)
        for (std::size_t i = 0; i < small.size(); ++i) {
          large.positions.push_back(small.positions[i] + image_shift(*small.cell, {a, b, 0}));
          large.elements.push_back(small.elements[i]);
        }
    large.cell->vectors.col(0) *= 2.0;
    large.cell->vectors.col(1) *= 3.0;
    const AireboResult one = airebo.evaluate(small.positions, small.elements, cell_of(small));
    const AireboResult& six = airebo.evaluate(large.positions, large.elements, cell_of(large));
    EXPECT_NEAR(six.energy_parts.long_range, 6.0 * one.energy_parts.long_range, 1e-11 * std::abs(six.energy));
    EXPECT_NEAR(six.energy_parts.torsion(), 6.0 * one.energy_parts.torsion(), 1e-11 * std::abs(six.energy));
    EXPECT_NEAR(six.energy, 6.0 * one.energy, 1e-11 * std::abs(six.energy));
    EXPECT_LT((six.virial - 6.0 * one.virial).cwiseAbs().maxCoeff(), 1e-9);
    for (std::size_t i = 0; i < large.size(); ++i)
      EXPECT_LT((six.forces[i] - one.forces[i % small.size()]).norm(), 1e-10);
  }
}

TEST(Airebo, SharesOfAtomsAddUp) {
  Airebo airebo;
  for (unsigned seed = 100; seed < 130; ++seed) {
    const Molecule m = random_cluster(seed);
    const AireboResult& r =
        airebo.evaluate(m.positions, m.elements, nullptr, {.atom_energies = true, .atom_virials = true});
    double energy = 0.0;
    Mat3 virial = Mat3::Zero();
    for (const double e : r.atom_energies) energy += e;
    for (const Mat3& v : r.atom_virials) virial += v;
    EXPECT_NEAR(energy, r.energy, 1e-11 * (1.0 + std::abs(r.energy)));
    EXPECT_LT((virial - r.virial).cwiseAbs().maxCoeff(), 1e-9 * (1.0 + r.virial.cwiseAbs().maxCoeff()));
  }
}

TEST(Airebo, KeepsItsListsWhileAtomsMoveLittle) {
  Molecule m = structures::fullerene(1, 1);
  Airebo kept;
  kept.evaluate(m.positions, m.elements);
  for (unsigned step = 0; step < 12; ++step) {
    rattle(m, 0.12, 20 + step);
    const double energy = kept.evaluate(m.positions, m.elements).energy;
    Airebo fresh;
    EXPECT_NEAR(energy, fresh.evaluate(m.positions, m.elements).energy, 1e-11 * std::abs(energy));
  }
  EXPECT_GT(kept.list_builds(), 1u);
  EXPECT_LT(kept.list_builds(), 12u);
}

TEST(Airebo, IsIndependentOfWhereAtomsAreGiven) {
  Molecule m = structures::diamond(2, 1, 1);
  rattle(m, 0.1, 2);
  Airebo airebo;
  const AireboResult before = airebo.evaluate(m.positions, m.elements, cell_of(m));
  Molecule moved = m;
  for (std::size_t i = 0; i < m.size(); ++i)
    moved.positions[i] += image_shift(*m.cell, {static_cast<int>(i % 5) - 2, static_cast<int>(i % 3), -1});
  const AireboResult& after = airebo.evaluate(moved.positions, moved.elements, cell_of(moved));
  EXPECT_NEAR(after.energy, before.energy, 1e-11 * std::abs(before.energy));
  for (std::size_t i = 0; i < m.size(); ++i) EXPECT_LT((after.forces[i] - before.forces[i]).norm(), 1e-10);
}

TEST(Airebo, HasNothingToSayOfNoAtomsOrOne) {
  Airebo airebo;
  EXPECT_EQ(airebo.evaluate({}, {}).energy, 0.0);
  const std::vector<Vec3> one = {Vec3(1.0, 2.0, 3.0)};
  const std::vector<Element> carbon = {Element::carbon};
  EXPECT_EQ(airebo.evaluate(one, carbon).energy, 0.0);
}

}  // namespace
}  // namespace nanocarbon::airebo
