// SPDX-License-Identifier: GPL-2.0-or-later
#include "build_page.h"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <numeric>

#include "nanocarbon/building/potential_choice.h"
#include "nanocarbon/core/version.h"
#include "nanocarbon/mesh/nearest_point.h"
#include "nanocarbon/page/structure_page.h"

namespace nanocarbon::cli {
namespace {

std::vector<double> distances_of(const building::BuildResult& result) {
  const std::vector<mesh::SurfacePoint> nearest =
      mesh::NearestPoint(result.surface.mesh).nearest(std::span<const Vec3>(result.molecule.positions));
  std::vector<double> distances(nearest.size());
  for (std::size_t a = 0; a < nearest.size(); ++a) distances[a] = nearest[a].distance;
  return distances;
}

}  // namespace

page::PageContents build_page(const BuildCommand& command, const building::BuildResult& result,
                              const nlohmann::ordered_json& report) {
  page::PageContents contents;
  contents.title = std::filesystem::path(command.mesh).stem().string();
  contents.command = fmt::format("{} (nanocarbon {})", command.command_line, version);
  contents.mesh = result.surface.mesh;
  if (result.rest) {
    contents.verdict = result.rest->intact ? "holds" : "does not hold";
    contents.mood = result.rest->intact ? page::Mood::good : page::Mood::bad;
    contents.facts.emplace_back(
        "verdict", result.rest->intact ? "the potential binds exactly the atoms that the molecule binds"
                                       : "the potential binds other atoms than the molecule does");
  }
  const auto potential = building::make_potential(command.build.potential);
  analysis::AnalyseOptions options;
  options.components.threads = command.common.threads;
  options.potential = potential.get();
  std::vector<std::int64_t> ids(result.molecule.size());
  std::iota(ids.begin(), ids.end(), 1);
  const analysis::Analysis analysis = analysis::analyse(result.molecule, ids, options);
  const std::vector<double> distances = distances_of(result);
  contents.frames.push_back(page::structure_frame(result.molecule, analysis, {}, "", distances));
  page::add_analysis(contents, result.molecule, ids, analysis, distances);
  if (report.contains("annealing"))
    contents.facts.emplace_back(
        "above graphene", fmt::format("{:.1f} meV an atom (before annealing {:.1f})",
                                      1e3 * report["annealing"]["above_graphene"].get<double>(),
                                      1e3 * report["annealing"]["above_graphene_unannealed"].get<double>()));
  contents.facts.emplace_back("formula", report["molecule"]["formula"].get<std::string>());
  if (report.contains("boundary")) {
    const auto& boundary = report["boundary"];
    contents.facts.emplace_back(
        "boundary",
        fmt::format("{}, {:.0f} Å: {:.0f}% zigzag, {:.0f}% armchair, {:.0f}% other",
                    boundary["kind"].get<std::string>(), boundary["length"].get<double>(),
                    100 * boundary["zigzag"].get<double>(), 100 * boundary["armchair"].get<double>(),
                    100 * boundary["other"].get<double>()));
    if (boundary.contains("energy"))
      contents.facts.emplace_back("energy of the boundary",
                                  fmt::format("{:.3f} eV/Å above graphene and benzene's C-H",
                                              boundary["energy_per_length"].get<double>()));
  }
  const auto& distance = report["distance"]["atoms_to_surface"];
  contents.facts.emplace_back("distance to surface",
                              fmt::format("mean {:.2f} Å, largest {:.2f} Å", distance["mean"].get<double>(),
                                          distance["max"].get<double>()));
  contents.facts.emplace_back("scale",
                              fmt::format("{:.4g} Å for each unit of the mesh", result.surface.scale));
  return contents;
}

}  // namespace nanocarbon::cli
