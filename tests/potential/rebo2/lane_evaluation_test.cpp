// SPDX-License-Identifier: GPL-2.0-or-later
// The lane loops against the general terms, which are themselves held against LAMMPS.
#include "nanocarbon/potential/rebo2/lane_evaluation.h"

#include <gmock/gmock.h>

#include <numbers>

#include "nanocarbon/potential/periodic_copies.h"
#include "nanocarbon/potential/rebo2/general_evaluation.h"
#include "nanocarbon/potential/rebo2/kernels/sp2_dispatch.h"
#include "potential/rebo2/comparison_structures.h"

namespace nanocarbon::rebo2 {
namespace {

constexpr TorsionBarriers barriers = {{0.3078851086, 0.1786600912, 0.1249753356}};

struct Evaluated {
  EnergyParts energy;
  std::vector<double> forces;
  std::vector<double> atom_energies;
};

//! A structure with its copies.
struct Surroundings {
  explicit Surroundings(const Molecule& m)
      : near(potential::find_near_atoms(m.positions, m.cell ? &*m.cell : nullptr, 2.4)),
        elements(m.elements) {
    potential::place_atoms(m.positions, m.cell ? &*m.cell : nullptr, near, positions);
    for (const potential::PeriodicCopy& copy : near.copies) elements.push_back(m.elements[copy.of]);
  }
  potential::AtomsView view() const {
    return {positions.data(), elements.data(), near.own, static_cast<std::uint32_t>(elements.size())};
  }
  //! Other positions, for which the near pairs are good still.
  void move(const Molecule& m) {
    potential::place_atoms(m.positions, m.cell ? &*m.cell : nullptr, near, positions);
  }

  potential::NearAtoms near;
  std::vector<double> positions;
  std::vector<Element> elements;
};

//! \param torsion whether with AIREBO's torsion energy, which energies of single atoms do not go with
struct Case {
  const Sp2Kernel* kernel;
  bool torsion;
};

class LaneEvaluationOf : public testing::TestWithParam<Case> {
 protected:
  std::optional<TorsionBarriers> torsion_ = GetParam().torsion ? std::optional(barriers) : std::nullopt;
  LaneEvaluation lanes_{rebo2_parameters(), *GetParam().kernel->any, torsion_};

  std::optional<Evaluated> evaluate(const Surroundings& s) {
    lanes_.near_changed(s.view(), s.near.pairs);
    return evaluate_again(s);
  }

  std::optional<Evaluated> evaluate_again(const Surroundings& s) {
    Evaluated result = {{}, std::vector<double>(s.positions.size()), std::vector<double>(s.elements.size())};
    const auto energy =
        lanes_.evaluate(s.view(), result.forces.data(), torsion_ ? nullptr : result.atom_energies.data());
    if (!energy) return {};
    result.energy = *energy;
    return result;
  }

  Evaluated evaluate_by_terms(const Surroundings& s) const {
    Evaluated result = {{}, std::vector<double>(s.positions.size()), std::vector<double>(s.elements.size())};
    GeneralWorkspace workspace;
    potential::AtomShares shares;
    if (!torsion_) shares.energies = result.atom_energies.data();
    result.energy =
        evaluate_general(s.view(), s.near.pairs, Model(rebo2_parameters(), torsion_ ? &*torsion_ : nullptr),
                         workspace, result.forces.data(), shares);
    return result;
  }

  void expect_same(const Molecule& m, const std::string& name) {
    const Surroundings s(m);
    expect_same(s, evaluate(s), m.size(), name);
  }

