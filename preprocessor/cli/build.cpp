#include "build.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "common_options.h"
#include "nanocarbon/building/build_molecule.h"
#include "nanocarbon/building/build_report.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/core/output_file.h"
#include "nanocarbon/core/version.h"
#include "nanocarbon/mesh/surface.h"
#include "nanocarbon/mesh/write_mesh.h"
#include "nanocarbon/molecule/lammps_data.h"
#include "nanocarbon/molecule/xyz.h"
#include "progress_bar.h"

namespace nanocarbon {
namespace {

namespace fs = std::filesystem;

struct BuildCommand {
  std::string mesh;
  fs::path data;
  std::optional<fs::path> xyz, triangulation, report;
  std::optional<std::size_t> atoms;
  std::optional<double> length, scale;
  std::optional<double> min_bond, max_bond, local_threshold;
  std::optional<unsigned> iterations, rings, projection_interval;
  AtomStyle atom_style = AtomStyle::molecular;
  double margin = 10.0;
  BuildOptions build;
  CommonOptions common;
  std::string command_line;
};

// An output that cannot be written is better known before the work than after it.
void require_writable_folder(const fs::path& output) {
  const fs::path folder = output.has_parent_path() ? output.parent_path() : fs::path(".");
  if (!fs::is_directory(folder))
    throw UserError(Failure::unwritable,
                    fmt::format("{}: cannot be written: there is no folder {}; create it first",
                                output.string(), folder.string()));
  if (fs::is_directory(output))
    throw UserError(Failure::unwritable,
                    fmt::format("{}: cannot be written: it is a folder", output.string()));
}

// The recipe's own parameters, then those given on the command line.
ThesisOptions thesis_options(const BuildCommand& c) {
  ThesisOptions options;
  switch (c.build.recipe) {
    case Recipe::thesis:
      break;
    case Recipe::pecanha2013:
      options = pecanha2013_options();
      break;
    case Recipe::hauck2014:
      options = hauck2014_options();
      break;
    case Recipe::hauck2015:
      options = hauck2015_options();
      break;
  }
  if (c.min_bond) options.min_bond = *c.min_bond;
  if (c.max_bond) options.max_bond = *c.max_bond;
  if (c.iterations) options.iterations = *c.iterations;
  if (c.rings) options.rings = *c.rings;
  if (c.projection_interval) options.projection_interval = *c.projection_interval;
  if (c.local_threshold) options.local_threshold = *c.local_threshold;
  if (!(options.min_bond < options.max_bond))
    throw UserError(Failure::usage, fmt::format("--min-bond {} is not below --max-bond {}: give an interval",
                                                options.min_bond, options.max_bond));
  return options;
}

void run(BuildCommand& command) {
  for (const std::optional<fs::path>& output :
       {std::optional(command.data), command.xyz, command.triangulation, command.report})
    if (output) require_writable_folder(*output);

  const LoadedSurface surface = load_surface(command.mesh);
  if (!command.common.quiet)
    for (const std::string& repair : surface.repairs)
      fmt::print(stderr, "nanocarbon: note: {}: {}\n", command.mesh, repair);

  BuildOptions& options = command.build;
  options.thesis = thesis_options(command);
  options.threads = command.common.threads;
  options.seed = command.common.seed;
  if (command.atoms) options.size = AtomCount{*command.atoms};
  if (command.length) options.size = LongestSide{*command.length};
  if (command.scale) options.size = UnitScale{*command.scale};

  BuildResult result;
  {
    ProgressBar bar(command.common.quiet);
    options.progress = [&](std::string_view stage, double fraction) { bar.show(stage, fraction); };
    result = build_molecule(surface.mesh, options);
  }

  const auto report = build_report(result, options, {command.command_line, command.mesh, surface.repairs});
  const std::string made_by = fmt::format("{} (nanocarbon {})", command.command_line, version);
  write_lammps_data(command.data, result.molecule, {command.atom_style, command.margin, made_by});
  if (command.xyz) write_xyz(*command.xyz, result.molecule, made_by);
  if (command.triangulation) {
    const double edge = std::sqrt(3.0);  // of the triangulation, in bonds
    const MeshColours colours = colours_by_quality(result.triangulation, edge * options.thesis.min_bond,
                                                   edge * options.thesis.max_bond);
    write_mesh(*command.triangulation, result.triangulation, {.colours = &colours});
  }
  if (command.report) write_file(*command.report, [&](std::ostream& out) { out << report.dump(2) << '\n'; });
  if (!command.common.quiet) fmt::print("{}\n{}", command.data.string(), report_table(report));
}

void add_size_options(CLI::App& sub, BuildCommand& c) {
  auto* size =
      sub.add_option_group("Size", "One of these; without any, an atom for each triangle of the mesh");
  size->add_option("--atoms", c.atoms, "Number of atoms, met within a few percent")
      ->check(CLI::PositiveNumber);
  size->add_option("--length", c.length, "Longest side of the bounding box, Angstrom")
      ->check(CLI::PositiveNumber);
  size->add_option("--scale", c.scale, "Angstrom for each mesh unit")->check(CLI::PositiveNumber);
  size->require_option(0, 1);
}

void add_output_options(CLI::App& sub, BuildCommand& c) {
  sub.add_option("--atom-style", c.atom_style, "LAMMPS atom style: atomic, charge, molecular or full")
      ->transform(
          CLI::CheckedTransformer(std::map<std::string, AtomStyle>{{"atomic", AtomStyle::atomic},
                                                                   {"charge", AtomStyle::charge},
                                                                   {"molecular", AtomStyle::molecular},
                                                                   {"full", AtomStyle::full}}))
      ->default_str("molecular")
      ->type_name("STYLE");
  sub.add_option("--margin", c.margin, "Empty box around the atoms, Angstrom")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  sub.add_option("--xyz", c.xyz, "Also write extended XYZ")->type_name("FILE");
  sub.add_option(
         "--mesh", c.triangulation,
         "Also write the triangulation, as PLY coloured by edge length and valence (or OFF, OBJ, STL)")
      ->type_name("FILE");
  sub.add_option("--report", c.report, "Also write everything known about the result, as JSON")
      ->type_name("FILE");
}

void add_thesis_options(CLI::App& sub, BuildCommand& c) {
  auto* group =
      sub.add_option_group("Recipe", "How the mesh becomes a molecule, and the thesis's parameters");
  group
      ->add_option(
          "--recipe", c.build.recipe,
          "thesis (adaptive remeshing, then the dual), or its forerunners pecanha2013, hauck2014, hauck2015")
      ->transform(CLI::CheckedTransformer(std::map<std::string, Recipe>{{"thesis", Recipe::thesis},
                                                                        {"pecanha2013", Recipe::pecanha2013},
                                                                        {"hauck2014", Recipe::hauck2014},
                                                                        {"hauck2015", Recipe::hauck2015}}))
      ->default_str("thesis")
      ->type_name("NAME");
  group->add_option("--min-bond", c.min_bond, "Shortest bond wanted, Angstrom (1.2)")
      ->check(CLI::PositiveNumber);
  group->add_option("--max-bond", c.max_bond, "Longest bond wanted, Angstrom (1.8)")
      ->check(CLI::PositiveNumber);
  group->add_option("--iterations", c.iterations, "Most iterations, n (150)")->check(CLI::NonNegativeNumber);
  group->add_option("--rings", c.rings, "Rings of the low-pass filter, k (2)")->check(CLI::Range(1, 10));
  group
      ->add_option("--projection-interval", c.projection_interval,
                   "Iterations between replacements of the projection mesh, p (10); 0: never")
      ->check(CLI::NonNegativeNumber);
  group
      ->add_option("--local-threshold", c.local_threshold,
                   "Percentage of edges outside the interval below which optimisation is local, s (5)")
      ->check(CLI::Range(0.0, 100.0));
}

}  // namespace

void add_build(CLI::App& app) {
  CLI::App& sub = *app.add_subcommand("build", "Make a carbon molecule from a mesh: a LAMMPS data file");
  const auto command = std::make_shared<BuildCommand>();
  BuildCommand& c = *command;

  sub.add_option("MESH", c.mesh, "Triangle or polygon mesh: OFF, OBJ, PLY or STL, text or binary")
      ->required();
  sub.add_option("-o,--output", c.data, "LAMMPS data file to write")->required()->type_name("FILE");
  add_size_options(sub, c);
  add_output_options(sub, c);
  add_thesis_options(sub, c);
  add_common_options(sub, c.common);
  sub.footer(R"(Examples:
  nanocarbon build torus.off -o torus.data --atoms 2000
  nanocarbon build part.stl -o part.data --length 80 --report part.json --xyz part.xyz
  nanocarbon build bunny.off -o bunny.data --atoms 10000 --recipe thesis --projection-interval 10 --local-threshold 5
Then, in LAMMPS:
  lmp -in examples/validate.in -var data torus.data)");
  sub.callback([command] { run(*command); });
}

}  // namespace nanocarbon
