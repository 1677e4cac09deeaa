// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/thesis/stellar_pass.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "nanocarbon/remeshing/thesis/edge_lengths.h"
#include "nanocarbon/remeshing/thesis/edge_position.h"

namespace nanocarbon::thesis {
namespace {

//! The vertices that will be next to the vertex a collapse leaves, or a split makes.
class FutureNeighbours {
 public:
  explicit FutureNeighbours(const Triangulation& mesh) : mesh_(mesh) {}

  std::span<const Vec3> after_collapse(VertexHandle a, VertexHandle b) {
    points_.clear();
    vertices_.clear();
    for (const auto& [centre, other] : {std::pair(a, b), std::pair(b, a)})
      for (const VertexHandle v : mesh_.vv_range(centre))
        if (v != other && std::find(vertices_.begin(), vertices_.end(), v) == vertices_.end()) {
          vertices_.push_back(v);
          points_.push_back(mesh_.point(v));
        }
    return points_;
  }

  std::span<const Vec3> after_split(EdgeHandle edge) {
    points_.clear();
    for (const int side : {0, 1}) {
      const HalfedgeHandle h = mesh_.halfedge_handle(edge, side);
      points_.push_back(mesh_.point(mesh_.to_vertex_handle(h)));
      if (!mesh_.is_boundary(h))
        points_.push_back(mesh_.point(mesh_.to_vertex_handle(mesh_.next_halfedge_handle(h))));
    }
    return points_;
  }

 private:
  const Triangulation& mesh_;
  std::vector<VertexHandle> vertices_;
  std::vector<Vec3> points_;
};

}  // namespace

std::vector<EdgeHandle> stellar_priority_list(const Triangulation& mesh, const LengthInterval& interval,
                                              double mean_length) {
  struct Candidate {
    double deviation;
    EdgeHandle edge;
  };
  std::vector<Candidate> candidates;
  for (const EdgeHandle e : mesh.edges())
    if (const double length = edge_length(mesh, e); !interval.contains(length))
      candidates.push_back({std::abs(length - mean_length), e});
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& x, const Candidate& y) {
    return x.deviation != y.deviation ? x.deviation > y.deviation : x.edge < y.edge;
  });
  std::vector<EdgeHandle> list;
  list.reserve(candidates.size());
  for (const Candidate& c : candidates) list.push_back(c.edge);
  return list;
}

StellarTotals stellar_pass(Triangulation& mesh, const StellarOptions& options) {
  const std::vector<EdgeHandle> list = stellar_priority_list(mesh, options.interval, mean_edge_length(mesh));
  StellarTotals totals;
  totals.candidates = list.size();
  // A split adds one vertex, so the marks are given room for as many as there are candidates.
  std::vector<std::uint8_t> visited(mesh.n_vertices() + list.size(), 0);
  const auto mark = [&](VertexHandle v) -> std::uint8_t& {
    return visited[static_cast<std::size_t>(v.idx())];
  };
  FutureNeighbours future(mesh);

  for (const EdgeHandle e : list) {
    if (mesh.status(e).deleted()) continue;
    const HalfedgeHandle h = mesh.halfedge_handle(e, 0);
    const VertexHandle a = mesh.from_vertex_handle(h), b = mesh.to_vertex_handle(h);
    if (options.marks == VisitedMarks::either_end ? mark(a) || mark(b) : mark(a) && mark(b)) continue;
    const Vec3 pa = mesh.point(a), pb = mesh.point(b);
    const double length = (pb - pa).norm();
    const auto place = [&](std::span<const Vec3> neighbours) {
      if (options.position == StellarPosition::midpoint) return 0.5;
      return least_error_position(pa, pb, neighbours, options.target_length);
    };
    if (options.interval.is_short(length)) {
      if (collapse_refusal(mesh, e, options.limits) != Refusal::none) {
        ++totals.refused;
        continue;
      }
      double t = 0.0;
      if (mesh.is_boundary(a) == mesh.is_boundary(b))
        t = place(future.after_collapse(a, b));
      else
        t = mesh.is_boundary(a) ? 0.0 : 1.0;
      const StellarOutcome outcome = collapse_edge(mesh, e, pa + t * (pb - pa), options.limits);
      if (!outcome) {
        ++totals.refused;
        continue;
      }
      ++totals.collapses;
      mark(outcome.vertex) = 1;
    } else if (options.interval.is_long(length)) {
      const double t = place(future.after_split(e));
      const StellarOutcome outcome = split_edge(mesh, e, pa + t * (pb - pa));
      ++totals.splits;
      mark(a) = mark(b) = mark(outcome.vertex) = 1;
    }
  }
  compact(mesh);
  return totals;
}

}  // namespace nanocarbon::thesis
