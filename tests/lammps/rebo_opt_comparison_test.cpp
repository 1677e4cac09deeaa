// SPDX-License-Identifier: GPL-2.0-or-later
//! \file
//! \brief pair_style rebo/opt and the library's own REBO2 against pair_style rebo, structure by structure,
//! with everything that LAMMPS gives out.

#include <gmock/gmock.h>

#include "nanocarbon/building/build_molecule.h"
#include "nanocarbon/mesh/formats/load_surface.h"
#include "nanocarbon/potential/rebo2/parameter_file.h"
#include "nanocarbon/potential/rebo2/rebo2.h"
#include "potential/rebo2/comparison_structures.h"
#include "support/lammps_reference.h"

namespace nanocarbon::test {
namespace {

double largest_difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max(largest, (a[i] - b[i]).lpNorm<Eigen::Infinity>());
  return largest;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

double largest_difference(const std::vector<Mat3>& a, const std::vector<Mat3>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a[i] - b[i]).cwiseAbs().maxCoeff());
  return largest;
}

void expect_same(const LammpsEnergy& ours, const LammpsEnergy& rebo, double tolerance) {
  EXPECT_NEAR(ours.energy, rebo.energy, (tolerance > 5e-9 ? 1e-8 : 1e-10) * std::abs(rebo.energy));
  EXPECT_LT(largest_difference(ours.forces, rebo.forces), tolerance);
  EXPECT_LT(largest_difference(ours.atom_energies, rebo.atom_energies), tolerance);
  // Sums of forces times some Angstrom, LAMMPS's own through its conversion to bar and back.
  EXPECT_LT((ours.virial - rebo.virial).cwiseAbs().maxCoeff(),
            10.0 * tolerance * std::sqrt(static_cast<double>(rebo.forces.size())));
  EXPECT_LT(largest_difference(ours.atom_virials, rebo.atom_virials), 10.0 * tolerance);
}

const Cell* cell_of(const Molecule& m) { return m.cell ? &*m.cell : nullptr; }

TEST(ReboOpt, AgreesWithReboInEnergyForcesVirialAndTheSharesOfAtoms) {
  LammpsReference lammps(true);
  for (const auto& [name, m] : comparison_structures()) {
    SCOPED_TRACE(name);
    const LammpsEnergy rebo = lammps_energy(lammps, "rebo", m.positions, m.elements, cell_of(m));
    // Without virials of atoms, so that the fast loops are at work.
    lammps.place(m.positions, m.elements, cell_of(m));
    lammps.potential("rebo/opt");
    LammpsEnergy ours = lammps.evaluate(false);
    ours.atom_virials = rebo.atom_virials;
    expect_same(ours, rebo, force_tolerance(m));
  }
}

TEST(ReboOpt, SharesTheVirialOutAsReboDoes) {
  LammpsReference lammps(true);
  std::size_t n = 0;
  for (const auto& [name, m] : comparison_structures()) {
    if (++n > 50 && n % 5 != 0) continue;  // every known structure, and some of the clusters
    SCOPED_TRACE(name);
    const LammpsEnergy rebo = lammps_energy(lammps, "rebo", m.positions, m.elements, cell_of(m));
    expect_same(lammps_energy(lammps, "rebo/opt", m.positions, m.elements, cell_of(m)), rebo,
                force_tolerance(m));
  }
}

TEST(NativeRebo2, AgreesWithReboOnStructuresThatTheTableDoesNotHold) {
  LammpsReference lammps;
  rebo2::Rebo2 rebo2;
  for (unsigned seed = 1000; seed < 1040; ++seed) {
    SCOPED_TRACE(seed);
    const Molecule m = random_cluster(seed);
    const LammpsEnergy rebo = lammps_energy(lammps, "rebo", m.positions, m.elements, nullptr);
    const rebo2::Rebo2Result& r =
        rebo2.evaluate(m.positions, m.elements, nullptr, {.atom_energies = true, .atom_virials = true});
    expect_same({r.energy, r.forces, r.virial, r.atom_energies, r.atom_virials}, rebo, force_tolerance(m));
  }
}

