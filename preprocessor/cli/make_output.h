// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "nanocarbon/building/potential_choice.h"
#include "nanocarbon/mesh/triangle_mesh.h"
#include "nanocarbon/minimisation/cell_minimum.h"
#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::cli {

//! Where a made structure goes, and how.
struct MoleculeOutput {
  std::filesystem::path path;  //!< .data or .xyz
  std::string atom_style = "molecular";
  double margin = 10.0;  //!< Angstrom
  bool quiet = false;
};
//! The options of an output; another extension is an error on the command line.
void add_molecule_output(CLI::App& subcommand, MoleculeOutput& output);

//! \brief Brings a structure to a minimum of a potential, and says what it has become on the terminal.
//! \param relaxation strains of its cell that may change, if it has one
//! \throw UserError (failed) where it is not reached, or bonds are not those they were
void relax(Molecule& structure, building::PotentialChoice potential, minimisation::CellRelaxation relaxation,
           const MoleculeOutput& output);

//! Adds --cells: a number of cells for each edge of a crystal, or one number for all.
//! \param cells must outlive the subcommand
CLI::Option* add_cells_option(CLI::App& subcommand, std::vector<int>& cells);
std::array<int, 3> three_cells(const std::vector<int>& cells);

//! Writes it in the format of the path's extension, and a line about it to the terminal.
void write_molecule(const MoleculeOutput& output, const Molecule& molecule, const CLI::App& subcommand);

struct MeshOutput {
  std::filesystem::path path;  //!< .off, .obj, .ply or .stl
  bool quiet = false;
};
void add_mesh_output(CLI::App& subcommand, MeshOutput& output);
void write_shape(const MeshOutput& output, const TriangleMesh& mesh);

}  // namespace nanocarbon::cli
