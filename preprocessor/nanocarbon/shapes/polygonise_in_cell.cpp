// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/shapes/polygonise_in_cell.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "nanocarbon/core/error.h"
#include "nanocarbon/shapes/even_out.h"

namespace nanocarbon::shapes {
namespace {

using Place = std::array<std::int64_t, 3>;

// Edges of the tetrahedra are 1 to 1.7 steps of the grid long; those of the surface turn out shorter.
constexpr double steps_per_edge = 1.4;
// With fewer steps along a periodic edge two vertices could meet through two images.
constexpr std::int64_t least_steps = 9;

//! A grid of nodes in a cell; those of opposite faces are the same in periodic directions.
class Grid {
 public:
  Grid(const Cell& cell, double edge) : cell_(cell) {
    for (int d = 0; d < 3; ++d) {
      const double steps = std::ceil(cell.vectors.col(d).norm() / (steps_per_edge * edge));
      steps_[d] = std::max(least_steps, static_cast<std::int64_t>(std::min(steps, 1e6)));
      nodes_[d] = steps_[d] + (periodic(d) ? 0 : 1);
    }
  }
  double size() const {
    return static_cast<double>(nodes_[0]) * static_cast<double>(nodes_[1]) * static_cast<double>(nodes_[2]);
  }
  const Place& steps() const { return steps_; }
  std::int64_t node(Place p) const {
    for (int d = 0; d < 3; ++d)
      if (p[d] >= nodes_[d]) p[d] %= nodes_[d];
    return p[0] + nodes_[0] * (p[1] + nodes_[1] * p[2]);
  }
  Vec3 point(const Place& p) const {
    Vec3 fractional;
    for (int d = 0; d < 3; ++d) fractional[d] = static_cast<double>(p[d]) / static_cast<double>(steps_[d]);
    return cell_.origin + cell_.vectors * fractional;
  }
  std::vector<double> sample(const ImplicitShape& shape) const {
    std::vector<double> values(static_cast<std::size_t>(size()));
    for (std::int64_t k = 0; k < nodes_[2]; ++k)
      for (std::int64_t j = 0; j < nodes_[1]; ++j)
        for (std::int64_t i = 0; i < nodes_[0]; ++i) values[node({i, j, k})] = shape(point({i, j, k}));
    return values;
  }

 private:
  bool periodic(int d) const { return cell_.periodic[static_cast<std::size_t>(d)]; }

  const Cell& cell_;
  Place steps_{}, nodes_{};
};

class Marcher {
 public:
  Marcher(const Grid& grid, const std::vector<double>& values) : grid_(grid), values_(values) {}

  TriangleMesh run() {
    constexpr int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    const Place& steps = grid_.steps();
    for (std::int64_t k = 0; k < steps[2]; ++k)
      for (std::int64_t j = 0; j < steps[1]; ++j)
        for (std::int64_t i = 0; i < steps[0]; ++i) {
          if (!is_met({i, j, k})) continue;
          for (int order = 0; order < 6; ++order) {
            std::array<Corner, 4> corners;
            corners[0] = corner({i, j, k});
            Place at = {i, j, k};
            for (int c = 0; c < 3; ++c) {
              ++at[orders[order][c]];
              corners[static_cast<std::size_t>(c) + 1] = corner(at);
            }
            add(corners, order < 3);
          }
        }
    return std::move(mesh_);
  }

 private:
  struct Corner {
    Place place;
    bool inside;
  };
  Corner corner(const Place& place) const { return {place, values_[grid_.node(place)] < 0.0}; }

  // Whether the surface passes between the eight nodes from one on.
  bool is_met(const Place& first) const {
    int inside = 0;
    for (int c = 0; c < 8; ++c)
      inside += values_[grid_.node({first[0] + (c & 1), first[1] + (c >> 1 & 1), first[2] + (c >> 2)})] < 0.0;
    return inside % 8 != 0;
  }

  void add(std::array<Corner, 4>& v, bool positive) {
    // Those inside first; an odd permutation turns the tetrahedron.
    for (std::size_t end = 3; end > 0; --end)
      for (std::size_t i = 0; i < end; ++i)
        if (!v[i].inside && v[i + 1].inside) std::swap(v[i], v[i + 1]), positive = !positive;
    const auto inside = std::count_if(v.begin(), v.end(), [](const Corner& c) { return c.inside; });
    const auto emit = [&](VertexIndex a, VertexIndex b, VertexIndex c) {
      mesh_.triangles.push_back(positive ? Triangle{a, b, c} : Triangle{a, c, b});
    };
    if (inside == 1) emit(vertex(v[0], v[1]), vertex(v[0], v[2]), vertex(v[0], v[3]));
    if (inside == 3) emit(vertex(v[0], v[3]), vertex(v[1], v[3]), vertex(v[2], v[3]));
    if (inside != 2) return;
    const VertexIndex a = vertex(v[1], v[2]), b = vertex(v[0], v[2]), c = vertex(v[0], v[3]),
                      d = vertex(v[1], v[3]);
    emit(a, b, c);
    emit(a, c, d);
  }

  // On the edge between two nodes, named by the lower one and the direction to the other.
  VertexIndex vertex(const Corner& one, const Corner& other) {
    const bool swap = other.place < one.place;
    const Place &low = swap ? other.place : one.place, &high = swap ? one.place : other.place;
    std::int64_t direction = 0;
    for (int d = 0; d < 3; ++d) direction += (high[d] - low[d]) << d;
    const auto [entry, added] =
        index_.try_emplace(8 * grid_.node(low) + direction, static_cast<VertexIndex>(mesh_.points.size()));
    if (added) {
      const double a = values_[grid_.node(low)], b = values_[grid_.node(high)];
      const Vec3 from = grid_.point(low);
      mesh_.points.push_back(from + a / (a - b) * (grid_.point(high) - from));
    }
    return entry->second;
  }

  const Grid& grid_;
  const std::vector<double>& values_;
  TriangleMesh mesh_;
  std::unordered_map<std::int64_t, VertexIndex> index_;  // looked up only, never walked through
};

}  // namespace

TriangleMesh marched_in_cell(const ImplicitShape& shape, const Cell& cell, double edge) {
  if (!(edge > 0.0)) throw UserError(Failure::usage, "the edge must be above zero");
  const Grid grid(cell, edge);
  if (grid.size() > 5e7)
    throw UserError(Failure::usage, "the edge is too short for a cell of this size; use a longer one");
  std::vector<double> values = grid.sample(shape);
  // A node that is on the surface counts as outside, by so little that it does not show.
  const double tiny = 1e-9 * *std::max_element(values.begin(), values.end());
  for (double& value : values)
    if (std::abs(value) < tiny) value = tiny;
  TriangleMesh mesh = Marcher(grid, values).run();
  if (mesh.triangles.empty())
    throw UserError(Failure::usage,
                    "there is no surface in the cell: the function has the same sign everywhere, or the edge "
                    "is too long to show the surface");
  mesh.space = Space(cell);
  return mesh;
}

TriangleMesh polygonise_in_cell(const ImplicitShape& shape, const Cell& cell, double edge,
                                const ImplicitSlope& slope) {
  TriangleMesh mesh = marched_in_cell(shape, cell, edge);
  constexpr int rounds = 12;
  if (slope)
    even_out(mesh, slope, edge, rounds);
  else
    even_out(mesh, shape, edge, rounds);
  return mesh;
}

}  // namespace nanocarbon::shapes
