// SPDX-License-Identifier: GPL-2.0-or-later
#include "build.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "build_command.h"
#include "build_page.h"
#include "command_text.h"
#include "nanocarbon/building/build_report.h"
#include "nanocarbon/building/facing_sheets.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/core/output_file.h"
#include "nanocarbon/core/version.h"
#include "nanocarbon/mesh/formats/load_surface.h"
#include "nanocarbon/mesh/formats/write_mesh.h"
#include "nanocarbon/molecule/formats/lammps_data.h"
#include "nanocarbon/molecule/formats/xyz.h"
#include "progress_bar.h"

namespace nanocarbon::cli {
namespace {

namespace fs = std::filesystem;

// An output that cannot be written is better known before the work than after it.
void require_writable(const fs::path& output) {
  const fs::path folder = output.has_parent_path() ? output.parent_path() : fs::path(".");
  if (output.empty()) throw UserError(Failure::usage, "the name of an output file is empty; give it a name");
  if (!fs::is_directory(folder))
    throw UserError(Failure::unwritable,
                    fmt::format("{}: cannot be written: there is no folder {}; create it first",
                                output.string(), folder.string()));
  if (fs::is_directory(output))
    throw UserError(Failure::unwritable,
                    fmt::format("{}: cannot be written: it is a folder", output.string()));
}

// No output may overwrite the mesh or another output.
void require_different_files(const BuildCommand& command, const std::vector<fs::path>& outputs) {
  std::map<fs::path, std::string> taken{{fs::weakly_canonical(command.mesh), "the mesh"}};
  for (const fs::path& output : outputs) {
    if (fs::exists(output) && !fs::is_regular_file(output)) continue;  // such as /dev/stdout
    const auto [other, is_new] = taken.emplace(fs::weakly_canonical(output), "another output");
    if (!is_new)
      throw UserError(Failure::usage,
                      fmt::format("{}: is also the file of {}; give each output a file of its own",
                                  output.string(), other->second));
  }
}

void require_outputs(const BuildCommand& command) {
  std::vector<fs::path> outputs{command.data};
  for (const auto& output : {command.xyz, command.triangulation, command.report, command.page})
    if (output) outputs.push_back(*output);
  for (const fs::path& output : outputs) require_writable(output);
  require_different_files(command, outputs);
  if (command.triangulation) mesh::format_to_write(*command.triangulation);
  if (command.page) page::require_pages();
}

// The errors of building do not know the file.
building::BuildResult build_naming_the_file(const std::string& file, const TriangleMesh& surface,
                                            const building::BuildOptions& options) {
  try {
    return building::build_molecule(surface, options);
  } catch (const UserError& error) {
    throw UserError(error.failure(), fmt::format("{}: {}", file, error.what()));
  }
}

// The report comes last: it tells how long writing the others took.
void write_outputs(const BuildCommand& command, const building::BuildResult& result,
                   nlohmann::ordered_json& report, StageClock& clock) {
  const std::string made_by = fmt::format("{} (nanocarbon {})", command.command_line, version);
  OutputFiles files;
  {
    const auto stage = StageClock::stage(&clock, "writing");
    files.add(command.data, [&](std::ostream& out) {
      molecule::write_lammps_data(out, result.molecule, {command.atom_style, command.margin, made_by});
    });
  }
  if (command.xyz)
    files.add(*command.xyz, [&](std::ostream& out) { molecule::write_xyz(out, result.molecule, made_by); });
  if (command.triangulation) {
    const double edge = std::sqrt(3.0);  // of the triangulation, in bonds
    const thesis::ThesisOptions& interval = command.build.thesis;
    const mesh::MeshColours colours =
        mesh::colours_by_quality(result.triangulation, edge * interval.min_bond, edge * interval.max_bond);
    files.add(*command.triangulation, [&](std::ostream& out) {
      mesh::write_mesh(out, mesh::format_to_write(*command.triangulation), result.triangulation,
                       {.colours = &colours});
    });
  }
  if (command.page)
    files.add(*command.page,
              [&](std::ostream& out) { page::write_page(out, build_page(command, result, report)); });
  if (command.report) {
    report["stages"] = building::stages_json(clock);
    files.add(*command.report, [&](std::ostream& out) { out << report.dump(2) << '\n'; });
  }
  files.publish();
}

std::string what_the_proof_lacks(const minimisation::Certificate& certificate) {
  std::vector<std::string> lacks;
  if (certificate.max_force >= minimisation::certified_force)
    lacks.push_back(fmt::format("a force of {:.1e} eV/A remains", certificate.max_force));
  if (!certificate.eigenvalues.empty() && certificate.eigenvalues.front() <= certificate.uncertainty)
    lacks.push_back(
        fmt::format("the Hessian's smallest eigenvalue is {:.1e} eV/A^2, with an uncertainty of {:.1e}",
                    certificate.eigenvalues.front(), certificate.uncertainty));
  if (!certificate.complete) lacks.push_back("smaller eigenvalues of the Hessian may have been missed");
  return fmt::format("{}", fmt::join(lacks, "; "));
}

// The outputs are there to be looked at, but a script must not take them for proven.
void require_proof(const BuildCommand& command, const building::BuildResult& result) {
  if (!result.certificate || result.certificate->minimum() || command.build.force) return;
  throw UserError(
      Failure::failed,
      fmt::format("{}: written, but not shown to be at a minimum: {}; --force accepts it as it is",
                  command.data.string(), what_the_proof_lacks(*result.certificate)));
}

// Where REBO2 has no force any more, and nothing but chance keeps sheets apart.
void warn_of_facing_sheets(const Molecule& molecule, building::PotentialChoice potential,
                           const std::function<void(const char*, const std::vector<std::string>&)>& tell) {
  constexpr double far_enough = 3.0;  // Angstrom; two sheets rest 3.36 apart by AIREBO
  if (potential != building::PotentialChoice::rebo2) return;
  const double closest = building::closest_of_facing_sheets(molecule, far_enough);
  if (closest < far_enough)
    tell("warning", {fmt::format("sheets that face each other come within {:.2f} A: REBO2 does not keep them "
                                 "apart; --potential airebo does",
                                 closest)});
}

void run(BuildCommand& command) {
  require_outputs(command);
  building::BuildOptions& options = command.build;
  options.thesis = thesis_options(command);
  options.threads = command.common.threads;
  options.seed = command.common.seed;
  options.fit = command.atoms == "fit";
  if (options.fit && options.recipe != building::Recipe::annealed)
    throw UserError(Failure::usage, "--atoms fit works with the annealed recipe only: give a number");
  if (!command.atoms.empty() && !options.fit)
    options.size = building::AtomCount{static_cast<std::size_t>(std::stoull(command.atoms))};
  if (command.length) options.size = building::LongestSide{*command.length};
  if (command.scale) options.size = building::UnitScale{*command.scale};

  StageClock clock;
  options.clock = &clock;
  mesh::LoadedSurface surface = [&] {
    const auto stage = StageClock::stage(&clock, "reading");
    return load_surface(command.mesh, command.surface, !command.no_repair, cell_request(command.cell));
  }();
  const auto tell = [&](const char* kind, const std::vector<std::string>& facts) {
    if (command.common.quiet) return;
    for (const std::string& fact : facts)
      fmt::print(stderr, "nanocarbon: {}: {}: {}\n", kind, command.mesh, fact);
  };
  tell("note", surface.repairs);
  tell("warning", surface.warnings);
  options.tell = [&](const std::string& fact) { tell("note", {fact}); };

  if (surface.mesh.space.periodic() && command.triangulation &&
      mesh::format_to_write(*command.triangulation) == mesh::MeshFormat::stl)
    throw UserError(Failure::usage,
                    fmt::format("{}: an STL file cannot hold a periodic cell; name an OFF, OBJ or PLY file",
                                command.triangulation->string()));

  building::BuildResult result;
  {
    ProgressBar bar(command.common.quiet);
    options.progress = [&](std::string_view stage, double fraction) { bar.show(stage, fraction); };
    result = build_naming_the_file(command.mesh, surface.mesh, options);
  }
  if (result.likeness) tell("warning", result.likeness->warnings());
  if (result.specks_dropped > 0)
    surface.repairs.push_back(fmt::format("dropped specks: {}", result.specks_dropped));
  if (result.specks_dropped > 0) tell("note", {surface.repairs.back()});
  if (result.rest && result.rest->max_force > options.force_tolerance)
    tell("warning", {fmt::format("the largest remaining force is {:.1e} eV/A, not below the {:.1e} asked for",
                                 result.rest->max_force, options.force_tolerance)});
  if (result.annealed) warn_of_facing_sheets(result.molecule, options.potential, tell);
  auto report =
      building::build_report(result, options, {command.command_line, command.mesh, surface.repairs});
  write_outputs(command, result, report, clock);
  if (!command.common.quiet) fmt::print("{}\n{}", command.data.string(), building::report_table(report));
  require_proof(command, result);
}

}  // namespace

void add_build(CLI::App& app) {
  CLI::App& sub = *app.add_subcommand("build", "Make a carbon molecule from a mesh, as a LAMMPS data file");
  const auto command = std::make_shared<BuildCommand>();
  BuildCommand& c = *command;

  sub.add_option("MESH", c.mesh,
                 "Triangle or polygon mesh (OFF, OBJ, PLY, STL, glTF, 3MF, VTK, MSH), or a scalar field with "
                 "--level (cube, MRC, VTI)")
      ->required();
  sub.add_option("-o,--output", c.data, "LAMMPS data file to write")->required()->type_name("FILE");
  add_build_options(sub, c);
  add_common_options(sub, c.common);
  sub.footer(R"(--recipe thesis and its forerunners draw nothing at random: --seed changes nothing there.
Examples:
  nanocarbon build torus.off -o torus.data --atoms 2000
  nanocarbon build part.stl -o part.data --length 80 --report part.json --xyz part.xyz
  nanocarbon build schwarz.off -o schwarz.data --atoms 400 --relax-cell triclinic
  nanocarbon build bunny.off -o bunny.data --atoms 10000 --recipe thesis --projection-interval 10 --local-threshold 5
Then, in LAMMPS:
  lmp -in examples/validate.in -var data torus.data)");
  sub.callback([command, &sub] {
    command->command_line = command_text(sub);
    require_options_of_recipe(sub, command->build.recipe);
    run(*command);
  });
}

}  // namespace nanocarbon::cli
