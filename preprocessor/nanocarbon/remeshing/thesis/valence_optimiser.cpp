// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/thesis/valence_optimiser.h"

#include <cstdlib>
#include <vector>

namespace nanocarbon::thesis {
namespace {

//! The valence less the ideal one of every vertex, kept up to date with the flips.
std::vector<int> valence_deviations(const Triangulation& mesh) {
  std::vector<int> deviations(mesh.n_vertices(), 0);
  for (const EdgeHandle e : mesh.edges())
    for (const int side : {0, 1})
      ++deviations[static_cast<std::size_t>(mesh.to_vertex_handle(mesh.halfedge_handle(e, side)).idx())];
  for (const VertexHandle v : mesh.vertices())
    deviations[static_cast<std::size_t>(v.idx())] -= mesh.is_boundary(v) ? 4 : 6;
  return deviations;
}

}  // namespace

ValenceTotals optimise_valences(Triangulation& mesh, const ValenceOptions& options) {
  std::vector<int> deviations = valence_deviations(mesh);
  const auto deviation = [&](VertexHandle v) -> int& {
    return deviations[static_cast<std::size_t>(v.idx())];
  };
  const auto error = [&](int d) { return options.error == ValenceError::linear ? std::abs(d) : d * d; };
  ValenceTotals totals;
  for (bool improved = true; improved;) {
    improved = false;
    ++totals.passes;
    for (const EdgeHandle e : mesh.edges()) {
      if (mesh.is_boundary(e)) continue;
      const HalfedgeHandle h = mesh.halfedge_handle(e, 0), o = mesh.halfedge_handle(e, 1);
      int& d1 = deviation(mesh.from_vertex_handle(h));
      int& d2 = deviation(mesh.to_vertex_handle(h));
      int& d3 = deviation(mesh.to_vertex_handle(mesh.next_halfedge_handle(h)));
      int& d4 = deviation(mesh.to_vertex_handle(mesh.next_halfedge_handle(o)));
      const int before = error(d1) + error(d2) + error(d3) + error(d4);
      const int after = error(d1 - 1) + error(d2 - 1) + error(d3 + 1) + error(d4 + 1);
      if (after >= before || !flip_edge(mesh, e, options.limits)) continue;
      --d1, --d2, ++d3, ++d4;
      ++totals.flips;
      improved = true;
    }
    if (!options.repeat) break;
  }
  return totals;
}

crystal::ValenceRepair repair_valences(Triangulation& mesh) {
  TriangleMesh plain = to_triangle_mesh(mesh);
  const crystal::SurfaceGuide guide(plain, std::numeric_limits<double>::infinity());
  crystal::Tiling tiling = crystal::tiling_of(guide);
  const crystal::ValenceRepair repair = repair_valences(tiling);
  plain.triangles = tiling.table.triangles();
  mesh = to_triangulation(plain);
  return repair;
}

}  // namespace nanocarbon::thesis
