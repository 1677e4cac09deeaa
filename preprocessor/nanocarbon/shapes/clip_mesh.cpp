// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/shapes/clip_mesh.h"

#include <algorithm>
#include <array>
#include <map>

#include "nanocarbon/core/disjoint_sets.h"
#include "nanocarbon/mesh/join_points.h"

namespace nanocarbon::shapes {
namespace {

//! Vertices with a crossing within a third of one of their edges move there and then lie on the cut.
void snap_to_cut(TriangleMesh& mesh, std::vector<double>& value) {
  const double closest = 0.34;
  const std::vector<double> before = value;
  const std::vector<Vec3> points = mesh.points;
  std::vector<double> nearest(mesh.points.size(), closest);
  for (const Triangle& t : mesh.triangles)
    for (int c = 0; c < 3; ++c) {
      const VertexIndex a = t[c], b = t[(c + 1) % 3];
      if ((before[a] < 0.0) == (before[b] < 0.0)) continue;
      const double fraction = before[a] / (before[a] - before[b]);
      const auto move = [&](VertexIndex from, VertexIndex to, double part) {
        if (part >= nearest[from]) return;
        nearest[from] = part;
        mesh.points[from] = points[from] + part * (points[to] - points[from]);
        value[from] = 0.0;
      };
      move(a, b, fraction);
      move(b, a, 1.0 - fraction);
    }
}

}  // namespace

TriangleMesh clip_mesh(const TriangleMesh& mesh, const ImplicitShape& keep) {
  TriangleMesh clipped;
  clipped.points = mesh.points;
  std::vector<double> value(mesh.points.size());
  std::transform(mesh.points.begin(), mesh.points.end(), value.begin(), keep);
  {
    TriangleMesh snapped = mesh;
    snap_to_cut(snapped, value);
    clipped.points = std::move(snapped.points);
  }

  std::map<std::pair<VertexIndex, VertexIndex>, VertexIndex> cuts;
  const auto cut = [&](VertexIndex a, VertexIndex b) {
    if (value[b] == 0.0) return b;
    const auto [entry, added] =
        cuts.try_emplace(std::minmax(a, b), static_cast<VertexIndex>(clipped.points.size()));
    if (added) {
      const double fraction = value[a] / (value[a] - value[b]);
      clipped.points.push_back(clipped.points[a] + fraction * (clipped.points[b] - clipped.points[a]));
    }
    return entry->second;
  };
  for (Triangle t : mesh.triangles) {
    const auto inside = std::count_if(t.begin(), t.end(), [&](VertexIndex v) { return value[v] < 0.0; });
    const auto outside = std::count_if(t.begin(), t.end(), [&](VertexIndex v) { return value[v] > 0.0; });
    if (inside == 0) continue;
    if (outside == 0) {
      clipped.triangles.push_back(t);
      continue;
    }
    if (inside == 1) {
      while (!(value[t[0]] < 0.0)) std::rotate(t.begin(), t.begin() + 1, t.end());
      clipped.triangles.push_back({t[0], cut(t[0], t[1]), cut(t[0], t[2])});
    } else {
      while (!(value[t[2]] > 0.0)) std::rotate(t.begin(), t.begin() + 1, t.end());
      const VertexIndex far = cut(t[1], t[2]), near = cut(t[0], t[2]);
      clipped.triangles.push_back({t[0], t[1], far});
      clipped.triangles.push_back({t[0], far, near});
    }
  }
  mesh::drop_unused_points(clipped);
  return clipped;
}

TriangleMesh largest_component(const TriangleMesh& mesh) {
  DisjointSets components(mesh.points.size());
  for (const Triangle& t : mesh.triangles)
    for (const VertexIndex v : {t[1], t[2]}) components.join(t[0], v);
  std::vector<std::size_t> count(mesh.points.size(), 0);
  for (const Triangle& t : mesh.triangles) ++count[components.find(t[0])];
  const auto largest = static_cast<VertexIndex>(std::max_element(count.begin(), count.end()) - count.begin());
  TriangleMesh component;
  component.points = mesh.points;
  for (const Triangle& t : mesh.triangles)
    if (components.find(t[0]) == largest) component.triangles.push_back(t);
  mesh::drop_unused_points(component);
  return component;
}

}  // namespace nanocarbon::shapes