//! Two or three atoms in a row or at an angle, one distance swept through every cut-off window.
// As nanocarbon build makes them, draft ones: rings of 5 to 7 and curvature of both signs; at rest and hot.
TEST(BuiltMolecules, AgreeInAllThree) {
  LammpsReference lammps(true);
  rebo2::Rebo2 rebo2;
  for (const char* mesh : {"torus.off", "capsule.off"}) {
    SCOPED_TRACE(mesh);
    building::BuildOptions options;
    options.size = building::AtomCount{600};
    options.quality = Quality::draft;
    options.force = true;  // so small a torus has a thin ring
    const auto surface = mesh::load_surface(std::string(NANOCARBON_EXAMPLES) + "/meshes/" + mesh);
    Molecule m = building::build_molecule(surface.mesh, options).molecule;
    for (const double distance : {0.0, 0.05, 0.15}) {
      SCOPED_TRACE(distance);
      rattle(m, distance, 7);
      const LammpsEnergy rebo = lammps_energy(lammps, "rebo", m.positions, m.elements, nullptr);
      lammps.place(m.positions, m.elements, nullptr);
      lammps.potential("rebo/opt");
      LammpsEnergy opt = lammps.evaluate(false);
      opt.atom_virials = rebo.atom_virials;
      expect_same(opt, rebo, force_tolerance(m));
      const rebo2::Rebo2Result& r =
          rebo2.evaluate(m.positions, m.elements, nullptr, {.atom_energies = true, .atom_virials = true});
      expect_same({r.energy, r.forces, r.virial, r.atom_energies, r.atom_virials}, rebo, force_tolerance(m));
    }
  }
}

TEST(NativeRebo2, DimersAndTrimersAgreeThroughTheCutoffWindow) {
  LammpsReference lammps;
  rebo2::Rebo2 rebo2;
  using enum Element;
  for (const std::vector<Element>& elements :
       std::vector<std::vector<Element>>{{carbon, carbon},
                                         {carbon, hydrogen},
                                         {hydrogen, hydrogen},
                                         {carbon, carbon, carbon},
                                         {hydrogen, carbon, carbon},
                                         {carbon, hydrogen, hydrogen},
                                         {hydrogen, hydrogen, hydrogen}})
    for (double distance = 1.0; distance < 2.05; distance += 0.07) {
      Molecule m;
      m.elements = elements;
      m.positions = {Vec3::Zero(), Vec3(distance, 0.0, 0.0), Vec3(-0.4, 1.2, 0.1)};
      m.positions.resize(elements.size());
      SCOPED_TRACE(distance);
      const LammpsEnergy rebo = lammps_energy(lammps, "rebo", m.positions, m.elements, nullptr);
      const rebo2::Rebo2Result& r = rebo2.evaluate(m.positions, m.elements);
      EXPECT_NEAR(r.energy, rebo.energy, 1e-8 * std::abs(rebo.energy) + 1e-14);
      EXPECT_LT(largest_difference(r.forces, rebo.forces), force_tolerance(m));
    }
}

TEST(ParameterFile, HoldsTheParametersOfTheLibrary) {
  const rebo2::Rebo2Parameters read = rebo2::read_rebo2_parameters(NANOCARBON_CH_REBO);
  const rebo2::Rebo2Parameters& own = rebo2::rebo2_parameters();
  for (int p = 0; p < 3; ++p) {
    const rebo2::PairParameters &a = read.pairs[p], &b = own.pairs[p];
    EXPECT_EQ(a.cutoff_begin, b.cutoff_begin);
    EXPECT_EQ(a.cutoff_end, b.cutoff_end);
    EXPECT_EQ(a.dihedral_cutoff_end, b.dihedral_cutoff_end);
    EXPECT_EQ(a.screening, b.screening);
    EXPECT_EQ(a.repulsion, b.repulsion);
    EXPECT_EQ(a.repulsion_decay, b.repulsion_decay);
    EXPECT_EQ(a.attraction, b.attraction);
    EXPECT_EQ(a.attraction_decay, b.attraction_decay);
    EXPECT_EQ(a.equilibrium, b.equilibrium);
  }
  EXPECT_EQ(read.conjugation_begin, own.conjugation_begin);
  EXPECT_EQ(read.conjugation_end, own.conjugation_end);
  EXPECT_EQ(read.carbon.few_end, own.carbon.few_end);
  EXPECT_EQ(read.carbon.many_begin, own.carbon.many_begin);
  EXPECT_EQ(read.carbon.knots, own.carbon.knots);
  EXPECT_EQ(read.carbon.few, own.carbon.few);
  EXPECT_EQ(read.carbon.many, own.carbon.many);
  EXPECT_EQ(read.hydrogen.knots, own.hydrogen.knots);
  EXPECT_EQ(read.hydrogen.pieces, own.hydrogen.pieces);
}

}  // namespace
}  // namespace nanocarbon::test
