// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/formats/lammps_box.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace nanocarbon::molecule {
namespace {

bool has_lammps_form(const Mat3& m) {
  return m(1, 0) == 0.0 && m(2, 0) == 0.0 && m(2, 1) == 0.0 && m(0, 0) > 0.0 && m(1, 1) > 0.0 &&
         m(2, 2) > 0.0;
}

// Right-handed vectors that keep the periodic ones; the others are unit vectors perpendicular to all.
Mat3 with_perpendicular_open_directions(const Cell& cell) {
  const auto periodic = std::count(cell.periodic.begin(), cell.periodic.end(), true);
  if (periodic == 0) return Mat3::Identity();
  if (periodic == 3) return cell.vectors;
  Mat3 m = cell.vectors;
  int d = 0;
  if (periodic == 1) {
    while (!cell.periodic[d]) ++d;
    const Vec3 kept = m.col(d).normalized();
    Vec3 other = m.col((d + 1) % 3);
    other -= other.dot(kept) * kept;
    m.col((d + 1) % 3) = other.normalized();
    d = (d + 2) % 3;
  } else {
    while (cell.periodic[d]) ++d;
  }
  m.col(d) = m.col((d + 1) % 3).cross(m.col((d + 2) % 3)).normalized();
  return m;
}

Mat3 rotation_to_lammps_form(const Mat3& m) {
  if (has_lammps_form(m)) return Mat3::Identity();
  const Vec3 x = m.col(0).normalized(), z = m.col(0).cross(m.col(1)).normalized();
  Mat3 rotation;
  rotation << x.transpose(), z.cross(x).transpose(), z.transpose();
  return rotation;
}

Mat3 rotated(const Mat3& rotation, const Mat3& m) {
  if (rotation.isIdentity(0.0)) return m;
  Mat3 r = rotation * m;
  // What rounding leaves of a right angle would make the box triclinic.
  const double zero = 1e-13 * r.norm();
  r = r.unaryExpr([zero](double x) { return std::abs(x) < zero ? 0.0 : x; });
  r(1, 0) = r(2, 0) = r(2, 1) = 0.0;
  return r;
}

void reduce_tilts(Mat3& m) {
  const auto reduce = [&](int column, int row) {
    const double tilts = m(row, column) / m(row, row);
    if (std::abs(tilts) > 0.5 + 1e-9) m.col(column) -= std::round(tilts) * m.col(row);
  };
  reduce(1, 0);
  reduce(2, 1);
  reduce(2, 0);
}

}  // namespace

LammpsBox lammps_box(const Molecule& molecule, double margin) {
  const Cell free_space{Mat3::Identity(), Vec3::Zero(), {false, false, false}};
  const Cell& given = molecule.cell ? *molecule.cell : free_space;
  const Mat3 vectors = with_perpendicular_open_directions(given);
  LammpsBox box;
  box.rotation = rotation_to_lammps_form(vectors);
  box.cell.vectors = rotated(box.rotation, vectors);
  reduce_tilts(box.cell.vectors);
  box.cell.origin = box.rotation * given.origin;
  box.cell.periodic = given.periodic;

  const Mat3 to_fractional = box.cell.vectors.inverse();
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Vec3& p : molecule.positions) {
    const Vec3 f = to_fractional * (box.rotation * p - box.cell.origin);
    low = low.cwiseMin(f);
    high = high.cwiseMax(f);
  }
  if (molecule.positions.empty()) low = high = Vec3::Zero();
  for (int d = 0; d < 3; ++d)
    if (!box.cell.periodic[d]) {  // a unit vector, so fractions are Angstrom
      const double extent = std::max(high[d] - low[d] + 2.0 * margin, 1.0);
      box.cell.origin += (0.5 * (low[d] + high[d]) - 0.5 * extent) * box.cell.vectors.col(d);
      box.cell.vectors.col(d) *= extent;
    }
  return box;
}

}  // namespace nanocarbon::molecule
