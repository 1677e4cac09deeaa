// SPDX-License-Identifier: GPL-2.0-or-later
//! \file
//! \brief pair_style airebo/opt and airebo/morse/opt, and the library's own AIREBO, against pair_style airebo
//! and airebo/morse, structure by structure, with everything that LAMMPS gives out.

#include <gmock/gmock.h>

#include "nanocarbon/potential/airebo/airebo.h"
#include "potential/airebo/airebo_structures.h"
#include "potential/airebo/reference.h"
#include "support/lammps_reference.h"

namespace nanocarbon::test {
namespace {

const Cell* cell_of(const Molecule& m) { return m.cell ? &*m.cell : nullptr; }

double largest_difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a[i] - b[i]).norm());
  return largest;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

//! Atoms whose virials differ by more than a tolerance.
std::size_t different_virials(const std::vector<Mat3>& a, const std::vector<Mat3>& b, double tolerance) {
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.size(); ++i) different += (a[i] - b[i]).cwiseAbs().maxCoeff() > tolerance;
  return different;
}

//! Whether rings of three atoms with a fractional bond may be there: two paths are equally good then, and which
//! of their atoms get the virial depends on the order of neighbours.
bool may_have_equal_paths(const std::string& name) {
  return name.find("rattled") ==
         std::string::npos;  // molecules and soup are; random crystals and clusters not
}

//! \param tolerance of forces below 100 eV/Angstrom
void expect_same(const LammpsEnergy& ours, const LammpsEnergy& theirs, double tolerance,
                 bool equal_paths = true) {
  double largest = 100.0;
  for (const Vec3& f : theirs.forces) largest = std::max(largest, f.norm());
  const double scale = tolerance * largest / 100.0;
  const double total = std::abs(theirs.parts[0]) + std::abs(theirs.parts[1]) + std::abs(theirs.parts[2]);
  for (int part = 0; part < 3; ++part)
    EXPECT_NEAR(ours.parts[part], theirs.parts[part], (tolerance > 5e-8 ? 1e-8 : 1e-10) * total) << part;
  EXPECT_LT(largest_difference(ours.forces, theirs.forces), scale);
  EXPECT_LT(largest_difference(ours.atom_energies, theirs.atom_energies), scale);
  if (!ours.atom_virials.empty() && !theirs.atom_virials.empty()) {
    EXPECT_LE(different_virials(ours.atom_virials, theirs.atom_virials, 10.0 * scale),
              equal_paths ? theirs.atom_virials.size() : 0);
  }
  EXPECT_LT((ours.virial - theirs.virial).cwiseAbs().maxCoeff(),
            10.0 * scale * std::sqrt(static_cast<double>(theirs.forces.size())));
}

LammpsEnergy library_energy(const std::string& style, const Molecule& m) {
  const auto [parameters, terms] = airebo_style(style);
  airebo::Airebo airebo(*parameters, terms);
  const airebo::AireboResult& r =
      airebo.evaluate(m.positions, m.elements, cell_of(m), {.atom_energies = true, .atom_virials = true});
  return {r.energy,       r.forces,
          r.virial,       r.atom_energies,
          r.atom_virials, {r.energy_parts.rebo(), r.energy_parts.long_range, r.energy_parts.torsion()}};
}

//! The style of the plugin that a style of LAMMPS's stands for.
std::string opt(std::string style) { return style.insert(std::min(style.find(' '), style.size()), "/opt"); }

//! \param with_shares also compares energies and virials of single atoms, which both do the slow way
void compare(LammpsReference& lammps, const std::string& style, const Molecule& m, bool with_shares,
             bool equal_paths = true) {
  SCOPED_TRACE(style);
  const LammpsEnergy theirs = lammps_energy(lammps, style, m.positions, m.elements, cell_of(m));
  const double tolerance = airebo_force_tolerance(m);
  {
    SCOPED_TRACE("the library");
    expect_same(library_energy(style, m), theirs, tolerance, equal_paths);
  }
  SCOPED_TRACE("the plugin");
  lammps.place(m.positions, m.elements, cell_of(m));
  lammps.potential(opt(style));
  if (with_shares) {
    expect_same(lammps.evaluate(), theirs, tolerance, equal_paths);
    lammps.place(m.positions, m.elements, cell_of(m));
    lammps.potential(opt(style));
  }
  // Nothing of single atoms, so that the fast loops are at work.
  LammpsEnergy ours = lammps.evaluate(false, false);
  ours.atom_energies = theirs.atom_energies;
  ours.atom_virials.clear();
  expect_same(ours, theirs, tolerance);
}

TEST(AireboOpt, AgreesWithAireboInPartsForcesVirialAndTheSharesOfAtoms) {
  LammpsReference lammps(true);
  std::size_t n = 0;
  for (const auto& [name, m] : airebo_structures()) {
    SCOPED_TRACE(name);
    const bool with_shares = n < 80 || n % 5 == 0;
    compare(lammps, n++ % 2 == 0 ? "airebo 3.0" : "airebo/morse 3.0", m, with_shares,
            may_have_equal_paths(name));
  }
}

TEST(AireboOpt, TakesOneThreeOrFourArguments) {
  LammpsReference lammps(true);
  for (const AireboReferenceStructure& s : airebo_reference()) {
    if (s.name != "soup" && s.name != "graphite" && s.name != "benzene_dimer") continue;
    SCOPED_TRACE(s.name);
    Molecule m = s.molecule;
    rattle(m, 0.05, 77);
    for (const char* style :
         {"airebo 2.5", "airebo 3.5", "airebo 1.1", "airebo 3.0 0 0", "airebo 3.0 1 0", "airebo 3.0 0 1",
          "airebo 2.5 1 1 2.0", "airebo/morse 3.0 1 0", "airebo/morse 2.5 1 1 2.0", "airebo/morse 2.0"})
      compare(lammps, style, m, false);
  }
}

// On structures that no other test holds.
TEST(AireboOpt, AgreesOnDenseCrystalsAndClusters) {
  LammpsReference lammps(true);
  for (unsigned seed = 500; seed < 520; ++seed) {
    SCOPED_TRACE(seed);
    compare(lammps, seed % 2 == 0 ? "airebo 3.0" : "airebo/morse 3.0", random_crystal(seed, 40, 7.5), true);
    compare(lammps, "airebo 3.0", random_cluster(seed), true);
  }
}

}  // namespace
}  // namespace nanocarbon::test
