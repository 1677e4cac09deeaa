// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/thesis/edge_lengths.h"

#include <algorithm>
#include <numeric>

namespace nanocarbon::thesis {

EdgeCounts count_edges(const Triangulation& mesh, const LengthInterval& interval) {
  EdgeCounts counts;
  for (const EdgeHandle e : mesh.edges()) {
    const double length = edge_length(mesh, e);
    ++counts.edges;
    counts.too_short += interval.is_short(length);
    counts.too_long += interval.is_long(length);
  }
  return counts;
}

double mean_edge_length(const Triangulation& mesh) {
  double sum = 0.0;
  std::size_t edges = 0;
  for (const EdgeHandle e : mesh.edges()) {
    sum += edge_length(mesh, e);
    ++edges;
  }
  return edges ? sum / static_cast<double>(edges) : 0.0;
}

std::size_t ValenceCounts::outside_5_to_7() const {
  return std::accumulate(inner.begin(), inner.end(), std::size_t{0}) - inner[5] - inner[6] - inner[7];
}

ValenceCounts count_valences(const Triangulation& mesh) {
  ValenceCounts counts;
  for (const VertexHandle v : mesh.vertices()) {
    if (mesh.is_isolated(v)) continue;
    if (mesh.is_boundary(v))
      ++counts.boundary;
    else
      ++counts.inner[std::min<std::size_t>(mesh.valence(v), counts.inner.size() - 1)];
  }
  return counts;
}

}  // namespace nanocarbon::thesis
