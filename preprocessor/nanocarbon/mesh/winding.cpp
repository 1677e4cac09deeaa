#include "nanocarbon/mesh/winding.h"

#include <utility>
#include <vector>

#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/nesting.h"

namespace nanocarbon {
namespace {

void turn(Triangle& triangle) { std::swap(triangle[1], triangle[2]); }

}  // namespace

DisjointSets face_sides(std::size_t faces, const EdgeTable& edges) {
  DisjointSets sides(2 * faces);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto uses = edges.uses_of(e);
    if (uses.size() != 2) continue;
    const std::uint32_t turned = uses[0].forward == uses[1].forward ? 1 : 0;
    sides.unite(2 * uses[0].face, 2 * uses[1].face + turned);
    sides.unite(2 * uses[0].face + 1, 2 * uses[1].face + 1 - turned);
  }
  return sides;
}

std::size_t wind_alike(TriangleMesh& mesh, const MeshTopology& topology, const EdgeTable& edges) {
  DisjointSets sides = face_sides(mesh.triangles.size(), edges);
  const auto differs = [&](FaceIndex face) {
    return sides.find(2 * face) != sides.find(2 * topology.piece[topology.piece_of_face[face]].first_face);
  };
  std::vector<std::size_t> different(topology.pieces, 0);
  for (FaceIndex face = 0; face < mesh.triangles.size(); ++face)
    if (differs(face)) ++different[topology.piece_of_face[face]];
  std::size_t turned = 0;
  for (FaceIndex face = 0; face < mesh.triangles.size(); ++face) {
    const std::uint32_t p = topology.piece_of_face[face];
    if (!topology.piece[p].orientable) continue;
    const bool turn_the_different = different[p] <= topology.piece[p].faces / 2;
    if (differs(face) != turn_the_different) continue;
    turn(mesh.triangles[face]);
    ++turned;
  }
  return turned;
}

std::size_t turn_outside(TriangleMesh& mesh, const MeshTopology& topology) {
  std::vector<double> volume(topology.pieces, 0.0);
  for (FaceIndex face = 0; face < mesh.triangles.size(); ++face) {
    const std::uint32_t p = topology.piece_of_face[face];
    const Vec3 origin = mesh.points[mesh.triangles[topology.piece[p].first_face][0]];
    const auto& [a, b, c] = mesh.triangles[face];
    volume[p] += (mesh.points[a] - origin).dot(area_normal(mesh.points[a], mesh.points[b], mesh.points[c]));
  }
  const auto inside_out = [&](std::size_t p) {
    return topology.piece[p].boundary_loops == 0 && topology.piece[p].orientable && volume[p] < 0.0;
  };
  // An enclosed piece goes with the outermost one around it.
  const std::vector<std::uint32_t> outermost = outermost_around(mesh, topology);
  std::size_t turned = 0;
  for (std::size_t p = 0; p < topology.pieces; ++p)
    if (inside_out(outermost[p])) ++turned;
  for (FaceIndex face = 0; face < mesh.triangles.size(); ++face)
    if (inside_out(outermost[topology.piece_of_face[face]])) turn(mesh.triangles[face]);
  return turned;
}

}  // namespace nanocarbon
