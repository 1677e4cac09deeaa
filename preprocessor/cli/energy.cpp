// SPDX-License-Identifier: GPL-2.0-or-later
#include "energy.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "molecule_input.h"
#include "nanocarbon/core/output_file.h"
#include "nanocarbon/potential/rebo2/parameter_file.h"
#include "nanocarbon/potential/rebo2/rebo2.h"

namespace nanocarbon::cli {
namespace {

using Json = nlohmann::ordered_json;

struct EnergyCommand {
  MoleculeInput input;
  std::string potential;
  std::string forces;
  bool parts = false;
  bool json = false;
};

void write_forces(const std::string& path, const molecule::MoleculeFrame& structure,
                  const rebo2::Rebo2Result& result) {
  const Molecule& m = structure.molecule;
  write_file(path, [&](std::ostream& out) {
    std::string header;
    if (m.cell) {
      header = "Lattice=\"";
      for (int edge = 0; edge < 3; ++edge)
        for (int d = 0; d < 3; ++d)
          header += fmt::format("{}{}", edge + d > 0 ? " " : "", m.cell->vectors(d, edge));
      header += "\" ";
    }
    const auto letter = [&](int d) { return m.cell && m.cell->periodic[d] ? 'T' : 'F'; };
    out << fmt::format(
        "{}\n{}Properties=id:I:1:species:S:1:pos:R:3:forces:R:3:energies:R:1 energy={} pbc=\"{} {} {}\"\n",
        m.size(), header, result.energy, letter(0), letter(1), letter(2));
    for (std::size_t i = 0; i < m.size(); ++i) {
      const Vec3 &p = m.positions[i], &f = result.forces[i];
      out << fmt::format("{} {} {} {} {} {} {} {} {}\n", structure.ids[i], symbol(m.elements[i]), p.x(),
                         p.y(), p.z(), f.x(), f.y(), f.z(), result.atom_energies[i]);
    }
  });
}

struct Summary {
  std::size_t atoms;
  std::size_t carbons;
  double largest_force;
};

Summary summarise(const Molecule& m, const rebo2::Rebo2Result& result) {
  Summary summary = {m.size(), 0, 0.0};
  for (const Element element : m.elements) summary.carbons += element == Element::carbon;
  for (const Vec3& f : result.forces) summary.largest_force = std::max(summary.largest_force, f.norm());
  return summary;
}

void print_json(const EnergyCommand& command, const Summary& s, const rebo2::Rebo2Result& result) {
  Json json = {{"file", command.input.file},
               {"atoms", s.atoms},
               {"carbons", s.carbons},
               {"hydrogens", s.atoms - s.carbons},
               {"energy", result.energy},
               {"energy_per_atom", result.energy / static_cast<double>(s.atoms)},
               {"largest_force", s.largest_force}};
  const Mat3& v = result.virial;
  json["virial"] = {v(0, 0), v(1, 1), v(2, 2), v(0, 1), v(0, 2), v(1, 2)};
  if (command.parts)
    json["parts"] = {{"repulsive", result.parts.repulsive},
                     {"sigma_pi", result.parts.sigma_pi},
                     {"conjugation", result.parts.conjugation},
                     {"dihedral", result.parts.dihedral}};
  fmt::print("{}\n", json.dump(2));
}

void print_text(const EnergyCommand& command, const Summary& s, const rebo2::Rebo2Result& result) {
  const auto energy_line = [&](std::string_view name, double energy) {
    fmt::print("  {:<16}{:>20.9f} eV {:>16.9f} eV/atom\n", name, energy,
               energy / static_cast<double>(s.atoms));
  };
  fmt::print("{}: {} atoms, {} carbon and {} hydrogen\n", command.input.file, s.atoms, s.carbons,
             s.atoms - s.carbons);
  energy_line("energy", result.energy);
  if (command.parts) {
    energy_line("repulsive", result.parts.repulsive);
    energy_line("sigma-pi", result.parts.sigma_pi);
    energy_line("conjugation", result.parts.conjugation);
    energy_line("dihedral", result.parts.dihedral);
  }
  fmt::print("  {:<16}{:>20.3g} eV/Angstrom\n", "largest force", s.largest_force);
}

void run(const EnergyCommand& command) {
  const molecule::MoleculeFrame structure = read_molecule(command.input);
  const Molecule& m = structure.molecule;
  rebo2::Rebo2 rebo2(command.potential.empty() ? rebo2::rebo2_parameters()
                                               : rebo2::read_rebo2_parameters(command.potential));
  const rebo2::Rebo2Result& result =
      rebo2.evaluate(m.positions, m.elements, m.cell ? &*m.cell : nullptr, {.atom_energies = true});
  if (!command.forces.empty()) write_forces(command.forces, structure, result);
  const Summary summary = summarise(m, result);
  if (command.json)
    print_json(command, summary, result);
  else
    print_text(command, summary, result);
}

}  // namespace

void add_energy(CLI::App& app) {
  CLI::App& sub = *app.add_subcommand("energy", "Evaluate REBO2 for a structure: energy, its parts, forces");
  const auto command = std::make_shared<EnergyCommand>();
  add_molecule_input(sub, command->input);
  add_frame_option(sub, command->input);
  sub.add_option("--forces", command->forces,
                 "Write forces and energies of the atoms to this extended XYZ file (eV/Angstrom, eV)");
  sub.add_flag("--parts", command->parts, "Also the repulsive, sigma-pi, conjugation and dihedral parts");
  sub.add_flag("--json", command->json, "Print JSON; virial as xx, yy, zz, xy, xz, yz in eV");
  sub.add_option("--potential", command->potential,
                 "Parameters from a file in the format of LAMMPS's CH.rebo");
  sub.footer(R"(The energy is that of LAMMPS's pair_style rebo, in eV.
Examples:
  nanocarbon energy bunny.data
  nanocarbon energy relaxed.xyz --parts --json
  nanocarbon energy bilayer.data --types C C
  nanocarbon energy run.lammpstrj.gz --frame -1
  nanocarbon energy sheet.data --boundary "p p f" --forces forces.xyz)");
  sub.callback([command] { run(*command); });
}

}  // namespace nanocarbon::cli
