// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <array>
#include <memory>
#include <vector>

#include "make.h"
#include "make_output.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/molecule/hydrogens.h"
#include "nanocarbon/structures/diamond.h"
#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/structures/graphene.h"
#include "nanocarbon/structures/onion.h"
#include "number_checks.h"
#include "potential_option.h"

namespace nanocarbon::cli {

void add_make_graphene(CLI::App& make) {
  struct Command {
    std::vector<double> size = {50.0, 50.0};
    std::vector<int> cells;
    double flake = 0.0;  // radius, Angstrom
    bool hydrogen = false;
    MoleculeOutput output;
  };
  CLI::App& sub = *make.add_subcommand("graphene", "A sheet of graphene, periodic, or a flake of it");
  const auto c = std::make_shared<Command>();
  auto* shape = sub.add_option_group("Size", "One of these");
  shape
      ->add_option("--size", c->size,
                   "Lengths of a periodic sheet along zigzag (x) and armchair (y), Angstrom")
      ->expected(2)
      ->check(above_zero())
      ->capture_default_str();
  shape->add_option("--cells", c->cells, "Or the number of rectangular cells (4 atoms) along x and y")
      ->expected(2)
      ->transform(whole_number())
      ->check(between(1, 20000));
  shape->add_option("--flake", c->flake, "Or the radius of a flake in free space, Angstrom")
      ->check(between(1.5, 5000.0));
  shape->require_option(0, 1);
  sub.add_flag("--hydrogen", c->hydrogen, "Saturate the edge of a flake with hydrogen");
  add_molecule_output(sub, c->output);
  sub.footer(R"(Examples:
  nanocarbon make graphene --size 100 100 -o sheet.data
  nanocarbon make graphene --flake 20 --hydrogen -o flake.xyz)");
  sub.callback([c, &sub] {
    if (c->hydrogen && c->flake == 0.0)
      throw UserError(Failure::usage, "--hydrogen is for the edge of a flake: a periodic sheet has none");
    const Molecule molecule = c->flake > 0.0      ? structures::graphene_flake(c->flake)
                              : !c->cells.empty() ? structures::graphene(c->cells[0], c->cells[1])
                                                  : structures::graphene_sheet(c->size[0], c->size[1]);
    write_molecule(c->output, c->hydrogen ? molecule::saturated_with_hydrogen(molecule) : molecule, sub);
  });
}

void add_make_fullerene(CLI::App& make) {
  struct Command {
    int h = 0, k = 0;
    MoleculeOutput output;
  };
  CLI::App& sub = *make.add_subcommand("fullerene", "An icosahedral fullerene, by its Goldberg pair");
  const auto c = std::make_shared<Command>();
  sub.add_option("H", c->h, "First Goldberg index")
      ->required()
      ->transform(whole_number())
      ->check(zero_or_more());
  sub.add_option("K", c->k, "Second Goldberg index; it has 20 (H^2 + H K + K^2) atoms")
      ->required()
      ->transform(whole_number())
      ->check(zero_or_more());
  add_molecule_output(sub, c->output);
  sub.footer(
      R"(C20 is 1 0, C60 is 1 1, C80 is 2 0, C140 is 2 1 (and its mirror image 1 2), C240 is 2 2, C540 is 3 3.
Examples:
  nanocarbon make fullerene 1 1 -o c60.data
  nanocarbon make fullerene 5 3 -o c980.xyz)");
  sub.callback([c, &sub] { write_molecule(c->output, structures::fullerene(c->h, c->k), sub); });
}

void add_make_onion(CLI::App& make) {
  struct Command {
    int shells = 3, innermost = 1;
    building::PotentialChoice potential = building::PotentialChoice::airebo;
    MoleculeOutput output;
  };
  CLI::App& sub = *make.add_subcommand("onion", "Nested icosahedral fullerenes (k, k)");
  const auto c = std::make_shared<Command>();
  sub.add_option("--shells", c->shells, "Number of fullerenes")
      ->transform(whole_number())
      ->check(between(1, 60))
      ->capture_default_str();
  sub.add_option("--innermost", c->innermost, "k of the innermost one: 1 is C60, 2 is C240, ...")
      ->transform(whole_number())
      ->check(between(1, 400))
      ->capture_default_str();
  add_potential_option(sub, c->potential,
                       "Potential by which it is relaxed: airebo (default) or airebo-m; with rebo2 it stays "
                       "as built, near equilibrium under REBO2");
  add_molecule_output(sub, c->output);
  sub.footer(
      R"(Shells are about 3.5 Angstrom apart, not bonded, and relaxed by AIREBO, which attracts them to each other.
Example:
  nanocarbon make onion --shells 4 -o onion.data)");
  sub.callback([c, &sub] {
    Molecule onion = structures::onion(c->innermost, c->shells);
    if (c->potential != building::PotentialChoice::rebo2)
      relax(onion, c->potential, minimisation::CellRelaxation::none, c->output);
    write_molecule(c->output, onion, sub);
  });
}

void add_make_diamond(CLI::App& make) {
  struct Command {
    std::vector<int> cells = {5};
    MoleculeOutput output;
  };
  CLI::App& sub = *make.add_subcommand("diamond", "Diamond, periodic, cubic cells of 8 atoms");
  const auto c = std::make_shared<Command>();
  add_cells_option(sub, c->cells)->capture_default_str();
  add_molecule_output(sub, c->output);
  sub.footer("Example:\n  nanocarbon make diamond --cells 4 -o diamond.data");
  sub.callback([c, &sub] {
    const auto [x, y, z] = three_cells(c->cells);
    write_molecule(c->output, structures::diamond(x, y, z), sub);
  });
}

}  // namespace nanocarbon::cli
