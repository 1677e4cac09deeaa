#include "nanocarbon/building/build_molecule.h"

#include <fmt/format.h>

#include <chrono>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/molecule/dual.h"

namespace nanocarbon {
namespace {

class Stopwatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

void require_same_topology(const MeshTopology& surface, const MeshTopology& triangulation) {
  const auto tell = [](const MeshTopology& t) {
    return fmt::format("{} pieces, Euler characteristic {}, genus {}, {} boundary loops", t.pieces,
                       t.euler_characteristic, t.genus, t.boundary_loops);
  };
  if (surface.pieces != triangulation.pieces ||
      surface.euler_characteristic != triangulation.euler_characteristic ||
      surface.boundary_loops != triangulation.boundary_loops ||
      surface.orientable != triangulation.orientable)
    throw UserError(Failure::failed,
                    fmt::format("remeshing changed the topology, from {} to {}; please report this",
                                tell(surface), tell(triangulation)));
}

}  // namespace

BuildResult build_molecule(const TriangleMesh& surface, const BuildOptions& options) {
  BuildResult result;
  Stopwatch whole, stage;
  const ThesisOptions& thesis = options.thesis;
  result.surface = sized_surface(surface, options.size, 0.5 * (thesis.min_bond + thesis.max_bond));
  stage.lap();

  ThesisOptions with_progress = thesis;
  // Sizes that are a number of atoms leave the scale to the remeshing, which knows what number comes out.
  if (std::holds_alternative<AtomCount>(options.size) || std::holds_alternative<AtomPerTriangle>(options.size))
    with_progress.atoms = result.surface.atoms;
  if (options.progress)
    with_progress.progress = [&](const ThesisProgress& p) {
      options.progress("remeshing", static_cast<double>(p.iteration) / p.max_iterations);
    };
  result.thesis = remesh_by_thesis(result.surface.mesh, with_progress);
  result.triangulation = std::move(result.thesis->mesh);
  result.thesis->mesh = {};
  result.surface.scale *= result.thesis->scale;
  for (Vec3& point : result.surface.mesh.points) point *= result.thesis->scale;
  result.seconds.remeshing = stage.lap();

  require_same_topology(mesh_topology(result.surface.mesh), mesh_topology(result.triangulation));
  result.molecule = dual(result.triangulation);
  result.seconds.dual = stage.lap();
  result.seconds.total = whole.lap();
  return result;
}

}  // namespace nanocarbon
