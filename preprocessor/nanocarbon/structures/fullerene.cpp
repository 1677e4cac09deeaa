// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/structures/fullerene.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "nanocarbon/core/error.h"
#include "nanocarbon/molecule/dual.h"
#include "nanocarbon/shapes/goldberg_coxeter.h"
#include "nanocarbon/shapes/icosahedron.h"
#include "nanocarbon/structures/honeycomb.h"
#include "nanocarbon/structures/spring_relaxation.h"

namespace nanocarbon::structures {
namespace {

//! Triangles of the flat icosahedron for each one of its faces.
double triangles_per_face(int h, int k) {
  return static_cast<double>(h) * h + static_cast<double>(h) * k + static_cast<double>(k) * k;
}

void check_indices(int h, int k) {
  if (h < 0 || k < 0 || (h == 0 && k == 0))
    throw UserError(
        Failure::usage,
        fmt::format("({}, {}) is not a fullerene: both indices must be 0 or more, not both 0", h, k));
  if (20.0 * triangles_per_face(h, k) > 1e7)
    throw UserError(Failure::usage,
                    fmt::format("fullerene ({}, {}) would have {:.0f} atoms; the limit is 10 million", h, k,
                                20.0 * triangles_per_face(h, k)));
}

}  // namespace

TriangleMesh icosahedral_triangulation(int h, int k) {
  check_indices(h, k);
  return shapes::goldberg_coxeter(shapes::icosahedron(std::sqrt(triangles_per_face(h, k))), h, k);
}

Molecule fullerene(int h, int k) {
  TriangleMesh triangulation = icosahedral_triangulation(h, k);
  for (Vec3& point : triangulation.points) point *= graphene_lattice_constant;
  Molecule cage = molecule::dual(triangulation);
  relax_by_springs(cage, {});
  return cage;
}

}  // namespace nanocarbon::structures
