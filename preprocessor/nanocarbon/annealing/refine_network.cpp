// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/refine_network.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "nanocarbon/shapes/goldberg_coxeter.h"

namespace nanocarbon::annealing {

namespace {

SwitchingState state_of(const TriangleMesh& triangulation, const SwitchingState& coarse) {
  SwitchingState state;
  state.network = trivalent_network(triangulation);
  state.network.hydrogen = coarse.network.hydrogen;
  state.network.steric_reach = coarse.network.steric_reach;
  state.tether = coarse.tether;
  state.free_mean = coarse.free_mean;
  state.space = triangulation.space;
  state.running = coarse.running;
  for (const Triangle& t : triangulation.triangles) {
    const auto [a, b, c] = corners_of(triangulation, t);
    state.positions.push_back((a + b + c) / 3);
  }
  return state;
}

}  // namespace

SwitchingState refined_in_four(const SwitchingState& coarse, const TetherSurface& finer_surface) {
  TriangleMesh mesh = triangulation_of(coarse.network, coarse.positions, coarse.space);
  for (Vec3& p : mesh.points) p = finer_surface.nearest(2 * p);
  TriangleMesh fine;
  fine.points = mesh.points;
  fine.space = finer_surface.space();
  std::unordered_map<std::uint64_t, VertexIndex>
      midpoint_of;  // by edge; looked up only, never walked through
  const auto midpoint = [&](VertexIndex a, VertexIndex b) {
    const std::uint64_t key = (std::uint64_t{std::min(a, b)} << 32) | std::max(a, b);
    const auto [entry, added] = midpoint_of.try_emplace(key, static_cast<VertexIndex>(fine.points.size()));
    if (added)
      fine.points.push_back(
          finer_surface.nearest(0.5 * (mesh.points[a] + fine.space.beside(mesh.points[b], mesh.points[a]))));
    return entry->second;
  };
  for (const Triangle& t : mesh.triangles) {
    const VertexIndex m[3] = {midpoint(t[1], t[2]), midpoint(t[2], t[0]), midpoint(t[0], t[1])};
    fine.triangles.push_back({t[0], m[2], m[1]});
    fine.triangles.push_back({t[1], m[0], m[2]});
    fine.triangles.push_back({t[2], m[1], m[0]});
    fine.triangles.push_back({m[0], m[1], m[2]});
  }
  return state_of(fine, coarse);
}

SwitchingState refined_by(const SwitchingState& coarse, int h, int k, const TetherSurface& finer_surface) {
  TriangleMesh mesh = triangulation_of(coarse.network, coarse.positions, coarse.space);
  rescale(mesh, std::sqrt(static_cast<double>(h * h + h * k + k * k)));
  TriangleMesh fine = shapes::goldberg_coxeter(mesh, h, k);
  fine.space = finer_surface.space();
  for (Vec3& p : fine.points) p = finer_surface.nearest(p);
  return state_of(fine, coarse);
}

}  // namespace nanocarbon::annealing
