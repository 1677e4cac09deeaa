// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/crystal/valence_repair.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <vector>

#include "nanocarbon/remeshing/crystal/soundness.h"

namespace nanocarbon::crystal {
namespace {

//! Penalty of a valence. Boundary vertices are free from 3 to 6.
int penalty(const CornerTable& table, VertexIndex v) {
  const int valence = table.valence(v);
  if (table.on_boundary(v)) return valence < 3 ? 30 : valence > 6 ? 8 * (valence - 6) : 0;
  const int charge = std::abs(valence - 6);
  return charge <= 1 ? charge : 8 * (charge - 1) * charge / 2;
}

std::array<VertexIndex, 4> corners_of(const CornerTable& table, HalfEdgeIndex h) {
  return {table.origin(h), table.target(h), table.apex(h), table.apex(table.twin(h))};
}

int penalty_of(const CornerTable& table, const std::array<VertexIndex, 4>& corners) {
  int sum = 0;
  for (const VertexIndex v : corners) sum += penalty(table, v);
  return sum;
}

HalfEdgeIndex half_edge_between(const CornerTable& table, VertexIndex a, VertexIndex b) {
  HalfEdgeIndex found = no_half_edge;
  table.for_outgoing(a, [&](HalfEdgeIndex h) {
    if (table.target(h) == b) found = h;
  });
  return found;
}

//! Edges at a vertex and around it.
std::vector<HalfEdgeIndex> edges_near(const CornerTable& table, VertexIndex v) {
  std::vector<HalfEdgeIndex> edges;
  table.for_outgoing(v, [&](HalfEdgeIndex h) {
    edges.push_back(h);
    edges.push_back(CornerTable::next(h));
  });
  return edges;
}

//! Tries flips from the list, then around what the first one changed. Keeps the first sequence that gains.
bool improve(Tiling& tiling, const std::vector<HalfEdgeIndex>& candidates, int owed, int depth,
             std::size_t& flips) {
  CornerTable& table = tiling.table;
  for (const HalfEdgeIndex h : candidates) {
    if (!flip_is_sound(tiling, h)) continue;
    const auto corners = corners_of(table, h);
    const int before = penalty_of(table, corners);
    table.flip(h);
    const int change = penalty_of(table, corners) - before;
    ++flips;
    if (owed + change < 0) return true;
    if (depth > 1) {
      std::vector<HalfEdgeIndex> near;
      for (const VertexIndex v : corners)
        if (penalty(table, v) > 1)
          for (const HalfEdgeIndex k : edges_near(table, v)) near.push_back(k);
      if (improve(tiling, near, owed + change, depth - 1, flips)) return true;
    }
    // Flips and their undoing exchange the names of half-edges: the edge is found by its ends.
    table.flip(half_edge_between(table, corners[2], corners[3]));
    --flips;
  }
  return false;
}

}  // namespace

ValenceRepair repair_valences(Tiling& tiling) {
  constexpr int deepest = 3;
  constexpr int rounds = 6;
  ValenceRepair result;
  for (int round = 0; round < rounds; ++round) {
    result.left = 0;
    bool changed = false;
    for (VertexIndex v = 0; v < tiling.table.vertices(); ++v) {
      if (!tiling.table.vertex_alive(v) || tiling.is_held(v) || penalty(tiling.table, v) <= 1) continue;
      for (int depth = 1; depth <= deepest && penalty(tiling.table, v) > 1; ++depth)
        changed = improve(tiling, edges_near(tiling.table, v), 0, depth, result.flips) || changed;
      if (!tiling.table.on_boundary(v) && penalty(tiling.table, v) > 1) ++result.left;
    }
    if (!changed) break;
  }
  return result;
}

}  // namespace nanocarbon::crystal
