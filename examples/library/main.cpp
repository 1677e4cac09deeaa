// SPDX-License-Identifier: GPL-2.0-or-later
// From a mesh to a molecule and its energy, by the library.
//
//   from_mesh_to_molecule MESH ATOMS OUT.data
#include <cstdlib>
#include <iostream>

#include "nanocarbon/building/build_molecule.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/formats/load_surface.h"
#include "nanocarbon/molecule/formats/lammps_data.h"
#include "nanocarbon/potential/rebo2/rebo2.h"
#include "nanocarbon/structures/fullerene.h"

using namespace nanocarbon;

// eV for each atom, as LAMMPS's pair_style rebo has it.
static double energy_per_atom(const Molecule& molecule) {
  rebo2::Rebo2 rebo2;
  const rebo2::Rebo2Result& result = rebo2.evaluate(molecule.positions, molecule.elements);
  return result.energy / static_cast<double>(molecule.size());
}

static void run(const char* mesh, std::size_t atoms, const char* output) {
  const mesh::LoadedSurface surface = mesh::load_surface(mesh);  // read, checked, mended
  for (const std::string& repair : surface.repairs) std::cerr << "note: " << repair << '\n';

  building::BuildOptions options;
  options.size = building::AtomCount{atoms};
  options.quality = Quality::draft;
  const building::BuildResult result = building::build_molecule(surface.mesh, options);

  std::cout << result.molecule.size() << " atoms, " << result.molecule.bonds.size() << " bonds, "
            << result.molecule.rings.size() << " rings\n"
            << energy_per_atom(result.molecule) << " eV/atom; C60 as made has "
            << energy_per_atom(structures::fullerene(1, 1)) << '\n';
  molecule::write_lammps_data(output, result.molecule, {.atom_style = molecule::AtomStyle::molecular});
}

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "usage: from_mesh_to_molecule MESH ATOMS OUT.data\n";
    return static_cast<int>(Failure::usage);
  }
  try {
    run(argv[1], std::strtoul(argv[2], nullptr, 10), argv[3]);
  } catch (const UserError& error) {  // what a user can mend; the message says how
    std::cerr << error.what() << '\n';
    return static_cast<int>(error.failure());
  }
}
