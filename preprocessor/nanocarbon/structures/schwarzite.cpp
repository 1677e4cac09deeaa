// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/structures/schwarzite.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "nanocarbon/core/error.h"
#include "nanocarbon/structures/close_bonds.h"

namespace nanocarbon::structures {
namespace {

Vec3 into_cell(const Vec3& fractional) {
  return fractional.unaryExpr([](double f) { return f - std::floor(f); });
}

//! Pn-3m with the origin at -43m: six atoms on the two-fold axes around each of four three-fold axes.
std::vector<Vec3> d688_sites() {
  const double y = 0.1656419;
  const Vec3 half_turns[4] = {{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}};
  std::vector<Vec3> sites;
  for (const Vec3& half_turn : half_turns) {
    std::array<double, 3> offset = {-y, 0.0, y};
    do {
      const Vec3 site = Vec3::Constant(0.25) + Vec3(offset[0], offset[1], offset[2]);
      sites.push_back(into_cell(half_turn.cwiseProduct(site)));
    } while (std::next_permutation(offset.begin(), offset.end()));
  }
  return sites;
}

//! Im-3m, Wyckoff position 48k: (x, x, z) with every permutation and sign, and the same around the body
//! centre.
std::vector<Vec3> p688_sites() {
  const double x = 0.313108, z = 0.090801;
  std::vector<Vec3> sites;
  for (const double centre : {0.0, 0.5})
    for (int odd_one = 0; odd_one < 3; ++odd_one)
      for (int signs = 0; signs < 8; ++signs) {
        Vec3 site = Vec3::Constant(x);
        site[odd_one] = z;
        for (int d = 0; d < 3; ++d)
          if (signs >> d & 1) site[d] = -site[d];
        sites.push_back(into_cell(site + Vec3::Constant(centre)));
      }
  return sites;
}

//! Ia-3d, general position 96h.
std::vector<Vec3> g688_sites() {
  const auto equivalents = [](const Vec3& p) {
    return std::array<Vec3, 6>{Vec3(-p.x() + 0.5, -p.y(), p.z() + 0.5),
                               Vec3(-p.x(), p.y() + 0.5, -p.z() + 0.5),
                               Vec3(p.z(), p.x(), p.y()),
                               Vec3(p.y() + 0.75, p.x() + 0.25, -p.z() + 0.25),
                               Vec3(-p),
                               Vec3(p + Vec3::Constant(0.5))};
  };
  std::vector<Vec3> sites = {Vec3(0.0541145, 0.9229557, 0.6144784)};
  for (std::size_t known = 0; known < sites.size(); ++known)
    for (const Vec3& other : equivalents(sites[known])) {
      const Vec3 site = into_cell(other);
      const auto same = [&](const Vec3& s) {
        return (site - s).unaryExpr([](double d) { return d - std::round(d); }).norm() < 1e-4;
      };
      if (std::none_of(sites.begin(), sites.end(), same)) sites.push_back(site);
    }
  return sites;
}

//! Fd-3 with the origin at 23: 8 atoms on three-fold axes and 48 in general position for each primitive cell, half of
//! them around the origin and half around its image in the inversion at (1/8, 1/8, 1/8). Fractions of the cube.
std::vector<Vec3> d56_sites() {
  const double s = -0.1150732;
  const Vec3 half_turns[4] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  std::vector<Vec3> sites;
  for (const Vec3& half_turn : half_turns) {
    sites.push_back(s * half_turn);
    for (const Vec3& p : {Vec3(0.1828463, 0.1315553, -0.0304329), Vec3(0.0189494, 0.2358411, 0.0511697)})
      for (int turn = 0; turn < 3; ++turn)
        sites.push_back(half_turn.cwiseProduct(Vec3(p[turn], p[(turn + 1) % 3], p[(turn + 2) % 3])));
  }
  for (std::size_t i = 0, half = sites.size(); i < half; ++i)
    sites.push_back(Vec3::Constant(0.25) - Vec3(sites[i]));
  return sites;
}

//! \param sites,vectors in units of `edge`
Molecule crystal(const std::vector<Vec3>& sites, double edge, const std::array<int, 3>& cells,
                 const Mat3& vectors = Mat3::Identity()) {
  if (*std::min_element(cells.begin(), cells.end()) < 1)
    throw UserError(Failure::usage, "a schwarzite needs at least one cell along each edge");
  Molecule molecule;
  molecule.cell = Cell{.vectors = edge * vectors * Vec3(cells[0], cells[1], cells[2]).asDiagonal()};
  for (int k = 0; k < cells[2]; ++k)
    for (int j = 0; j < cells[1]; ++j)
      for (int i = 0; i < cells[0]; ++i)
        for (const Vec3& site : sites) molecule.positions.push_back(edge * (vectors * Vec3(i, j, k) + site));
  molecule.elements.assign(molecule.size(), Element::carbon);
  add_bonds(molecule);
  add_rings(molecule, 8);
  return molecule;
}

}  // namespace

Molecule schwarzite_d688(int cells_x, int cells_y, int cells_z) {
  return crystal(d688_sites(), 6.0635, {cells_x, cells_y, cells_z});
}

Molecule schwarzite_p688(int cells_x, int cells_y, int cells_z) {
  return crystal(p688_sites(), 7.8006, {cells_x, cells_y, cells_z});
}

Molecule schwarzite_g688(int cells_x, int cells_y, int cells_z) {
  return crystal(g688_sites(), 9.6010758, {cells_x, cells_y, cells_z});
}

Molecule schwarzite_d56(int cells_a, int cells_b, int cells_c) {
  Mat3 primitive;
  primitive << 0, 0.5, 0.5, 0.5, 0, 0.5, 0.5, 0.5, 0;
  return crystal(d56_sites(), 13.1207783, {cells_a, cells_b, cells_c}, primitive);
}

}  // namespace nanocarbon::structures
