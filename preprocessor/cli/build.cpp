#include "build.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "build_command.h"
#include "command_text.h"
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

}  // namespace

void add_build(CLI::App& app) {
  CLI::App& sub = *app.add_subcommand("build", "Make a carbon molecule from a mesh: a LAMMPS data file");
  const auto command = std::make_shared<BuildCommand>();
  BuildCommand& c = *command;

  sub.add_option("MESH", c.mesh, "Triangle or polygon mesh: OFF, OBJ, PLY or STL, text or binary")
      ->required();
  sub.add_option("-o,--output", c.data, "LAMMPS data file to write")->required()->type_name("FILE");
  add_build_options(sub, c);
  add_common_options(sub, c.common);
  sub.footer(R"(Examples:
  nanocarbon build torus.off -o torus.data --atoms 2000
  nanocarbon build part.stl -o part.data --length 80 --report part.json --xyz part.xyz
  nanocarbon build bunny.off -o bunny.data --atoms 10000 --recipe thesis --projection-interval 10 --local-threshold 5
Then, in LAMMPS:
  lmp -in examples/validate.in -var data torus.data)");
  sub.callback([command, &sub] {
    command->command_line = command_text(sub);
    run(*command);
  });
}

}  // namespace nanocarbon
