// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "make.h"
#include "make_output.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/molecule/hydrogens.h"
#include "nanocarbon/structures/capped_tube.h"
#include "nanocarbon/structures/tube.h"
#include "number_checks.h"

namespace nanocarbon::cli {
namespace {

struct TubeCommand {
  int n = 0, m = 0;
  double length = 50.0;  // Angstrom
  std::string ends = "hydrogen";
  bool periodic = false;
  MoleculeOutput output;
};

//! The whole number of periods closest to a length.
Molecule periodic_tube_of_length(int n, int m, double length) {
  if (n < 0 || m < 0 || n + m == 0) return structures::periodic_tube(n, m, 1);  // which says what is wrong
  const double periods = std::round(length / structures::tube_geometry(n, m).period);
  if (periods > 1e8) throw UserError(Failure::usage, "the tube is too long; take a shorter --length");
  return structures::periodic_tube(n, m, std::max(1, static_cast<int>(periods)));
}

Molecule make_tube(const TubeCommand& c) {
  if (c.periodic && c.ends == "capped")
    throw UserError(Failure::usage, "--periodic and --ends capped exclude each other; leave one out");
  if (c.periodic || c.ends == "periodic") return periodic_tube_of_length(c.n, c.m, c.length);
  if (c.ends == "capped") return structures::capped_tube(c.n, c.m, c.length);
  const Molecule tube = structures::open_tube(c.n, c.m, c.length);
  return c.ends == "open" ? tube : molecule::saturated_with_hydrogen(tube);
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
  sub.add_option(
         "--length", c->length,
         "Length, Angstrom; of a periodic tube rounded to whole periods, of a capped one without its caps")
      ->check(between(0.1, 1e7))
      ->capture_default_str();
  sub.add_option("--ends", c->ends,
                 "hydrogen (cut straight and saturated), open (left with dangling bonds), periodic, or "
                 "capped (6 pentagons at each end, for n + m of 6 or more, and (5, 0))")
      ->check(CLI::IsMember({"hydrogen", "open", "periodic", "capped"}))
      ->capture_default_str();
  sub.add_flag("--periodic", c->periodic, "The same as --ends periodic");
  add_molecule_output(sub, c->output);
  sub.footer(
      R"(Radii and periods are those of a rolled graphene sheet with bonds of 1.4204 Angstrom; relax them in LAMMPS.
A cap is the roundest one with a pentagon in its middle, without neighbouring pentagons where there is such a one:
half a C60 for (5, 5) and (9, 0), half a C240 for (10, 10).
Examples:
  nanocarbon make tube 10 10 --length 100 --periodic -o tube.data
  nanocarbon make tube 7 3 --length 60 --ends open -o open.data
  nanocarbon make tube 9 0 --length 30 --ends capped -o capped.xyz)");
  sub.callback([c, &sub] { write_molecule(c->output, make_tube(*c), sub); });
}

}  // namespace nanocarbon::cli
