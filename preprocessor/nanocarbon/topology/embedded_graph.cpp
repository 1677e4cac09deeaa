// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/topology/embedded_graph.h"

#include <algorithm>
#include <tuple>

namespace nanocarbon::topology {

EmbeddedGraph embedded_graph(std::span<const Vec3> positions, std::span<const Element> elements,
                             std::span<const Bond> bonds, const Cell* cell) {
  EmbeddedGraph graph;
  graph.elements.assign(elements.begin(), elements.end());
  graph.offsets.assign(positions.size() + 1, 0);
  for (const Bond& bond : bonds) ++graph.offsets[bond.first + 1], ++graph.offsets[bond.second + 1];
  for (std::size_t a = 0; a < positions.size(); ++a) graph.offsets[a + 1] += graph.offsets[a];
  graph.ends.resize(2 * bonds.size());
  graph.vectors.resize(2 * bonds.size());
  std::vector<std::uint32_t> fill(graph.offsets.begin(), graph.offsets.end() - 1);
  for (const Bond& bond : bonds) {
    Vec3 along = positions[bond.second] - positions[bond.first];
    if (cell) along += image_shift(*cell, bond.image);
    const std::uint32_t there = fill[bond.first]++, back = fill[bond.second]++;
    graph.ends[there] = bond.second;
    graph.vectors[there] = along;
    graph.ends[back] = bond.first;
    graph.vectors[back] = -along;
  }
  return graph;
}

EmbeddedGraph embedded_graph(std::span<const std::int64_t> ids, std::span<const Element> elements,
                             std::span<const BondEnd> ends) {
  constexpr std::uint32_t unknown = 0xffffffffu;
  const auto index_of = [&](std::int64_t id) {
    if (ids.empty() || id < ids.front() || id > ids.back()) return unknown;
    // IDs without gaps are the usual case.
    const auto guess = static_cast<std::uint64_t>(id - ids.front());
    if (guess < ids.size() && ids[guess] == id) return static_cast<std::uint32_t>(guess);
    const auto found = std::lower_bound(ids.begin(), ids.end(), id);
    return *found == id ? static_cast<std::uint32_t>(found - ids.begin()) : unknown;
  };
  struct Row {
    std::uint32_t atom, neighbour;
    Vec3 vector;
  };
  std::vector<Row> rows;
  rows.reserve(ends.size());
  for (const BondEnd& end : ends) {
    const Row row{index_of(end.atom), index_of(end.neighbour), end.vector};
    if (row.atom != unknown && row.neighbour != unknown) rows.push_back(row);
  }
  std::sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
    return std::tie(a.atom, a.neighbour, a.vector[0], a.vector[1], a.vector[2]) <
           std::tie(b.atom, b.neighbour, b.vector[0], b.vector[1], b.vector[2]);
  });

  EmbeddedGraph graph;
  graph.elements.assign(elements.begin(), elements.end());
  graph.ids.assign(ids.begin(), ids.end());
  graph.offsets.assign(ids.size() + 1, 0);
  for (const Row& row : rows) ++graph.offsets[row.atom + 1];
  for (std::size_t a = 0; a < ids.size(); ++a) graph.offsets[a + 1] += graph.offsets[a];
  for (const Row& row : rows) {
    graph.ends.push_back(row.neighbour);
    graph.vectors.push_back(row.vector);
  }
  return graph;
}

}  // namespace nanocarbon::topology
