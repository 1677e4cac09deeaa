// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/structures/graphene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "nanocarbon/core/error.h"
#include "nanocarbon/structures/close_bonds.h"
#include "nanocarbon/structures/honeycomb.h"

namespace nanocarbon::structures {
namespace {

constexpr double cell_x = graphene_lattice_constant;
constexpr double cell_y = 3.0 * graphene_bond;

std::array<Vec3, 4> rectangular_cell() {
  return {Vec3(0.0, 0.0, 0.0), Vec3(0.5 * cell_x, 0.5 * graphene_bond, 0.0),
          Vec3(0.5 * cell_x, 1.5 * graphene_bond, 0.0), Vec3(0.0, 2.0 * graphene_bond, 0.0)};
}

}  // namespace

Molecule graphene(int cells_x, int cells_y) {
  if (cells_x < 1 || cells_y < 1)
    throw UserError(Failure::usage, "a graphene sheet needs at least one cell along x and along y");
  Molecule sheet;
  const double height = 20.0;
  sheet.cell = orthogonal_cell(Vec3(cells_x * cell_x, cells_y * cell_y, height), {true, true, false});
  sheet.cell->origin = Vec3(0.0, 0.0, -0.5 * height);
  for (int j = 0; j < cells_y; ++j)
    for (int i = 0; i < cells_x; ++i)
      for (const Vec3& atom : rectangular_cell())
        sheet.positions.push_back(atom + Vec3(i * cell_x, j * cell_y, 0.0));
  sheet.elements.assign(sheet.size(), Element::carbon);
  add_bonds(sheet);
  add_rings(sheet, 6);
  return sheet;
}

Molecule graphene_sheet(double length_x, double length_y) {
  if (!(length_x > 0.0 && length_y > 0.0))
    throw UserError(Failure::usage, "the lengths of a graphene sheet must be above zero");
  const auto cells = [](double length, double cell) {
    return std::max(1, static_cast<int>(std::lround(length / cell)));
  };
  return graphene(cells(length_x, cell_x), cells(length_y, cell_y));
}

Molecule graphene_flake(double radius) {
  if (!(radius >= 1.5))
    throw UserError(Failure::usage,
                    fmt::format("a flake of radius {} Angstrom contains no ring; use 1.5 or more", radius));
  const Vec3 middle_of_ring(0.0, graphene_bond, 0.0);
  Molecule flake;
  const int reach_x = static_cast<int>(std::ceil(radius / cell_x)) + 1;
  const int reach_y = static_cast<int>(std::ceil(radius / cell_y)) + 1;
  for (int j = -reach_y; j <= reach_y; ++j)
    for (int i = -reach_x; i <= reach_x; ++i)
      for (const Vec3& atom : rectangular_cell()) {
        const Vec3 position = atom + Vec3(i * cell_x, j * cell_y, 0.0) - middle_of_ring;
        if (position.norm() <= radius) flake.positions.push_back(position);
      }
  flake.elements.assign(flake.size(), Element::carbon);
  add_bonds(flake);
  flake = without_dangling_atoms(flake);
  add_rings(flake, 6);
  return flake;
}

}  // namespace nanocarbon::structures
