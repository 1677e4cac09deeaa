// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/formats/read_settings.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <numeric>

#include "nanocarbon/core/error.h"

namespace nanocarbon::molecule {
namespace {

constexpr std::array<bool, 3> nowhere = {false, false, false};

void complete_open_directions(Cell& cell) {
  for (int d = 0; d < 3; ++d) {
    if (cell.periodic[d] || !cell.vectors.col(d).isZero(0.0)) continue;
    Vec3 others[2] = {cell.vectors.col((d + 1) % 3), cell.vectors.col((d + 2) % 3)};
    for (int k = 0; k < 2; ++k)
      if (others[k].isZero(0.0))
        others[k] = others[1 - k].isZero(0.0) ? Vec3::Unit(d) : others[1 - k].unitOrthogonal();
    cell.vectors.col(d) = others[0].cross(others[1]).normalized();
  }
}

}  // namespace

std::optional<Cell> cell_as_read(const TextInput& input, Cell cell, const ReadSettings& settings) {
  if (settings.periodic) cell.periodic = *settings.periodic;
  if (cell.periodic == nowhere) return std::nullopt;
  complete_open_directions(cell);
  const double size = cell.vectors.colwise().norm().prod(), inside = cell.vectors.determinant();
  if (!(std::abs(inside) > 1e-9 * size)) input.fail("the box or its vectors do not span a volume");
  if (inside < 0.0) {
    cell.origin += cell.vectors.col(2);
    cell.vectors.col(2) = -cell.vectors.col(2);
  }
  return cell;
}

void require_free_space(const TextInput& input, const ReadSettings& settings) {
  if (settings.periodic.value_or(nowhere) == nowhere) return;
  throw UserError(Failure::unsuitable, fmt::format("{}:{}: the file gives no cell, so no direction can be "
                                                   "periodic (--boundary) until --cell gives one",
                                                   input.name(), input.number()));
}

std::optional<std::int64_t> sort_by_id(MoleculeFrame& frame) {
  std::vector<std::int64_t>& ids = frame.ids;
  if (!std::is_sorted(ids.begin(), ids.end())) {
    std::vector<std::uint32_t> order(ids.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return ids[a] < ids[b]; });
    const auto permute = [&](auto& values) {
      auto sorted = values;
      for (std::size_t i = 0; i < order.size(); ++i) sorted[i] = values[order[i]];
      values = std::move(sorted);
    };
    permute(ids);
    permute(frame.molecule.positions);
    permute(frame.molecule.elements);
  }
  const auto twice = std::adjacent_find(ids.begin(), ids.end());
  return twice == ids.end() ? std::nullopt : std::optional(*twice);
}

}  // namespace nanocarbon::molecule
