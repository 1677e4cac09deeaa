// SPDX-License-Identifier: GPL-2.0-or-later
// Prints a table of what crystallise() makes of mesh files:
//   remeshing_quality FACES draft|good|best [--features | --seed N] mesh-file...
// Tab-separated, one row a mesh; lengths of bonds over their mean, distances in mean edges. With --features,
// what check_features() finds instead.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "nanocarbon/mesh/formats/load_surface.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/remeshing/crystal/crystallise.h"
#include "nanocarbon/remeshing/crystal/triangulation_quality.h"
#include "nanocarbon/remeshing/features/atoms_for_features.h"

namespace nanocarbon {
namespace {

constexpr double area_per_atom = 2.6195;  // square Angstrom

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

bool same_topology(const TriangleMesh& a, const TriangleMesh& b) {
  const mesh::MeshTopology one = mesh::mesh_topology(a), two = mesh::mesh_topology(b);
  return one.components == two.components && one.boundary_loops == two.boundary_loops &&
         one.euler_characteristic == two.euler_characteristic && one.genus == two.genus && two.manifold();
}

void print_quality(const std::string& name, const TriangleMesh& surface,
                   const crystal::CrystalOptions& options) {
  const double start = cpu_seconds();
  const crystal::CrystalResult result = crystal::crystallise(surface, options);
  const double seconds = cpu_seconds() - start;
  const crystal::TriangulationQuality q = crystal::measure_triangulation(result.mesh, surface);
  const auto vertices = static_cast<double>(q.vertices);
  fmt::print(
      "{}\t{}\t{}\t{:.4f}\t{}\t{:.1f}\t{}\t{:.4f}\t{:.2f}\t{:.2f}\t{}\t{}\t{:.4f}\t{:.2f}\t{}\t{:.2f}\n",
      name, q.faces, result.levels, q.edge_cv, q.bad, 100.0 * static_cast<double>(q.defects) / vertices,
      q.charge, q.bond_cv, q.bond_min, q.bond_max, result.unsound, q.folds, q.distance_mean, q.distance_max,
      same_topology(surface, result.mesh) ? "same" : "CHANGED", seconds);
}

void print_features(const std::string& name, TriangleMesh surface, std::size_t atoms) {
  const double scale = std::sqrt(area_per_atom * static_cast<double>(atoms) / mesh::area(surface));
  for (Vec3& p : surface.points) p *= scale;
  const double start = cpu_seconds();
  const features::FeatureReport report = features::check_features(surface);
  fmt::print("{}\t{}\t{}\t{:.2f}", name, report.problems.size(),
             features::atoms_for_features(surface, static_cast<double>(atoms), report).atoms.value_or(0),
             cpu_seconds() - start);
  for (std::size_t k = 0; k < std::min<std::size_t>(report.problems.size(), 3); ++k) {
    const features::FeatureProblem& p = report.problems[k];
    fmt::print("\t{} of {:.2f} (at least {:.2f}), area {:.0f}, at {:.1f} {:.1f} {:.1f}",
               features::name(p.kind), p.size, p.needed, p.area, p.where.x(), p.where.y(), p.where.z());
  }
  fmt::print("\n");
}

}  // namespace
}  // namespace nanocarbon

int main(int argc, char** argv) {
  using namespace nanocarbon;
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() < 3) {
    fmt::print(stderr,
               "usage: remeshing_quality FACES draft|good|best [--features | --seed N] mesh-file...\n");
    return 2;
  }
  crystal::CrystalOptions options;
  options.faces = std::stoul(arguments[0]);
  options.quality = arguments[1] == "draft"  ? Quality::draft
                    : arguments[1] == "best" ? Quality::best
                                             : Quality::good;
  const bool features = arguments[2] == "--features", seeded = arguments[2] == "--seed";
  if (seeded && arguments.size() > 3) options.seed = std::stoull(arguments[3]);
  if (features)
    fmt::print("mesh\tproblems\tsmallest\tCPU s\tworst\n");
  else
    fmt::print(
        "mesh\tfaces\tlevels\tedge cv\tbad\tdefects %\tcharge\tbond cv\tbond min\tbond max\tunsound\tfolds\t"
        "distance\tmax\ttopology\tCPU s\n");
  for (std::size_t k = features ? 3 : seeded ? 4 : 2; k < arguments.size(); ++k) {
    const std::filesystem::path file = arguments[k];
    try {
      const mesh::LoadedSurface surface = mesh::load_surface(file);
      if (features)
        print_features(file.filename().string(), surface.mesh, options.faces);
      else
        print_quality(file.filename().string(), surface.mesh, options);
    } catch (const std::exception& error) {
      fmt::print("{}\t{}\n", file.filename().string(), error.what());
    }
    std::fflush(stdout);
  }
  return 0;
}
