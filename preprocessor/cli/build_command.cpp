// SPDX-License-Identifier: GPL-2.0-or-later
#include "build_command.h"

#include <fmt/format.h>

#include <map>
#include <string>
#include <type_traits>
#include <vector>

#include "nanocarbon/core/error.h"
#include "number_checks.h"
#include "potential_option.h"

namespace nanocarbon::cli {
namespace {

// An option that takes one of a few names. (CLI11's transformers would replace the name that was typed by a
// number, and the command line that goes into the files would show that.)
template <class Value>
void add_choice(CLI::App& app, const std::string& option, Value& value,
                const std::type_identity_t<std::map<std::string, Value>>& choices, const std::string& help) {
  app.add_option_function<std::string>(
         option, [&value, choices](const std::string& name) { value = choices.at(name); }, help)
      ->check(CLI::IsMember(choices))
      ->type_name("NAME");
}

// A whole number above zero, or a word in its place.
CLI::Validator whole_number_or(const std::string& word) {
  return CLI::Validator(
      [word, number = whole_number(), positive = above_zero()](std::string& text) {
        if (text == word) return std::string();
        const std::string fault = number(text);
        return fault.empty() ? positive(text) : fault;
      },
      "");
}

const std::map<std::string, minimisation::CellRelaxation> cell_relaxations = {
    {"none", minimisation::CellRelaxation::none},
    {"isotropic", minimisation::CellRelaxation::isotropic},
    {"orthogonal", minimisation::CellRelaxation::orthogonal},
    {"triclinic", minimisation::CellRelaxation::triclinic}};

void add_size_options(CLI::App& sub, BuildCommand& c) {
  auto* size =
      sub.add_option_group("Size", "At most one of these; with none, one atom per triangle of the mesh");
  size->add_option("--atoms", c.atoms,
                   "Number of atoms, met within a few percent where the shape allows; or fit: the smallest "
                   "number that the shape's features allow and for which a molecule holds")
      ->transform(whole_number_or("fit"))
      ->type_name("N|fit");
  size->add_option("--length", c.length,
                   "Longest side of the bounding box, or longest periodic edge of the cell, Angstrom")
      ->check(above_zero());
  size->add_option("--scale", c.scale, "Angstrom per mesh unit")->check(above_zero());
  size->require_option(0, 1);
}

void add_mesh_options(CLI::App& sub, BuildCommand& c) {
  auto* group = sub.add_option_group("Mesh", "Changes to the mesh before building");
  add_surface_options(*group, c.surface);
  group->add_flag("--drop-specks", c.build.drop_specks,
                  "Leave out pieces too small for a cage of carbon, such as specks in segmented scans");
  group->add_flag("--no-repair", c.no_repair, "Refuse a mesh that needs repairs, and say which they are")
      ->excludes(group->get_option("--wrap"))
      ->excludes(group->get_option("--unite"))
      ->excludes(group->get_option("--untangle"));
}

void add_output_options(CLI::App& sub, BuildCommand& c) {
  add_choice(sub, "--atom-style", c.atom_style,
             {{"atomic", molecule::AtomStyle::atomic},
              {"charge", molecule::AtomStyle::charge},
              {"molecular", molecule::AtomStyle::molecular},
              {"full", molecule::AtomStyle::full}},
             "LAMMPS atom style: atomic, charge, molecular (default) or full");
  sub.add_option("--margin", c.margin, "Empty box around the atoms, Angstrom")
      ->check(between(0.0, 1e6))
      ->capture_default_str();
  sub.add_option("--xyz", c.xyz, "Also write extended XYZ")->type_name("FILE");
  sub.add_option(
         "--mesh", c.triangulation,
         "Also write the triangulation, as PLY coloured by edge length and valence (or OFF, OBJ, STL)")
      ->type_name("FILE");
  sub.add_option("--report", c.report, "Also write everything known about the result, as JSON")
      ->type_name("FILE");
  sub.add_option(
         "--page", c.page,
         "Also write a self-contained page (HTML): the molecule and the mesh in 3D, plots, the verdict")
      ->type_name("FILE");
}

void add_recipe_options(CLI::App& sub, BuildCommand& c) {
  auto* group = sub.add_option_group("Recipe", "How the mesh becomes a molecule");
  add_choice(
      *group, "--recipe", c.build.recipe,
      {{"annealed", building::Recipe::annealed},
       {"thesis", building::Recipe::thesis},
       {"pecanha2013", building::Recipe::pecanha2013},
       {"hauck2014", building::Recipe::hauck2014},
       {"hauck2015", building::Recipe::hauck2015}},
      "annealed (default; needs no parameters), thesis (adaptive remeshing, then the dual), or the thesis's "
      "forerunners pecanha2013, hauck2014, hauck2015");
  add_potential_option(
      *group, c.build.potential,
      "Potential of the last minimisation and the checks: rebo2 (default), airebo or airebo-m");
  add_choice(
      *group, "--boundary", c.build.boundary,
      {{"hydrogen", building::Boundary::hydrogen}, {"bare", building::Boundary::bare}},
      "Carbon at boundaries of the mesh, which has two neighbours: with a hydrogen atom each (hydrogen, "
      "default), or with a dangling bond (bare)");
  add_choice(*group, "--quality", c.build.quality,
             {{"draft", Quality::draft}, {"good", Quality::good}, {"best", Quality::best}},
             "Effort spent on a low energy: draft, good (default) or best");
  group->add_option("--bond-length", c.build.bond_length, "Bond length used to compute the size, Angstrom")
      ->check(between(1.0, 2.0))
      ->capture_default_str();
  group
      ->add_option("--tether", c.build.tether,
                   "Stiffness of the tether that holds atoms to the surface during annealing, eV/Angstrom^2: "
                   "the stiffer, the closer to the surface, at some cost in energy")
      ->check(zero_or_more());
  group->add_option("--max-force", c.build.force_tolerance, "Largest force allowed at the end, eV/Angstrom")
      ->check(above_zero())
      ->capture_default_str();
  group
      ->add_option_function<std::string>(
          "--relax-cell", [&c](const std::string& name) { c.build.relax_cell = cell_relaxations.at(name); },
          "Strains of a periodic cell that the final minimisation may change: none, isotropic, orthogonal or "
          "triclinic; by default isotropic with --atoms, none with --length or --scale and for sheets")
      ->check(CLI::IsMember(cell_relaxations))
      ->type_name("NAME");
  group->add_flag("--certify", c.build.certify,
                  "Prove that the molecule is at a minimum: forces below 1e-6 eV/Angstrom, Hessian positive; "
                  "if that cannot be shown, the files are written but the exit code is 8");
  group->add_flag("--force", c.build.force,
                  "Build even if the shape's features need more atoms, and keep a molecule that does not "
                  "hold, has lost the shape, or is not shown to be at a minimum");
}

void add_thesis_options(CLI::App& sub, BuildCommand& c) {
  auto* group = sub.add_option_group("Thesis", "Parameters of the thesis and its forerunners");
  group->add_option("--min-bond", c.min_bond, "Shortest bond wanted, Angstrom (1.2)")->check(above_zero());
  group->add_option("--max-bond", c.max_bond, "Longest bond wanted, Angstrom (1.8)")->check(above_zero());
  group->add_option("--iterations", c.iterations, "Maximum number of iterations, n (150)")
      ->transform(whole_number())
      ->check(zero_or_more());
  group->add_option("--rings", c.rings, "Rings of the low-pass filter, k (2)")
      ->transform(whole_number())
      ->check(between(1, 10));
  group
      ->add_option("--projection-interval", c.projection_interval,
                   "Iterations between replacements of the projection mesh, p (10); 0: never")
      ->transform(whole_number())
      ->check(zero_or_more());
  group
      ->add_option("--local-threshold", c.local_threshold,
                   "Percentage of edges outside the interval below which optimisation is local, s (5)")
      ->check(between(0.0, 100.0));
  group->add_flag(
      "--relax", c.build.relax,
      "Relax the dual to a minimum of REBO2 with the bonds it has, as the annealed recipe does first");
  add_choice(*group, "--visited", c.visited,
             {{"either", thesis::VisitedMarks::either_end}, {"both", thesis::VisitedMarks::both_ends}},
             "A stellar operation skips an edge if either end was touched before (default), or only if both "
             "were, as Algorithm 3 is printed, which does not converge");
}

}  // namespace

void add_build_options(CLI::App& subcommand, BuildCommand& command) {
  add_size_options(subcommand, command);
  add_mesh_options(subcommand, command);
  add_cell_options(subcommand, command.cell);
  add_output_options(subcommand, command);
  add_recipe_options(subcommand, command);
  add_thesis_options(subcommand, command);
}

void require_options_of_recipe(const CLI::App& subcommand, building::Recipe recipe) {
  const auto refuse = [&](const std::vector<std::string>& options, const std::string& reason) {
    for (const std::string& option : options)
      if (subcommand.get_option(option)->count() > 0)
        throw UserError(Failure::usage, fmt::format("{} has no effect with --recipe {} ({}): leave it out",
                                                    option, name(recipe), reason));
  };
  if (recipe == building::Recipe::annealed) {
    refuse({"--iterations", "--rings", "--projection-interval", "--local-threshold", "--visited", "--relax"},
           "it belongs to --recipe thesis and its forerunners");
    return;
  }
  refuse({"--bond-length"}, "its bond length is midway between --min-bond and --max-bond");
  refuse({"--boundary"}, "its dual is written as it is, with dangling bonds at boundaries");
  refuse({"--quality", "--tether", "--max-force", "--certify", "--relax-cell"},
         "it neither anneals nor minimises");
}

thesis::ThesisOptions thesis_options(const BuildCommand& c) {
  thesis::ThesisOptions options;
  switch (c.build.recipe) {
    case building::Recipe::annealed:
    case building::Recipe::thesis:
      break;
    case building::Recipe::pecanha2013:
      options = thesis::pecanha2013_options();
      break;
    case building::Recipe::hauck2014:
      options = thesis::hauck2014_options();
      break;
    case building::Recipe::hauck2015:
      options = thesis::hauck2015_options();
      break;
  }
  if (c.min_bond) options.min_bond = *c.min_bond;
  if (c.max_bond) options.max_bond = *c.max_bond;
  if (c.iterations) options.iterations = *c.iterations;
  if (c.rings) options.rings = *c.rings;
  if (c.projection_interval) options.projection_interval = *c.projection_interval;
  if (c.local_threshold) options.local_threshold = *c.local_threshold;
  if (c.visited) options.marks = *c.visited;
  if (!(options.min_bond < options.max_bond))
    throw UserError(Failure::usage, fmt::format("--min-bond {} is not below --max-bond {}: give an interval",
                                                options.min_bond, options.max_bond));
  return options;
}

}  // namespace nanocarbon::cli
