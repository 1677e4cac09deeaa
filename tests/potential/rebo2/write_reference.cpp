// SPDX-License-Identifier: GPL-2.0-or-later
// Writes the table of reference values: write_rebo2_reference FILE
#include <mpi.h>

#include <cstdio>
#include <exception>

#include "potential/rebo2/comparison_structures.h"
#include "potential/rebo2/reference_table.h"
#include "support/lammps_reference.h"

int main(int argc, char** argv) {
  using namespace nanocarbon;
  using namespace nanocarbon::test;
  MPI_Init(&argc, &argv);
  int status = 0;
  try {
    if (argc != 2) throw std::runtime_error("usage: write_rebo2_reference FILE");
    LammpsReference lammps;
    std::vector<ReferenceEntry> entries;
    for (ComparisonStructure& structure : comparison_structures()) {
      const Molecule& m = structure.molecule;
      const LammpsEnergy l =
          lammps_energy(lammps, "rebo", m.positions, m.elements, m.cell ? &*m.cell : nullptr);
      entries.push_back({structure.name, m, l.energy, l.forces, l.virial, l.atom_energies});
    }
    write_reference_table(argv[1], entries);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    status = 1;
  }
  MPI_Finalize();
  return status;
}
