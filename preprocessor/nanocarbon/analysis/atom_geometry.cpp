// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/analysis/atom_geometry.h"

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <numbers>

namespace nanocarbon::analysis {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

double pyramidalisation_of(const Molecule& molecule, AtomIndex atom, std::span<const BondRowEnd> ends) {
  std::array<Vec3, 3> u;
  for (std::size_t k = 0; k < 3; ++k) u[k] = bond_vector(molecule, atom, ends[k]).normalized();
  const Vec3 axis = (u[1] - u[0]).cross(u[2] - u[0]).normalized();
  return std::asin(std::min(1.0, std::abs(axis.dot(u[0])))) * 180.0 / std::numbers::pi;
}

// Unit normals of the planes through the neighbours of atoms with three bonds; zero for others.
std::vector<Vec3> neighbour_normals(const Molecule& molecule, const BondRows& rows) {
  std::vector<Vec3> normals(molecule.size(), Vec3::Zero());
  for (AtomIndex a = 0; a < molecule.size(); ++a) {
    if (rows.degree(a) != 3) continue;
    const auto ends = rows.of(a);
    const Vec3 x = bond_vector(molecule, a, ends[0]);
    normals[a] =
        (bond_vector(molecule, a, ends[1]) - x).cross(bond_vector(molecule, a, ends[2]) - x).normalized();
  }
  return normals;
}

// Turns normals outwards where a ring tells: it goes counter-clockwise, so outwards is on the left of its turn.
std::vector<std::uint8_t> turn_outwards(const Molecule& molecule, const BondRows& rows, const Rings& rings,
                                        std::span<const std::uint8_t> oriented, std::vector<Vec3>& normals) {
  std::vector<std::uint8_t> known(molecule.size(), 0);
  const auto vector_to = [&](AtomIndex from, AtomIndex to) {
    for (const BondRowEnd& end : rows.of(from))
      if (end.atom == to) return bond_vector(molecule, from, end);
    return Vec3(Vec3::Zero());
  };
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const auto ring = rings[r];
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const AtomIndex a = ring[k];
      if (known[a] || !oriented[a]) continue;
      const Vec3 to = vector_to(a, ring[(k + 1) % ring.size()]);
      const Vec3 from = vector_to(a, ring[(k + ring.size() - 1) % ring.size()]);
      if (to.cross(from).dot(normals[a]) < 0.0) normals[a] = -normals[a];
      known[a] = 1;
    }
  }
  return known;
}

Vec3 perpendicular(const Vec3& v, const Vec3& unit) { return v - v.dot(unit) * unit; }

}  // namespace

AtomGeometry atom_geometry(const Molecule& molecule, const BondRows& rows, const Rings& rings,
                           std::span<const std::uint8_t> oriented) {
  AtomGeometry result;
  result.pyramidalisation.assign(molecule.size(), unknown);
  result.mean_curvature.assign(molecule.size(), unknown);
  result.gaussian_curvature.assign(molecule.size(), unknown);
  std::vector<Vec3> normals = neighbour_normals(molecule, rows);
  const std::vector<std::uint8_t> outside = turn_outwards(molecule, rows, rings, oriented, normals);
  for (AtomIndex a = 0; a < molecule.size(); ++a) {
    if (rows.degree(a) != 3 || molecule.elements[a] != Element::carbon) continue;
    const auto ends = rows.of(a);
    result.pyramidalisation[a] = pyramidalisation_of(molecule, a, ends);
    std::array<Vec3, 3> x, n;
    bool known = true;
    for (std::size_t k = 0; k < 3; ++k) {
      x[k] = bond_vector(molecule, a, ends[k]);
      const AtomIndex b = ends[k].atom;
      known = known && rows.degree(b) == 3 && molecule.elements[b] == Element::carbon;
      const Vec3 along =
          x[k].normalized();  // the neighbour's normal is on the side that a rotation takes ours to
      n[k] = perpendicular(normals[a], along).dot(perpendicular(normals[b], along)) < 0.0 ? Vec3(-normals[b])
                                                                                          : normals[b];
    }
    if (!known) continue;
    const Vec3 v1 = x[1] - x[0], v2 = x[2] - x[0];
    const Vec3 d1 = perpendicular(n[1] - n[0], normals[a]), d2 = perpendicular(n[2] - n[0], normals[a]);
    Eigen::Matrix2d first, second;
    first << v1.dot(v1), v1.dot(v2), v1.dot(v2), v2.dot(v2);
    second << v1.dot(d1), v1.dot(d2), v2.dot(d1), v2.dot(d2);
    if (first.determinant() < 1e-12 * first.trace() * first.trace()) continue;
    const Eigen::Matrix2d shape = first.inverse() * second;
    const double mean = 0.5 * shape.trace();
    result.mean_curvature[a] = outside[a] ? mean : std::abs(mean);
    result.gaussian_curvature[a] = shape.determinant();
  }
  return result;
}

}  // namespace nanocarbon::analysis
