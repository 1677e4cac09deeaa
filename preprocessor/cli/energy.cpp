// SPDX-License-Identifier: GPL-2.0-or-later
#include "energy.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "molecule_input.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/core/output_file.h"
#include "nanocarbon/molecule/formats/byte_source.h"
#include "nanocarbon/potential/potential.h"
#include "potential_option.h"

namespace nanocarbon::cli {
namespace {

using Json = nlohmann::ordered_json;

struct EnergyCommand {
  MoleculeInput input;
  building::PotentialChoice potential = building::PotentialChoice::rebo2;
  std::string parameters;  // file
  std::string forces;
  bool parts = false;
  bool json = false;
};

void write_forces(const std::string& path, const molecule::MoleculeFrame& structure,
                  const potential::Evaluation& result) {
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

Summary summarise(const Molecule& m, const potential::Evaluation& result) {
  Summary summary = {m.size(), 0, 0.0};
  for (const Element element : m.elements) summary.carbons += element == Element::carbon;
  for (const Vec3& f : result.forces) summary.largest_force = std::max(summary.largest_force, f.norm());
  return summary;
}

void print_json(const EnergyCommand& command, const Summary& s, const potential::Potential& potential,
                const potential::Evaluation& result) {
  Json json = {{"file", command.input.file},
               {"atoms", s.atoms},
               {"carbons", s.carbons},
               {"hydrogens", s.atoms - s.carbons},
               {"potential", potential.name()},
               {"energy", result.energy},
               {"energy_per_atom", result.energy / static_cast<double>(s.atoms)},
               {"largest_force", s.largest_force}};
  const Mat3& v = result.virial;
  json["virial"] = {v(0, 0), v(1, 1), v(2, 2), v(0, 1), v(0, 2), v(1, 2)};
  if (command.parts)
    for (const potential::EnergyPart& part : potential.parts())
      json["parts"][std::string(part.name)] = part.energy;
  fmt::print("{}\n", json.dump(2));
}

void print_text(const EnergyCommand& command, const Summary& s, const potential::Potential& potential,
                const potential::Evaluation& result) {
  const auto energy_line = [&](std::string_view name, double energy) {
    fmt::print("  {:<16}{:>20.9f} eV {:>16.9f} eV/atom\n", name, energy,
               energy / static_cast<double>(s.atoms));
  };
  fmt::print("{}: {} atoms, {} carbon and {} hydrogen, by {}\n", command.input.file, s.atoms, s.carbons,
             s.atoms - s.carbons, potential.name());
  energy_line("energy", result.energy);
  if (command.parts)
    for (const potential::EnergyPart& part : potential.parts()) {
      std::string name(part.name);
      std::replace(name.begin(), name.end(), '_', '-');
      energy_line(name, part.energy);
    }
  fmt::print("  {:<16}{:>20.3g} eV/Angstrom\n", "largest force", s.largest_force);
}

void run(const EnergyCommand& command) {
  const molecule::MoleculeFrame structure = read_molecule(command.input);
  const Molecule& m = structure.molecule;
  const std::unique_ptr<potential::Potential> potential =
      command.parameters.empty() ? building::make_potential(command.potential)
                                 : building::make_potential(command.potential, command.parameters);
  const potential::Evaluation& result = potential->evaluate(
      m.positions, m.elements, m.cell ? &*m.cell : nullptr, {.atom_energies = !command.forces.empty()});
  if (!std::isfinite(result.energy))
    throw UserError(Failure::unsuitable,
                    fmt::format("{}: the energy is no finite number: atoms lie on top of each other",
                                molecule::shown_name(command.input.file)));
  if (!command.forces.empty()) write_forces(command.forces, structure, result);
  const Summary summary = summarise(m, result);
  if (command.json)
    print_json(command, summary, *potential, result);
  else
    print_text(command, summary, *potential, result);
}

}  // namespace

void add_energy(CLI::App& app) {
  CLI::App& sub = *app.add_subcommand(
      "energy", "Compute the energy of a structure, its parts and the forces, by REBO2 or AIREBO");
  const auto command = std::make_shared<EnergyCommand>();
  add_molecule_input(sub, command->input);
  add_frame_option(sub, command->input);
  sub.add_option("--forces", command->forces,
                 "Write forces and energies of the atoms to this extended XYZ file (eV/Angstrom, eV)");
  sub.add_flag("--parts", command->parts,
               "Also give the parts of the energy: repulsive, sigma-pi, conjugation and dihedral of REBO2; "
               "rebo, lennard-jones (morse of AIREBO-M) and torsion of AIREBO");
  sub.add_flag("--json", command->json, "Print JSON; virial as xx, yy, zz, xy, xz, yz in eV");
  add_potential_option(sub, command->potential, "Potential: rebo2 (default), airebo or airebo-m");
  sub.add_option("--parameters", command->parameters,
                 "Read the parameters from a file in the format of LAMMPS's CH.rebo, CH.airebo or "
                 "CH.airebo-m, whichever belongs to the potential")
      ->type_name("FILE");
  sub.footer(R"(Energies, in eV, are those of LAMMPS's pair_style rebo, airebo 3.0 and airebo/morse 3.0.
Examples:
  nanocarbon energy bunny.data
  nanocarbon energy relaxed.xyz --parts --json
  nanocarbon energy onion.data --potential airebo --parts
  nanocarbon energy bilayer.data --types C C
  nanocarbon energy run.lammpstrj.gz --frame -1
  nanocarbon energy sheet.data --boundary "p p f" --forces forces.xyz)");
  sub.callback([command] { run(*command); });
}

}  // namespace nanocarbon::cli
