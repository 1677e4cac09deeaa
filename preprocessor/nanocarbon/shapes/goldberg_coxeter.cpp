// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/shapes/goldberg_coxeter.h"

#include "nanocarbon/shapes/lattice_surface.h"

namespace nanocarbon::shapes {

TriangleMesh goldberg_coxeter(const TriangleMesh& base, int h, int k) {
  const Eisenstein side = {h, k};
  std::vector<LatticePiece> pieces;
  pieces.reserve(base.triangles.size());
  for (const Triangle& t : base.triangles)
    pieces.push_back({t, {Eisenstein{0, 0}, side, side * sixth_turn(1)}});

  LatticeSurface surface = glue(pieces);
  TriangleMesh mesh;
  mesh.space = base.space;
  mesh.triangles = std::move(surface.triangles);
  mesh.points.reserve(surface.vertices.size());
  for (const LatticePlace& place : surface.vertices) {
    const auto weight = barycentric(pieces[place.piece], place.at);
    const std::array<Vec3, 3> corner = corners_of(base, base.triangles[place.piece]);
    mesh.points.push_back(weight[0] * corner[0] + weight[1] * corner[1] + weight[2] * corner[2]);
  }
  return mesh;
}

}  // namespace nanocarbon::shapes
