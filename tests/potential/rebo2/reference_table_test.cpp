// SPDX-License-Identifier: GPL-2.0-or-later
#include "potential/rebo2/reference_table.h"

#include <gmock/gmock.h>

#include "nanocarbon/potential/rebo2/rebo2.h"
#include "potential/rebo2/comparison_structures.h"

namespace nanocarbon::rebo2 {
namespace {

using namespace test;

class AgainstLammps : public testing::TestWithParam<bool> {};

TEST_P(AgainstLammps, EnergyForcesVirialAndAtomEnergiesAgree) {
  Rebo2 rebo2;
  const std::vector<ReferenceEntry> table = read_reference_table(NANOCARBON_REFERENCE_TABLE);
  ASSERT_GT(table.size(), 250u);
  for (const ReferenceEntry& entry : table) {
    SCOPED_TRACE(entry.name);
    const Molecule& m = entry.molecule;
    const Rebo2Result& result = rebo2.evaluate(m.positions, m.elements, m.cell ? &*m.cell : nullptr,
                                               {.general_only = GetParam(), .atom_energies = true});
    const double tolerance = force_tolerance(m);
    EXPECT_NEAR(result.energy, entry.energy, (tolerance > 5e-9 ? 1e-8 : 1e-10) * std::abs(entry.energy));
    double force_error = 0.0, atom_error = 0.0;
    for (std::size_t i = 0; i < m.size(); ++i) {
      force_error = std::max(force_error, (result.forces[i] - entry.forces[i]).lpNorm<Eigen::Infinity>());
      atom_error = std::max(atom_error, std::abs(result.atom_energies[i] - entry.atom_energies[i]));
    }
    EXPECT_LT(force_error, tolerance);
    EXPECT_LT(atom_error, tolerance);
    // A sum over the atoms' forces times distances of some Angstrom, through LAMMPS's conversion to bar.
    EXPECT_LT((result.virial - entry.virial).cwiseAbs().maxCoeff(), 1e1 * tolerance * std::sqrt(m.size()));
  }
}

INSTANTIATE_TEST_SUITE_P(Evaluation, AgainstLammps, testing::Values(true, false),
                         [](const auto& way) { return way.param ? "general" : "fast"; });

}  // namespace
}  // namespace nanocarbon::rebo2
