// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/structures/schwarzite.h"

#include <algorithm>
#include <array>
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

Molecule crystal(const std::vector<Vec3>& sites, double edge, const std::array<int, 3>& cells) {
  if (*std::min_element(cells.begin(), cells.end()) < 1)
    throw UserError(Failure::usage, "a schwarzite needs at least one cell along each edge");
  Molecule molecule;
  molecule.cell = orthogonal_cell(edge * Vec3(cells[0], cells[1], cells[2]));
  for (int k = 0; k < cells[2]; ++k)
    for (int j = 0; j < cells[1]; ++j)
      for (int i = 0; i < cells[0]; ++i)
        for (const Vec3& site : sites) molecule.positions.push_back(edge * (Vec3(i, j, k) + site));
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

}  // namespace nanocarbon::structures
