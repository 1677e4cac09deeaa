// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "make.h"
#include "make_output.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/molecule/hydrogens.h"
#include "nanocarbon/structures/bundle.h"
#include "nanocarbon/structures/capped_tube.h"
#include "nanocarbon/structures/tube.h"
#include "number_checks.h"
#include "potential_option.h"

namespace nanocarbon::cli {
namespace {

// Between walls, which the minimisation then brings to the potential's distance. Angstrom.
constexpr double gap_at_start = 3.1;

struct TubeCommand {
  int n = 0, m = 0;
  double length = 50.0;  // Angstrom
  std::string ends = "hydrogen";
  bool periodic = false;
  int bundle = 0;                 // tubes; 0: one tube alone
  std::vector<int> bundle_cells;  // along x and y, of a bundle that fills space
  std::optional<building::PotentialChoice> potential;
  MoleculeOutput output;
};

//! The whole number of periods closest to a length.
Molecule periodic_tube_of_length(int n, int m, double length) {
  if (n < 0 || m < 0 || n + m == 0) return structures::periodic_tube(n, m, 1);  // which says what is wrong
  const double periods = std::round(length / structures::tube_geometry(n, m).period);
  if (periods > 1e8) throw UserError(Failure::usage, "the tube is too long; use a shorter --length");
  return structures::periodic_tube(n, m, std::max(1, static_cast<int>(periods)));
}

Molecule single_tube(const TubeCommand& c) {
  if (c.periodic && c.ends == "capped")
    throw UserError(Failure::usage, "--periodic and --ends capped cannot be combined; leave one out");
  if (c.periodic || c.ends == "periodic") return periodic_tube_of_length(c.n, c.m, c.length);
  if (c.ends == "capped") return structures::capped_tube(c.n, c.m, c.length);
  const Molecule tube = structures::open_tube(c.n, c.m, c.length);
  return c.ends == "open" ? tube : molecule::saturated_with_hydrogen(tube);
}

//! Tubes beside each other, where a potential has its minimum.
Molecule relaxed_bundle(const TubeCommand& c) {
  const building::PotentialChoice potential = c.potential.value_or(building::PotentialChoice::airebo);
  if (potential == building::PotentialChoice::rebo2)
    throw UserError(Failure::usage,
                    "REBO2 has no force between tubes of a bundle: use --potential airebo or airebo-m");
  const Molecule tube = single_tube(c);
  const double distance = 2.0 * structures::tube_geometry(c.n, c.m).radius + gap_at_start;
  const bool crystal = !c.bundle_cells.empty();
  Molecule bundle = crystal ? structures::bundle_crystal(tube, c.bundle_cells[0], c.bundle_cells[1], distance)
                            : structures::bundle(tube, c.bundle, distance);
  relax(bundle, potential, minimisation::CellRelaxation::uniaxial, c.output);
  return bundle;
}

Molecule make_tube(const TubeCommand& c) {
  if (c.bundle > 0 && !c.bundle_cells.empty())
    throw UserError(Failure::usage, "--bundle and --bundle-cells cannot be combined; leave one out");
  if (c.bundle > 0 || !c.bundle_cells.empty()) return relaxed_bundle(c);
  if (c.potential)
    throw UserError(Failure::usage,
                    "--potential is for bundles: a single tube is written as rolled, without relaxation");
  return single_tube(c);
}

}  // namespace

void add_make_tube(CLI::App& make) {
  CLI::App& sub = *make.add_subcommand("tube", "A carbon nanotube of any chirality, by its Hamada indices");
  const auto c = std::make_shared<TubeCommand>();
  sub.add_option("N", c->n, "First Hamada index; (n, n) is armchair, (n, 0) zigzag")
      ->required()
      ->transform(whole_number())
      ->check(zero_or_more());
  sub.add_option("M", c->m, "Second Hamada index; (n, m) and (m, n) are mirror images")
      ->required()
      ->transform(whole_number())
      ->check(zero_or_more());
  sub.add_option("--length", c->length,
                 "Length, Angstrom; rounded to whole periods if periodic, without the caps if capped")
      ->check(between(0.1, 1e7))
      ->capture_default_str();
  sub.add_option("--ends", c->ends,
                 "Ends of the tube: hydrogen (cut straight and saturated), open (left with dangling bonds), "
                 "periodic, or capped (6 pentagons at each end, for n + m of 6 or more, and (5, 0))")
      ->check(CLI::IsMember({"hydrogen", "open", "periodic", "capped"}))
      ->capture_default_str();
  sub.add_flag("--periodic", c->periodic, "The same as --ends periodic");
  sub.add_option("--bundle", c->bundle,
                 "Number of tubes in a hexagonally packed bundle (7, 19 and 37 are round), relaxed by AIREBO")
      ->transform(whole_number())
      ->check(between(1, 1000));
  sub.add_option("--bundle-cells", c->bundle_cells,
                 "A bundle that fills space: the number of rectangular cells (two tubes) along x and y")
      ->expected(2)
      ->transform(whole_number())
      ->check(between(1, 100));
  add_potential_option(sub, c->potential,
                       "Potential by which a bundle is relaxed: airebo (default) or airebo-m");
  add_molecule_output(sub, c->output);
  sub.footer(
      R"(Radii and periods are those of a rolled graphene sheet with bonds of 1.4204 Angstrom; relax them in LAMMPS.
A cap is the roundest one with a pentagon in its middle, without neighbouring pentagons where there is such a one:
half a C60 for (5, 5) and (9, 0), half a C240 for (10, 10).
Examples:
  nanocarbon make tube 10 10 --length 100 --periodic -o tube.data
  nanocarbon make tube 7 3 --length 60 --ends open -o open.data
  nanocarbon make tube 10 10 --length 20 --periodic --bundle 7 -o bundle.data
  nanocarbon make tube 9 0 --length 30 --ends capped -o capped.xyz)");
  sub.callback([c, &sub] { write_molecule(c->output, make_tube(*c), sub); });
}

}  // namespace nanocarbon::cli
