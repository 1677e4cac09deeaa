// SPDX-License-Identifier: GPL-2.0-or-later
#include "make_output.h"

#include <fmt/format.h>

#include <map>
#include <memory>
#include <set>
#include <string>

#include "command_text.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/core/version.h"
#include "nanocarbon/mesh/formats/write_mesh.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/molecule/bond_statistics.h"
#include "nanocarbon/molecule/formats/atom_style.h"
#include "nanocarbon/molecule/formats/write_molecule.h"
#include "nanocarbon/topology/bond_graph.h"
#include "number_checks.h"

namespace nanocarbon::cli {
namespace {

// Layers and tubes are held by little: 0.2 eV/Angstrom^2 an atom. With this they are within 0.001 Angstrom.
constexpr double relaxed_force = 1e-4;  // eV/Angstrom

std::string ring_counts(const Molecule& molecule) {
  std::map<std::size_t, std::size_t> counts;
  for (std::size_t r = 0; r < molecule.rings.size(); ++r) ++counts[molecule.rings[r].size()];
  std::string text;
  for (const auto& [size, count] : counts) text += fmt::format(", {} rings of {}", count, size);
  return text;
}

//! Checks a file's extension before any work is done.
CLI::Validator named(const std::set<std::string>& extensions) {
  return CLI::Validator(
      [extensions](std::string& path) {
        if (extensions.contains(std::filesystem::path(path).extension().string())) return std::string();
        return fmt::format("{}: give the file one of the extensions {}", path, fmt::join(extensions, ", "));
      },
      "");
}

}  // namespace

void add_molecule_output(CLI::App& subcommand, MoleculeOutput& output) {
  subcommand.add_option("-o,--output", output.path, "File to write: .data (LAMMPS) or .xyz (extended XYZ)")
      ->required()
      ->check(named({".data", ".xyz", ".extxyz"}))
      ->type_name("FILE");
  subcommand.add_option("--atom-style", output.atom_style, "LAMMPS atom style")
      ->check(CLI::IsMember({"atomic", "charge", "molecular", "full"}))
      ->capture_default_str();
  subcommand
      .add_option("--margin", output.margin,
                  "Empty box around the atoms in directions that are not periodic, Angstrom")
      ->check(zero_or_more())
      ->capture_default_str();
  subcommand.add_flag("-q,--quiet", output.quiet, "Print nothing but errors");
}

void relax(Molecule& structure, building::PotentialChoice choice, minimisation::CellRelaxation relaxation,
           const MoleculeOutput& output) {
  const std::unique_ptr<potential::Potential> potential = building::make_potential(choice);
  const minimisation::MinimisationResult relaxed =
      minimisation::minimise_in_cell(structure, *potential, relaxation, {.force_tolerance = relaxed_force})
          .minimum;
  const std::vector<Bond> bonds = topology::bonds_within(structure.positions, structure.elements,
                                                         structure.cell ? &*structure.cell : nullptr);
  if (!relaxed.converged || bonds.size() != structure.bonds.size())
    throw UserError(
        Failure::failed,
        fmt::format("the structure does not come to rest under {} with the bonds that it was made with",
                    building::name(choice)));
  if (!output.quiet)
    fmt::print("relaxed by {}: {:.6f} eV per atom\n", building::name(choice),
               relaxed.energy / static_cast<double>(structure.size()));
}

CLI::Option* add_cells_option(CLI::App& sub, std::vector<int>& cells) {
  sub.parse_complete_callback([&cells] {
    if (cells.size() == 2)
      throw UserError(Failure::usage, "--cells takes one number, or three: along x, y and z");
  });
  return sub.add_option("--cells", cells, "Unit cells along each edge: one number for all, or three")
      ->expected(1, 3)
      ->transform(whole_number())
      ->check(between(1, 200));
}

std::array<int, 3> three_cells(const std::vector<int>& cells) {
  if (cells.size() == 3) return {cells[0], cells[1], cells[2]};
  return {cells.at(0), cells.at(0), cells.at(0)};
}

void write_molecule(const MoleculeOutput& output, const Molecule& molecule, const CLI::App& subcommand) {
  const std::string made_by = fmt::format("{} (nanocarbon {})", command_text(subcommand), version);
  molecule::write_molecule(output.path, molecule,
                           {*molecule::atom_style_from_name(output.atom_style), output.margin, made_by});
  if (output.quiet) return;
  const molecule::Spread bonds = molecule::spread(molecule::bond_lengths(molecule));
  fmt::print("{}: {} atoms, {} bonds of {:.3f} to {:.3f} Angstrom{}\n", output.path.string(), molecule.size(),
             molecule.bonds.size(), bonds.min, bonds.max, ring_counts(molecule));
}

void add_mesh_output(CLI::App& subcommand, MeshOutput& output) {
  subcommand.add_option("-o,--output", output.path, "File to write: .off, .obj, .ply or .stl")
      ->required()
      ->check(named({".off", ".obj", ".ply", ".stl"}))
      ->type_name("FILE");
  subcommand.add_flag("-q,--quiet", output.quiet, "Print nothing but errors");
}

void write_shape(const MeshOutput& output, const TriangleMesh& mesh) {
  mesh::write_mesh(output.path, mesh);
  if (output.quiet) return;
  const mesh::MeshTopology t = mesh::mesh_topology(mesh);
  fmt::print("{}: {} vertices, {} triangles, genus {}, {} boundary loops\n", output.path.string(), t.vertices,
             t.faces, t.genus, t.boundary_loops);
}

}  // namespace nanocarbon::cli