  void expect_same(const Surroundings& s, const std::optional<Evaluated>& found, std::size_t atoms,
                   const std::string& name) {
    ASSERT_TRUE(found) << name;
    const Evaluated expected = evaluate_by_terms(s);
    const double scale = 1e-12 * static_cast<double>(atoms);
    EXPECT_NEAR(found->energy.repulsive, expected.energy.repulsive, scale) << name;
    EXPECT_NEAR(found->energy.sigma_pi, expected.energy.sigma_pi, scale) << name;
    EXPECT_NEAR(found->energy.conjugation, expected.energy.conjugation, scale) << name;
    EXPECT_NEAR(found->energy.dihedral, expected.energy.dihedral, scale) << name;
    EXPECT_NEAR(found->energy.torsion, expected.energy.torsion, scale) << name;
    for (std::size_t i = 0; i < expected.forces.size(); ++i)
      ASSERT_NEAR(found->forces[i], expected.forces[i], 1e-10 * std::max(1.0, std::abs(expected.forces[i])))
          << name << ", component " << i;
    for (std::size_t i = 0; i < expected.atom_energies.size(); ++i)
      ASSERT_NEAR(found->atom_energies[i], expected.atom_energies[i], 1e-11) << name << ", atom " << i;
  }
};

TEST_P(LaneEvaluationOf, GivesWhatTheGeneralTermsGiveForCrystalsMoleculesAndClusters) {
  for (const test::ComparisonStructure& structure : test::comparison_structures())
    expect_same(structure.molecule, structure.name);
}

// Forces from energies alone, whatever the general terms say.
TEST_P(LaneEvaluationOf, ForcesAreTheSlopeOfTheEnergy) {
  for (const unsigned seed : {3u, 17u, 40u}) {
    Molecule m = test::random_cluster(seed);
    const auto at_rest = evaluate(Surroundings(m));
    ASSERT_TRUE(at_rest);
    constexpr double step = 1e-5;
    for (std::size_t i = 0; i < m.size(); ++i)
      for (int d = 0; d < 3; ++d) {
        const auto energy_at = [&](double shift) {
          Molecule moved = m;
          moved.positions[i][d] += shift;
          return evaluate(Surroundings(moved))->energy.total();
        };
        const double slope = (energy_at(step) - energy_at(-step)) / (2.0 * step);
        EXPECT_NEAR(at_rest->forces[3 * i + d], -slope, 1e-6 * std::max(10.0, std::abs(slope)));
      }
  }
}

// Bonds are remembered from step to step where all are whole. Atoms move until bonds stretch, break and form.
TEST_P(LaneEvaluationOf, RemembersBondsUntilTheyChange) {
  std::size_t steps = 0;
  for (const test::ComparisonStructure& structure : test::comparison_structures()) {
    Surroundings s(structure.molecule);
    lanes_.near_changed(s.view(), s.near.pairs);
    for (const double amplitude : {0.0, 0.01, 0.02, 0.1, 0.02, 0.18, 0.0, 0.01}) {
      Molecule moved = structure.molecule;
      for (std::size_t i = 0; i < moved.size(); ++i)
        moved.positions[i] +=
            amplitude * Vec3(std::sin(1.3 * i), std::sin(2.1 * i), std::sin(0.7 * i)) / std::sqrt(3.0);
      s.move(moved);
      expect_same(s, evaluate_again(s), moved.size(), structure.name + " at " + std::to_string(amplitude));
      if (HasFatalFailure()) return;
      ++steps;
    }
  }
  EXPECT_GT(lanes_.remembered_steps(), steps / 20);
  EXPECT_LT(lanes_.remembered_steps(), steps);
}

// Two molecules of hydrogen: where atoms of both come near enough, there is a bond more, though none is long.
TEST_P(LaneEvaluationOf, FindsABondThatForms) {
  Molecule m;
  for (const double x : {0.0, 0.75, 2.75, 3.5}) m.positions.emplace_back(x, 0, 0);
  for (int n = 1; n <= 8; ++n)  // and others far away, for most bonds to be steady
    for (const double x : {0.0, 0.75}) m.positions.emplace_back(x, 5.0 * n, 0);
  m.elements.assign(m.positions.size(), Element::hydrogen);
  Surroundings s(m);
  lanes_.near_changed(s.view(), s.near.pairs);
  for (const double gap : {2.0, 1.95, 1.85, 1.75, 1.69, 1.5, 1.72}) {
    m.positions[2].x() = 0.75 + gap;
    m.positions[3].x() = 1.5 + gap;
    s.move(m);
    expect_same(s, evaluate_again(s), m.size(), "gap " + std::to_string(gap));
  }
  EXPECT_EQ(lanes_.remembered_steps(), 5u);
}

//! Ethane, and molecules of hydrogen far from it and from each other, whose bonds are steady.
Molecule ethane_in_hydrogen() {
  Molecule m;
  for (const double side : {-1.0, 1.0}) {
    m.positions.emplace_back(side * 0.77, 0, 0);
    m.elements.push_back(Element::carbon);
    for (int h = 0; h < 3; ++h) {
      const double turn = 2.0 * std::numbers::pi / 3.0 * h + (side > 0 ? 0.0 : 0.5);
      m.positions.emplace_back(side * 1.17, 1.03 * std::cos(turn), 1.03 * std::sin(turn));
      m.elements.push_back(Element::hydrogen);
    }
  }
  for (int n = 0; n < 15; ++n)
    for (const double x : {0.0, 0.75}) {
      m.positions.emplace_back(10.0 + x, 5.0 * n, 0);
      m.elements.push_back(Element::hydrogen);
    }
  return m;
}

//! Each atom of ethane moved on its own.
Molecule moved(Molecule m, double distance, int step) {
  for (int i = 0; i < 8; ++i)
    m.positions[i] += distance * Vec3(std::sin(1.3 * i + step), std::sin(2.1 * i + 2.0 * step),
                                      std::sin(0.7 * i + 3.0 * step));
  return m;
}

// The hydrogens at one carbon come within a bond's reach of each other and go again, as they do in polyethylene.
TEST_P(LaneEvaluationOf, RemembersHydrogensThatMeetAndPart) {
  const Molecule m = ethane_in_hydrogen();
  Surroundings s(m);
  lanes_.near_changed(s.view(), s.near.pairs);
  constexpr std::size_t steps = 40;
  for (std::size_t step = 0; step < steps; ++step) {
    const Molecule now = moved(m, 0.06, static_cast<int>(step));
    s.move(now);
    expect_same(s, evaluate_again(s), m.size(), "step " + std::to_string(step));
    if (HasFatalFailure()) return;
  }
  EXPECT_EQ(lanes_.remembered_steps(), steps - 1);
}

// Bonds that change at every step are not worth remembering, until near pairs are looked for again.
TEST_P(LaneEvaluationOf, RemembersAgainWhenBondsHaveBecomeSteady) {
  const Molecule m = ethane_in_hydrogen();
  Surroundings s(m);
  const auto run = [&](double distance) {
    lanes_.near_changed(s.view(), s.near.pairs);
    const std::size_t before = lanes_.remembered_steps();
    for (int step = 0; step < 50; ++step) {
      s.move(moved(m, distance, step));
      expect_same(s, evaluate_again(s), m.size(), "step " + std::to_string(step));
      if (HasFatalFailure()) break;
    }
    return lanes_.remembered_steps() - before;
  };
  EXPECT_LT(run(0.4), 10u);
  EXPECT_EQ(run(0.01), 49u);
}

//! A carbon with as many others around it, evenly over a sphere of 1.9 Angstrom, in the cut-off window.
Molecule star(int neighbours) {
  Molecule m;
  m.positions.push_back(Vec3::Zero());
  for (int n = 0; n < neighbours; ++n) {
    const double z = 1.0 - (2.0 * n + 1.0) / neighbours, turn = 2.399963 * n, rho = std::sqrt(1.0 - z * z);
    m.positions.push_back(1.9 * Vec3(rho * std::cos(turn), rho * std::sin(turn), z));
  }
  m.elements.assign(m.positions.size(), Element::carbon);
  return m;
}

// Both branches of g, and the switch between them, are for five bonds and more.
TEST_P(LaneEvaluationOf, TakesCarbonOfEveryCoordinationThatFits) {
  for (int neighbours = 1; neighbours <= lane_most_bonds; ++neighbours)
    for (const double scale : {1.0, 0.88}) {
      Molecule m = star(neighbours);
      for (Vec3& p : m.positions) p *= scale;
      expect_same(m, "star of " + std::to_string(neighbours));
    }
}

TEST_P(LaneEvaluationOf, TakesAtomsWithoutBonds) {
  Molecule m;
  expect_same(m, "nothing");
  for (const double x : {0.0, 5.0, 10.0}) {
    m.positions.emplace_back(x, 0, 0);
    m.elements.push_back(x == 5.0 ? Element::hydrogen : Element::carbon);
    expect_same(m, std::to_string(m.size()) + " apart");
  }
  const Surroundings s(m);
  evaluate(s);
  expect_same(s, evaluate_again(s), m.size(), "again");
}

TEST_P(LaneEvaluationOf, LeavesMoreBondsThanThatAlone) {
  EXPECT_FALSE(evaluate(Surroundings(star(lane_most_bonds + 1))));
  EXPECT_TRUE(evaluate(Surroundings(star(lane_most_bonds))));
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const Sp2Kernel* kernel : usable_sp2_kernels())
    for (const bool torsion : {false, true}) all.push_back({kernel, torsion});
  return all;
}

INSTANTIATE_TEST_SUITE_P(Kernel, LaneEvaluationOf, testing::ValuesIn(cases()), [](const auto& given) {
  return std::string(given.param.kernel->name) + (given.param.torsion ? "_with_torsion" : "");
});

}  // namespace
}  // namespace nanocarbon::rebo2
