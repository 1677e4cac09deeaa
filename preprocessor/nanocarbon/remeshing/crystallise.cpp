#include "nanocarbon/remeshing/crystallise.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/remeshing/flips.h"
#include "nanocarbon/remeshing/isotropic.h"
#include "nanocarbon/remeshing/particle_annealing.h"
#include "nanocarbon/remeshing/soundness.h"
#include "nanocarbon/remeshing/surface_guide.h"
#include "nanocarbon/remeshing/tiling.h"

namespace nanocarbon {
namespace {

// Normals are smoothed over this share of the spacing: less shows every bump, more blurs thin parts.
constexpr double normals_length = 0.4;

std::size_t annealing_steps(CrystalQuality quality) {
  switch (quality) {
    case CrystalQuality::draft:
      return 400;
    case CrystalQuality::good:
      return 20000;
    case CrystalQuality::best:
      return 80000;
  }
  return 0;
}

//! Vertices that a triangulation of this topology has for a number of faces. A border edge has no second
//! face, so that a tiling keeps about the border it has.
std::size_t vertices_for_faces(const Tiling& tiling, std::size_t faces) {
  const auto vertices = static_cast<double>(tiling.table.live_vertices());
  const auto triangles = static_cast<double>(tiling.table.live_triangles());
  return static_cast<std::size_t>(
      std::max(4.0, std::round(vertices + (static_cast<double>(faces) - triangles) / 2)));
}

}  // namespace

CrystalResult crystallise(const TriangleMesh& surface, const CrystalOptions& options) {
  const auto report = [&](std::string_view stage, double share) {
    if (options.progress) options.progress(stage, share);
  };
  CrystalResult result;
  result.spacing = std::sqrt(4 * area(surface) / (std::sqrt(3.0) * static_cast<double>(options.faces)));
  report("remeshing", 0);
  SurfaceGuide guide(surface, result.spacing);
  guide.smooth_normals(normals_length * result.spacing);
  Tiling tiling = tiling_of(guide);
  remesh_isotropically(tiling, result.spacing, 6);
  const std::size_t wanted = vertices_for_faces(tiling, options.faces);
  if (reach_vertex_count(tiling, wanted) > wanted + wanted / 50 + 2)
    throw UserError(
        Failure::size,
        fmt::format("{} faces are too few for the shape: its topology needs about {}. Ask for more.",
                    options.faces, tiling.table.live_triangles()));
  unfold(tiling, 10);
  report("crystallising", 0.05);
  AnnealingSchedule schedule;
  schedule.steps = annealing_steps(options.quality);
  schedule.seed = options.seed;
  anneal_particles(tiling, result.spacing, schedule);
  report("evening edges", 0.9);
  for (int round = 0; round < 3; ++round) {
    flip_to_valences(tiling, 10);
    settle_on_surface(tiling);
    even_edges(tiling, mean_edge_length(tiling), 120);
  }
  flip_to_valences(tiling, 10);
  settle_on_surface(tiling);
  for (VertexIndex v = 0; v < tiling.table.vertices(); ++v) {
    if (soundness_around(tiling, v) < 0) ++result.unsound;
    const int charge = tiling.table.on_border(v) ? 0 : std::abs(tiling.table.valence(v) - 6);
    result.defects += charge > 0 ? 1 : 0;
    result.bad_valences += charge > 1 ? 1 : 0;
  }
  result.mesh = to_mesh(tiling);
  report("done", 1);
  return result;
}

}  // namespace nanocarbon
