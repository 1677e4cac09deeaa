// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "make.h"
#include "make_output.h"
#include "nanocarbon/structures/schwarzite.h"
#include "nanocarbon/structures/schwarzite_family.h"
#include "number_checks.h"
#include "potential_option.h"

namespace nanocarbon::cli {
namespace {

struct SchwarziteCommand {
  std::string name;
  std::vector<int> cells;  // as the name has it by default
  building::PotentialChoice potential = building::PotentialChoice::rebo2;
  MoleculeOutput output;
};

//! The networks without hexagons beside hexagons, which have names of their own; their cells are so small that by
//! default there are two along each edge.
struct Network {
  const char* name;
  Molecule (*cells)(int, int, int);
};
constexpr Network networks[] = {{"p688", structures::schwarzite_p688},
                                {"d688", structures::schwarzite_d688},
                                {"g688", structures::schwarzite_g688}};

void make(const SchwarziteCommand& command, const CLI::App& subcommand) {
  const auto* network = std::find_if(std::begin(networks), std::end(networks),
                                     [&](const Network& known) { return known.name == command.name; });
  Molecule molecule;
  if (network != std::end(networks)) {
    const auto [x, y, z] = three_cells(command.cells.empty() ? std::vector<int>{2} : command.cells);
    molecule = network->cells(x, y, z);  // at rest under REBO2
    if (command.potential != building::PotentialChoice::rebo2)
      relax(molecule, command.potential, minimisation::CellRelaxation::triclinic, command.output);
  } else {
    molecule = structures::schwarzite(command.name);
    relax(molecule, command.potential, minimisation::CellRelaxation::triclinic, command.output);
    if (!command.cells.empty()) molecule = structures::repeated(molecule, three_cells(command.cells));
  }
  write_molecule(command.output, molecule, subcommand);
}

}  // namespace

void add_make_schwarzite(CLI::App& make_command) {
  CLI::App& sub =
      *make_command.add_subcommand("schwarzite", "A schwarzite on the surface P, D or G, by name, periodic");
  const auto c = std::make_shared<SchwarziteCommand>();
  sub.add_option(
         "NAME", c->name,
         "p688, d688 or g688, of hexagons and octagons; or a letter for the surface and the number of atoms "
         "in its cell, such as p192, d168 or g384")
      ->required();
  add_cells_option(sub, c->cells)->default_str("2 of p688, d688 and g688, else 1");
  add_potential_option(
      sub, c->potential,
      "Potential by which it is relaxed, with its cell: rebo2 (default), airebo or airebo-m");
  add_molecule_output(sub, c->output);
  sub.footer(
      R"(Cells of hexagons and octagons have 48 T atoms on P (cube) and D (primitive cell), 96 T on G (cube); of hexagons and
heptagons 56 T on D (primitive cell), where T is 1, 3, 4, 7, 9, 12, 13, 16 ... p192, d192 and g384 are the "8bal"
schwarzites, d168 is that of Vanderbilt and Tersoff.
Examples:
  nanocarbon make schwarzite p192 -o p192.data
  nanocarbon make schwarzite d168 --cells 2 -o d168.xyz
  nanocarbon make schwarzite p688 --cells 3 -o p688.data)");
  sub.callback([c, &sub] { make(*c, sub); });
}

}  // namespace nanocarbon::cli
