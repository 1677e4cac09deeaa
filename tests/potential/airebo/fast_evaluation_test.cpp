// SPDX-License-Identifier: GPL-2.0-or-later
//! \file
//! \brief The fast evaluation against the general one, which tests against LAMMPS hold.

#include <gmock/gmock.h>

#include "nanocarbon/potential/airebo/airebo.h"
#include "potential/airebo/airebo_structures.h"
#include "potential/airebo/reference.h"

namespace nanocarbon::airebo {
namespace {

using test::rattle;

const Cell* cell_of(const Molecule& m) { return m.cell ? &*m.cell : nullptr; }

void expect_same(const AireboResult& fast, const AireboResult& general) {
  double largest = 100.0;
  for (const Vec3& f : general.forces) largest = std::max(largest, f.norm());
  // Where atoms are pushed into each other, the plain sum has large terms that are taken away again.
  const double scale = std::abs(general.energy) + std::abs(general.energy_parts.long_range) + largest;
  EXPECT_NEAR(fast.energy_parts.rebo(), general.energy_parts.rebo(), 1e-12 * scale);
  EXPECT_NEAR(fast.energy_parts.torsion(), general.energy_parts.torsion(), 1e-12 * scale);
  EXPECT_NEAR(fast.energy_parts.long_range, general.energy_parts.long_range, 1e-12 * scale);
  EXPECT_NEAR(fast.energy, general.energy, 1e-12 * scale);
  EXPECT_LT((fast.virial - general.virial).cwiseAbs().maxCoeff(),
            1e-12 * largest * static_cast<double>(general.forces.size()));
  double worst = 0.0;
  for (std::size_t i = 0; i < general.forces.size(); ++i)
    worst = std::max(worst, (fast.forces[i] - general.forces[i]).norm());
  EXPECT_LT(worst, 1e-11 * largest);
}

TEST(FastAirebo, AgreesWithTheGeneralEvaluation) {
  for (const bool morse : {false, true}) {
    Airebo fast(morse ? airebo_m_parameters() : airebo_parameters());
    Airebo general(morse ? airebo_m_parameters() : airebo_parameters());
    for (const auto& [name, m] : test::airebo_structures()) {
      SCOPED_TRACE(name + (morse ? ", Morse" : ""));
      const AireboResult& g = general.evaluate(m.positions, m.elements, cell_of(m), {.general_only = true});
      expect_same(fast.evaluate(m.positions, m.elements, cell_of(m)), g);
    }
  }
}

// With lists kept, bonds break and form between one making of lists and the next.
TEST(FastAirebo, AgreesWhileListsAreKeptAndAtomsMove) {
  std::size_t builds = 0, steps = 0, terms = 0;
  for (const auto& [name, start] : test::airebo_structures()) {
    if (name.find("0.05") == std::string::npos && name.find("crystal ") == std::string::npos) continue;
    SCOPED_TRACE(name);
    Molecule m = start;
    Airebo fast, general;
    for (unsigned step = 0; step < 12; ++step, ++steps) {
      SCOPED_TRACE(step);
      rattle(m, 0.08, step);
      const AireboResult& g = general.evaluate(m.positions, m.elements, cell_of(m), {.general_only = true});
      expect_same(fast.evaluate(m.positions, m.elements, cell_of(m)), g);
      terms += fast.single_terms();
    }
    builds += fast.list_builds();
  }
  EXPECT_LT(2 * builds, steps);
  EXPECT_GT(terms, 0u);
}

TEST(FastAirebo, TakesEveryArgument) {
  for (const test::AireboReferenceStructure& s : test::airebo_reference())
    for (const test::AireboReference& r : s.references) {
      if (s.molecule.size() > 300 && s.name != "soup") continue;
      SCOPED_TRACE(s.name + ", " + r.style);
      const auto [parameters, terms] = test::airebo_style(r.style);
      Airebo fast(*parameters, terms), general(*parameters, terms);
      const AireboResult& g = general.evaluate(s.molecule.positions, s.molecule.elements, cell_of(s.molecule),
                                               {.general_only = true});
      expect_same(fast.evaluate(s.molecule.positions, s.molecule.elements, cell_of(s.molecule)), g);
    }
}

TEST(FastAirebo, EveryInstructionSetGivesTheSame) {
  const auto structures = test::airebo_structures();
  for (const char* instructions : {"generic", "avx2", "avx512"}) {
    std::optional<Airebo> airebo;
    try {
      airebo.emplace(airebo_parameters(), AireboTerms{}, instructions);
    } catch (const std::exception&) {
      continue;  // not on this processor
    }
    SCOPED_TRACE(instructions);
    for (std::size_t i = 0; i < 24; i += 3) {
      const Molecule& m = structures[i].molecule;
      Airebo general;
      const AireboResult& g = general.evaluate(m.positions, m.elements, cell_of(m), {.general_only = true});
      expect_same(airebo->evaluate(m.positions, m.elements, cell_of(m)), g);
    }
  }
}

TEST(FastAirebo, LeavesAlmostNothingOfGraphiteToSingleTerms) {
  for (const auto& [name, m] : test::airebo_structures()) {
    if (name.find("graphite") != 0 || name.find("0.05") == std::string::npos) continue;
    Airebo airebo;
    airebo.evaluate(m.positions, m.elements, cell_of(m));
    EXPECT_EQ(airebo.general_atoms(), 0u);
    EXPECT_LT(airebo.single_terms(), m.size() / 2);
  }
}

}  // namespace
}  // namespace nanocarbon::airebo
