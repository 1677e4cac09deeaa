// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/thesis/local_optimiser.h"

#include <algorithm>
#include <array>

namespace nanocarbon::thesis {
namespace {

double length(const VertexStars& stars, VertexIndex a, VertexIndex b) {
  return (stars.points[a] - stars.points[b]).norm();
}

//! Neighbours of each vertex at the far end of an edge outside the interval, in compressed rows.
struct OutsideEdges {
  std::vector<std::uint32_t> offsets;
  std::vector<VertexIndex> others;
};

OutsideEdges outside_edges(const VertexStars& stars, const LengthInterval& interval) {
  OutsideEdges outside;
  outside.offsets.reserve(stars.vertices() + 1);
  outside.offsets.push_back(0);
  for (VertexIndex v = 0; v < stars.vertices(); ++v) {
    for (const VertexIndex w : stars.of(v))
      if (!interval.contains(length(stars, v, w))) outside.others.push_back(w);
    outside.offsets.push_back(static_cast<std::uint32_t>(outside.others.size()));
  }
  return outside;
}

}  // namespace

std::vector<StarEdge> local_priority_list(const VertexStars& stars, const LengthInterval& interval,
                                          unsigned rings) {
  struct Candidate {
    std::size_t around;
    StarEdge edge;
  };
  const OutsideEdges outside = outside_edges(stars, interval);
  std::vector<Candidate> candidates;
  RingSearch search(stars);
  for (VertexIndex a = 0; a < stars.vertices(); ++a)
    for (std::uint32_t k = outside.offsets[a]; k < outside.offsets[a + 1]; ++k) {
      const VertexIndex b = outside.others[k];
      if (b < a) continue;
      std::size_t around = 0;
      const std::array<VertexIndex, 2> ends = {a, b};
      for (const VertexIndex v : search.search(ends, rings))
        for (std::uint32_t i = outside.offsets[v]; i < outside.offsets[v + 1]; ++i) {
          const VertexIndex w = outside.others[i];
          around += w > v || search.place(w) < 0;
        }
      candidates.push_back({around, {a, b}});
    }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& x, const Candidate& y) { return x.around > y.around; });
  std::vector<StarEdge> list;
  list.reserve(candidates.size());
  for (const Candidate& c : candidates) list.push_back(c.edge);
  return list;
}

void region_energy(const VertexStars& stars, RingSearch& search, StarEdge edge, const LocalOptions& options,
                   EdgeEnergy& energy, std::vector<VertexIndex>& moving_vertices) {
  const std::array<VertexIndex, 2> ends = {edge.a, edge.b};
  // The ring beyond the star holds the fixed ends of its outermost edges.
  const auto found = search.search(ends, options.rings + 1);
  const std::size_t in_star = search.ring_begin(options.rings + 1);
  energy.m = options.interval.mean();
  energy.terms.clear();
  energy.points.clear();
  energy.normals.clear();
  moving_vertices.clear();

  static thread_local std::vector<std::uint32_t> point_of;
  point_of.resize(found.size());
  const auto number = [&](bool moves) {
    for (std::size_t k = 0; k < found.size(); ++k) {
      const VertexIndex v = found[k];
      if ((k < in_star && !stars.on_boundary[v]) != moves) continue;
      point_of[k] = static_cast<std::uint32_t>(energy.points.size());
      energy.points.push_back(stars.points[v]);
      if (!moves) continue;
      moving_vertices.push_back(v);
      if (options.tangent_plane) energy.normals.push_back(vertex_normal(stars, v));
    }
  };
  number(true);
  energy.moving = energy.points.size();
  number(false);

  for (std::size_t k = 0; k < in_star; ++k)
    for (const VertexIndex w : stars.of(found[k])) {
      const auto other = static_cast<std::size_t>(search.place(w));
      const bool other_in_star = other < in_star;
      if (other_in_star && other < k) continue;
      std::uint32_t a = point_of[k], b = point_of[other];
      if (a > b) std::swap(a, b);
      if (a >= energy.moving) continue;  // both ends fixed: a constant
      energy.terms.push_back({a, b, other_in_star ? 2.0 : 1.0});
    }
}

LocalTotals optimise_locally(VertexStars& stars, const LocalOptions& options) {
  LocalTotals totals;
  const std::vector<StarEdge> list = local_priority_list(stars, options.interval, options.rings);
  totals.candidates = list.size();
  RingSearch search(stars);
  EdgeEnergy energy;
  MinimiserWorkspace workspace;
  std::vector<VertexIndex> moving;
  for (const StarEdge edge : list) {
    if (options.interval.contains(length(stars, edge.a, edge.b))) continue;
    region_energy(stars, search, edge, options, energy, moving);
    totals.iterations += minimise(energy, options.minimiser, workspace).iterations;
    ++totals.minimised;
    for (std::size_t k = 0; k < moving.size(); ++k) stars.points[moving[k]] = energy.points[k];
  }
  return totals;
}

}  // namespace nanocarbon::thesis
