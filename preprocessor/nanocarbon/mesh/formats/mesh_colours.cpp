// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/formats/mesh_colours.h"

#include "nanocarbon/mesh/edge_table.h"

namespace nanocarbon::mesh {
namespace {

constexpr Rgb green = {46, 160, 67};
constexpr Rgb blue = {31, 97, 196};
constexpr Rgb red = {207, 34, 46};
constexpr Rgb grey = {140, 140, 140};

template <typename Number>
Rgb three_way(Number value, Number low, Number high) {
  return value < low ? green : value > high ? red : blue;
}

}  // namespace

MeshColours colours_by_quality(const TriangleMesh& mesh, double shortest, double longest) {
  const EdgeTable edges = edge_table(soup_of(mesh));
  MeshColours colours;
  std::vector<int> valence(mesh.points.size(), 0);
  std::vector<bool> on_boundary(mesh.points.size(), false);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const VertexIndex a = edges.low[e], b = edges.high[e];
    const double length = mesh.space.displacement(mesh.points[b], mesh.points[a]).norm();
    colours.edges.push_back({a, b, three_way(length, shortest, longest)});
    for (const VertexIndex v : {a, b}) {
      ++valence[v];
      if (edges.uses_of(e).size() == 1) on_boundary[v] = true;
    }
  }
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    colours.vertices.push_back(on_boundary[v] ? grey : three_way(valence[v], 6, 6));
  return colours;
}

}  // namespace nanocarbon::mesh
