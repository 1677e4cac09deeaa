// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/structures/bundle.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "nanocarbon/core/error.h"
#include "nanocarbon/structures/onion.h"

namespace nanocarbon::structures {
namespace {

constexpr double margin = 10.0;  // beyond the ends of a tube that is not periodic, Angstrom

Molecule copies_at(const Molecule& tube, const std::vector<Vec3>& axes) {
  Molecule result;
  for (const Vec3& axis : axes) {
    Molecule copy = tube;
    for (Vec3& p : copy.positions) p += axis;
    append(result, copy);
  }
  result.cell = tube.cell;
  return result;
}

}  // namespace

Molecule bundle(const Molecule& tube, int tubes, double distance) {
  if (tubes < 1) throw UserError(Failure::usage, "a bundle needs at least one tube");
  const int reach = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(tubes)))) + 1;
  // Sorted by exact distance from the middle, then by angle from x.
  struct Place {
    int squared;
    double angle;
    Vec3 axis;
  };
  std::vector<Place> places;
  for (int i = -reach; i <= reach; ++i)
    for (int j = -reach; j <= reach; ++j) {
      const Vec3 axis(distance * (i + 0.5 * j), distance * 0.5 * std::numbers::sqrt3 * j, 0.0);
      double angle = std::atan2(axis.y(), axis.x());
      if (angle < -1e-9) angle += 2.0 * std::numbers::pi;
      places.push_back({i * i + i * j + j * j, angle, axis});
    }
  std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
    return a.squared != b.squared ? a.squared < b.squared : a.angle < b.angle;
  });
  std::vector<Vec3> axes;
  for (int n = 0; n < tubes; ++n) axes.push_back(places[n].axis);
  Molecule result = copies_at(tube, axes);
  if (!result.cell) return result;
  for (int d = 0; d < 2; ++d) {
    const auto [low, high] = std::minmax_element(axes.begin(), axes.end(),
                                                 [d](const Vec3& a, const Vec3& b) { return a[d] < b[d]; });
    result.cell->origin[d] += (*low)[d];
    result.cell->vectors(d, d) += (*high)[d] - (*low)[d];
  }
  return result;
}

Molecule bundle_crystal(const Molecule& tube, int cells_x, int cells_y, double distance) {
  if (cells_x < 1 || cells_y < 1)
    throw UserError(Failure::usage, "a bundle that fills space needs at least one cell along x and along y");
  const Vec3 edges(distance, std::numbers::sqrt3 * distance, 0.0);
  std::vector<Vec3> axes;
  for (int j = 0; j < cells_y; ++j)
    for (int i = 0; i < cells_x; ++i)
      for (const double half : {0.0, 0.5})
        axes.emplace_back((i + half) * edges.x(), (j + half) * edges.y(), 0.0);
  Molecule result = copies_at(tube, axes);
  double low = 0.0, high = 0.0;
  if (!tube.cell) {
    const auto [first, last] =
        std::minmax_element(result.positions.begin(), result.positions.end(),
                            [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); });
    low = first->z() - margin;
    high = last->z() + margin;
  } else {
    low = tube.cell->origin.z();
    high = low + tube.cell->vectors(2, 2);
  }
  result.cell = orthogonal_cell(Vec3(cells_x * edges.x(), cells_y * edges.y(), high - low),
                                {true, true, tube.cell.has_value()});
  result.cell->origin.z() = low;
  return result;
}

}  // namespace nanocarbon::structures
