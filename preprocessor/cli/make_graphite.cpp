// SPDX-License-Identifier: GPL-2.0-or-later
#include <memory>
#include <string>
#include <vector>

#include "make.h"
#include "make_output.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/structures/graphite.h"
#include "number_checks.h"
#include "potential_option.h"

namespace nanocarbon::cli {

using building::PotentialChoice;
using structures::Stacking;

void add_make_graphite(CLI::App& make) {
  struct Command {
    std::vector<double> size = {50.0, 50.0};
    std::vector<int> cells;
    int layers = 2;
    std::string stacking = "ab";
    bool slab = false;
    PotentialChoice potential = PotentialChoice::airebo;
    MoleculeOutput output;
  };
  CLI::App& sub = *make.add_subcommand("graphite", "Stacked layers of graphene, at AIREBO's distance");
  const auto c = std::make_shared<Command>();
  sub.add_option("--layers", c->layers, "Number of layers; even for periodic AB stacking")
      ->transform(whole_number())
      ->check(between(1, 1000))
      ->capture_default_str();
  sub.add_option("--stacking", c->stacking, "ab (every other layer is shifted by a bond) or aa")
      ->check(CLI::IsMember({"ab", "aa"}))
      ->capture_default_str();
  sub.add_flag("--slab", c->slab, "Not periodic along z: few-layer graphene");
  auto* shape = sub.add_option_group("Size", "One of these");
  shape->add_option("--size", c->size, "Lengths along zigzag (x) and armchair (y), Angstrom")
      ->expected(2)
      ->check(above_zero())
      ->capture_default_str();
  shape
      ->add_option("--cells", c->cells,
                   "Or the number of rectangular cells (4 atoms per layer) along x and y")
      ->expected(2)
      ->transform(whole_number())
      ->check(between(1, 20000));
  shape->require_option(0, 1);
  add_potential_option(sub, c->potential, "Potential whose distances are used: airebo (default) or airebo-m");
  add_molecule_output(sub, c->output);
  sub.footer(
      R"(Bonds and layers are where graphite's energy is least, to 7 digits: 1.39575 and 3.35800 Angstrom for AB by AIREBO.
Examples:
  nanocarbon make graphite --layers 4 --size 40 40 -o graphite.data
  nanocarbon make graphite --layers 3 --slab --potential airebo-m -o trilayer.data)");
  sub.callback([c, &sub] {
    if (c->potential == PotentialChoice::rebo2)
      throw UserError(Failure::usage,
                      "REBO2 has no force between layers of graphite: use --potential airebo or airebo-m");
    const Stacking stacking = c->stacking == "ab" ? Stacking::ab : Stacking::aa;
    const structures::GraphiteLattice lattice =
        structures::graphite_lattice(stacking, c->potential == PotentialChoice::airebo_m);
    const structures::GraphiteSize size =
        c->cells.empty() ? structures::graphite_size(c->size[0], c->size[1], c->layers, lattice)
                         : structures::GraphiteSize{c->cells[0], c->cells[1], c->layers};
    write_molecule(c->output, structures::graphite(size, stacking, lattice, c->slab), sub);
  });
}

}  // namespace nanocarbon::cli
