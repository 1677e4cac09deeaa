// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/structures/graphite.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "nanocarbon/core/error.h"
#include "nanocarbon/structures/close_bonds.h"

namespace nanocarbon::structures {
namespace {

constexpr double margin_of_slab = 10.0;  // Angstrom

}  // namespace

GraphiteLattice graphite_lattice(Stacking stacking, bool morse) {
  if (stacking == Stacking::ab)
    return morse ? GraphiteLattice{1.3963387, 3.2939332} : GraphiteLattice{1.3957507, 3.3579973};
  return morse ? GraphiteLattice{1.3962961, 3.3184963} : GraphiteLattice{1.3957148, 3.3833161};
}

Molecule graphite(const GraphiteSize& size, Stacking stacking, const GraphiteLattice& lattice, bool slab) {
  if (size.cells_x < 1 || size.cells_y < 1 || size.layers < 1)
    throw UserError(Failure::usage, "graphite needs at least one layer, and one cell along x and along y");
  if (stacking == Stacking::ab && size.layers % 2 == 1 && !slab)
    throw UserError(
        Failure::usage,
        fmt::format("{} AB layers do not repeat along z: use an even number, AA stacking, or a slab",
                    size.layers));
  const double cell_x = std::numbers::sqrt3 * lattice.bond, cell_y = 3.0 * lattice.bond;
  const std::array<Vec3, 4> cell = {Vec3(0.0, 0.0, 0.0), Vec3(0.5 * cell_x, 0.5 * lattice.bond, 0.0),
                                    Vec3(0.5 * cell_x, 1.5 * lattice.bond, 0.0),
                                    Vec3(0.0, 2.0 * lattice.bond, 0.0)};
  Molecule graphite;
  const double height =
      slab ? (size.layers - 1) * lattice.layer + 2.0 * margin_of_slab : size.layers * lattice.layer;
  graphite.cell =
      orthogonal_cell(Vec3(size.cells_x * cell_x, size.cells_y * cell_y, height), {true, true, !slab});
  graphite.cell->origin.z() = slab ? -margin_of_slab : 0.0;
  for (int k = 0; k < size.layers; ++k) {
    const Vec3 shift(0.0, stacking == Stacking::ab && k % 2 == 1 ? lattice.bond : 0.0, k * lattice.layer);
    for (int j = 0; j < size.cells_y; ++j)
      for (int i = 0; i < size.cells_x; ++i)
        for (const Vec3& atom : cell)
          graphite.positions.push_back(atom + shift + Vec3(i * cell_x, j * cell_y, 0.0));
  }
  graphite.elements.assign(graphite.size(), Element::carbon);
  add_bonds(graphite);
  add_rings(graphite, 6);
  return graphite;
}

GraphiteSize graphite_size(double length_x, double length_y, int layers, const GraphiteLattice& lattice) {
  const auto cells = [](double length, double cell) {
    return std::max(1, static_cast<int>(std::lround(length / cell)));
  };
  return {cells(length_x, std::numbers::sqrt3 * lattice.bond), cells(length_y, 3.0 * lattice.bond), layers};
}

}  // namespace nanocarbon::structures
