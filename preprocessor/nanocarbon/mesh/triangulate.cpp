// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/triangulate.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "nanocarbon/mesh/cut_ears.h"
#include "nanocarbon/mesh/drop_faces.h"
#include "nanocarbon/mesh/edge_table.h"
#include "nanocarbon/mesh/join_points.h"

namespace nanocarbon::mesh {
namespace {

bool has_side(std::span<const VertexIndex> face, VertexIndex a, VertexIndex b) {
  for (std::size_t i = 0; i < face.size(); ++i) {
    const VertexIndex from = face[i];
    const VertexIndex to = face[(i + 1) % face.size()];
    if ((from == a && to == b) || (from == b && to == a)) return true;
  }
  return false;
}

// Faces with a diagonal that is an edge elsewhere, so that three or more triangles would meet there.
std::vector<bool> faces_with_bad_diagonals(const PolygonSoup& soup, const TriangleMesh& mesh) {
  std::vector<FaceIndex> face_of;  // each triangle's
  face_of.reserve(mesh.triangles.size());
  for (FaceIndex face = 0; face < soup.faces(); ++face)
    face_of.insert(face_of.end(), soup.face(face).size() - 2, face);
  std::vector<bool> bad(soup.faces(), false);
  const EdgeTable edges = edge_table(soup_of(mesh));
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges.uses_of(e).size() <= 2) continue;
    for (const EdgeUse& use : edges.uses_of(e))
      if (!has_side(soup.face(face_of[use.face]), edges.low[e], edges.high[e])) bad[face_of[use.face]] = true;
  }
  return bad;
}

void add_fan_around_centre(std::span<const VertexIndex> face, TriangleMesh& mesh) {
  Vec3 centre = Vec3::Zero();
  for (const VertexIndex v : face) centre += mesh.points[v] / static_cast<double>(face.size());
  const auto middle = static_cast<VertexIndex>(mesh.points.size());
  mesh.points.push_back(centre);
  for (std::size_t i = 0; i < face.size(); ++i)
    mesh.triangles.push_back({face[i], face[(i + 1) % face.size()], middle});
}

Triangulated cut_all(const PolygonSoup& soup) {
  Triangulated result;
  result.mesh.points = soup.points;
  result.mesh.triangles.reserve(soup.corners.size() - 2 * soup.faces());
  for (std::size_t face = 0; face < soup.faces(); ++face) {
    if (soup.face(face).size() > 3) ++result.polygons;
    cut_ears(soup.points, soup.face(face), result.mesh.triangles);
  }
  if (result.polygons == 0) return result;

  const std::vector<bool> bad = faces_with_bad_diagonals(soup, result.mesh);
  if (std::find(bad.begin(), bad.end(), true) == bad.end()) return result;
  const std::vector<Triangle> cut = std::move(result.mesh.triangles);
  result.mesh.triangles.clear();
  auto next = cut.begin();
  for (std::size_t face = 0; face < soup.faces(); ++face) {
    const auto end = next + static_cast<std::ptrdiff_t>(soup.face(face).size() - 2);
    if (bad[face]) {
      add_fan_around_centre(soup.face(face), result.mesh);
      ++result.centres_added;
    } else {
      result.mesh.triangles.insert(result.mesh.triangles.end(), next, end);
    }
    next = end;
  }
  return result;
}

}  // namespace

bool can_be_triangulated(const PolygonSoup& soup) {
  for (std::size_t face = 0; face < soup.faces(); ++face)
    if (soup.face(face).size() > most_corners) return false;
  return soup.faces() > 0;
}

Triangulated triangulate(const PolygonSoup& soup) {
  Triangulated result = cut_all(soup);
  TriangleMesh& mesh = result.mesh;
  if (std::erase_if(mesh.triangles, [](const Triangle& t) { return repeats_a_vertex(t); }) == 0)
    return result;
  PolygonSoup left = soup_of(mesh);
  drop_unused_points(left);
  for (std::size_t corner = 0; corner < left.corners.size(); ++corner)
    mesh.triangles[corner / 3][corner % 3] = left.corners[corner];
  mesh.points = std::move(left.points);
  return result;
}

}  // namespace nanocarbon::mesh
