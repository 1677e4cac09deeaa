// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/grids/isosurface.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/periodic_mesh.h"
#include "nanocarbon/shapes/polygonise_in_cell.h"

namespace nanocarbon::mesh {
namespace {

using Counts = std::array<std::size_t, 3>;

// A grid with more nodes than this takes gigabytes; one with more for each value shows nothing more.
constexpr double most_nodes = 4e7, most_for_a_value = 64;
// What shapes/polygonise_in_cell.h makes of an edge: steps of its grid this much longer, and at least so many.
constexpr double steps_per_edge = 1.4, least_steps = 9;

std::string described(const ScalarField& field) {
  return fmt::format("a scalar field{} of {} x {} x {} values",
                     field.name.empty() ? "" : " '" + field.name + "'", field.counts[0], field.counts[1],
                     field.counts[2]);
}

double required_level(const ScalarField& field, const FieldRequest& request, const std::string& file) {
  const auto [low, high] = std::minmax_element(field.values.begin(), field.values.end());
  double mean = 0.0;
  for (const float value : field.values) mean += value / static_cast<double>(field.values.size());
  const std::string range =
      fmt::format("they are between {:.6g} and {:.6g}, {:.6g} on average", *low, *high, mean);
  if (!request.level)
    throw UserError(Failure::usage,
                    fmt::format("{}: the file holds {}; give the value on the surface with --level: {}", file,
                                described(field), range));
  if (!(*request.level > *low && *request.level < *high))
    throw UserError(Failure::usage, fmt::format("{}: {} has no surface at {}; give another --level: {}", file,
                                                described(field), *request.level, range));
  return *request.level;
}

// Whether the last values along an edge are the first again, as some programs write periodic fields. Where the next ones
// are hardly others, as in the vacuum beside a slab, that says nothing.
bool comes_again(const ScalarField& field, std::size_t d) {
  const auto [low, high] = std::minmax_element(field.values.begin(), field.values.end());
  const float range = *high - *low;
  const std::size_t e = (d + 1) % 3, f = (d + 2) % 3;
  bool changes = false;
  Counts at{};
  const auto value = [&](std::size_t index) {
    at[d] = index;
    return field.at(at[0], at[1], at[2]);
  };
  for (at[e] = 0; at[e] < field.counts[e]; ++at[e])
    for (at[f] = 0; at[f] < field.counts[f]; ++at[f]) {
      const float first = value(0);
      if (std::abs(first - value(field.counts[d] - 1)) > 1e-5f * range) return false;
      changes = changes || std::abs(first - value(1)) > 1e-3f * range;
    }
  return changes;
}

// How many steps the cell has along each edge, in directions that are to be periodic.
Counts periods(const ScalarField& field, const FieldRequest& request, const std::string& file,
               std::vector<std::string>& notes) {
  Counts result = field.counts;
  for (std::size_t d = 0; d < 3; ++d) {
    if (!request.periodic[d]) continue;
    if (field.cell[d] > 0) {
      result[d] = field.cell[d];
    } else if (comes_again(field, d)) {
      --result[d];
      notes.push_back(fmt::format("the last values along {} are the first again: the cell has {} steps there",
                                  "abc"[d], result[d]));
    }
    if (result[d] > field.counts[d] || result[d] + 1 < field.counts[d] || result[d] < 2)
      throw UserError(
          Failure::usage,
          fmt::format(
              "{}: the field has {} values along {}, but its cell {} steps: it cannot be periodic there; "
              "leave this direction out of --periodic",
              file, field.counts[d], "abc"[d], result[d]));
  }
  return result;
}

//! A field between its values, by cubic splines; beyond the outermost it goes on as there.
class Interpolant {
 public:
  Interpolant(const ScalarField& field, const Counts& period, const std::array<bool, 3>& periodic)
      : field_(field), inverse_(field.steps.inverse()), period_(period), periodic_(periodic) {}

  Vec3 index(const Vec3& point) const { return inverse_ * (point - field_.origin); }

  double operator()(const Vec3& point) const {
    const Vec3 at = index(point);
    std::array<std::array<std::size_t, 4>, 3> node{};
    std::array<std::array<double, 4>, 3> weight{};
    std::array<std::size_t, 3> first{}, last{};
    for (std::size_t d = 0; d < 3; ++d) {
      double t = set_nodes(at, d, node[d]);
      // At a value itself the others do not count.
      first[d] = t == 0 ? 1 : 0;
      last[d] = t == 0 ? 2 : 4;
      weight[d] = weights(t);
    }
    double sum = 0.0;
    for (std::size_t k = first[2]; k < last[2]; ++k)
      for (std::size_t j = first[1]; j < last[1]; ++j) {
        double row = 0.0;
        for (std::size_t i = first[0]; i < last[0]; ++i)
          row += weight[0][i] * field_.at(node[0][i], node[1][j], node[2][k]);
        sum += weight[2][k] * weight[1][j] * row;
      }
    return sum;
  }

  // The same, and the slope there.
  double operator()(const Vec3& point, Vec3& slope) const {
    const Vec3 at = index(point);
    std::array<std::array<std::size_t, 4>, 3> node{};
    std::array<std::array<double, 4>, 3> weight{}, rise{};
    for (std::size_t d = 0; d < 3; ++d) {
      const double t = set_nodes(at, d, node[d]);
      weight[d] = weights(t);
      rise[d] = {0.5 * (-1 + t * (4 - 3 * t)), 0.5 * t * (-10 + 9 * t), 0.5 * (1 + t * (8 - 9 * t)),
                 0.5 * t * (-2 + 3 * t)};
    }
    double sum = 0.0;
    Vec3 along = Vec3::Zero();  // the grid's edges
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t j = 0; j < 4; ++j) {
        double row = 0.0, rises = 0.0;
        for (std::size_t i = 0; i < 4; ++i) {
          const double value = field_.at(node[0][i], node[1][j], node[2][k]);
          row += weight[0][i] * value;
          rises += rise[0][i] * value;
        }
        sum += weight[2][k] * weight[1][j] * row;
        along += Vec3(weight[2][k] * weight[1][j] * rises, weight[2][k] * rise[1][j] * row,
                      rise[2][k] * weight[1][j] * row);
      }
    slope = inverse_.transpose() * along;
    return sum;
  }

  // How fast a step along an edge of the grid is gone.
  Vec3 steps_along(int d) const { return inverse_.row(d); }

 private:
  static std::array<double, 4> weights(double t) {
    return {0.5 * t * (-1 + t * (2 - t)), 1 + 0.5 * t * t * (-5 + 3 * t), 0.5 * t * (1 + t * (4 - 3 * t)),
            0.5 * t * t * (-1 + t)};
  }

  // The four values around a place along an edge, and where between the middle two it is.
  double set_nodes(const Vec3& at, std::size_t d, std::array<std::size_t, 4>& node) const {
    double low = std::floor(at[static_cast<int>(d)]);
    double t = at[static_cast<int>(d)] - low;
    if (t > 1 - 1e-7) low += 1, t = 0;
    if (t < 1e-7) t = 0;
    for (std::size_t k = 0; k < 4; ++k) node[k] = node_of(low + static_cast<double>(k) - 1, d);
    return t;
  }

  std::size_t node_of(double index, std::size_t d) const {
    const auto n = static_cast<double>(period_[d]);
    if (periodic_[d]) index -= n * std::floor(index / n);
    return static_cast<std::size_t>(std::clamp(index, 0.0, n - 1));
  }

  const ScalarField& field_;
  Mat3 inverse_;
  Counts period_;
  std::array<bool, 3> periodic_;
};

// Mean slope of the field where it passes through the level, so that what is divided by it is about a distance.
double slope_at(const ScalarField& field, double level) {
  double sum = 0.0, lengths = 0.0;
  const Counts& n = field.counts;
  for (std::size_t k = 0; k < n[2]; ++k)
    for (std::size_t j = 0; j < n[1]; ++j)
      for (std::size_t i = 0; i < n[0]; ++i) {
        const double here = field.at(i, j, k);
        const Counts next = {i + 1, j + 1, k + 1};
        for (std::size_t d = 0; d < 3; ++d) {
          if (next[d] == n[d]) continue;
          const double there = field.at(d == 0 ? i + 1 : i, d == 1 ? j + 1 : j, d == 2 ? k + 1 : k);
          if ((here < level) == (there < level)) continue;
          sum += std::abs(there - here);
          lengths += field.steps.col(static_cast<int>(d)).norm();
        }
      }
  return sum / lengths;
}

// Whether the surface does not come to any edge of the field but all that lies there is above it, as for a distance.
bool is_within(const ScalarField& field, double level, const std::array<bool, 3>& periodic) {
  const Counts& n = field.counts;
  Counts at{};
  bool any = false;
  for (at[2] = 0; at[2] < n[2]; ++at[2])
    for (at[1] = 0; at[1] < n[1]; ++at[1])
      for (at[0] = 0; at[0] < n[0]; ++at[0])
        for (std::size_t d = 0; d < 3; ++d) {
          if (periodic[d] || (at[d] != 0 && at[d] + 1 != n[d])) continue;
          any = true;
          if (field.at(at[0], at[1], at[2]) <= level) return false;
        }
  return any;
}

// The shortest step of the field, or a longer one, with which the grid does not have too many nodes.
double grid_step(const Cell& cell, const ScalarField& field) {
  const Vec3 lengths = cell.vectors.colwise().norm();
  const double shortest = field.steps.colwise().norm().minCoeff();
  const double most = std::min(most_nodes, most_for_a_value * static_cast<double>(field.values.size()));
  const double nodes = (lengths.array() / shortest + 1).prod();
  double step = shortest * std::max(1.0, std::cbrt(nodes / most));
  // A narrow cell has its least number of steps whatever the length of these.
  const auto along = [&](int d) { return std::max(least_steps, lengths[d] / step); };
  while (along(0) * along(1) * along(2) > 1.5 * most && lengths.maxCoeff() > least_steps * step) step *= 1.1;
  return step;
}

}  // namespace

PolygonSoup isosurface(const ScalarField& field, const FieldRequest& request, const std::string& file) {
  const double level = required_level(field, request, file);
  std::vector<std::string> notes = field.notes;
  const Counts period = periods(field, request, file, notes);
  const Interpolant interpolant(field, period, request.periodic);
  const bool closed = request.edge != FieldEdge::open;
  const bool below = request.edge == FieldEdge::below ||
                     (request.edge == FieldEdge::closed && is_within(field, level, request.periodic));
  const double sign = (below ? 1 : -1) / slope_at(field, level);

  Cell cell;
  cell.periodic = request.periodic;
  cell.origin = field.origin;
  Vec3 widths;  // of a step, between the planes of the others
  for (int d = 0; d < 3; ++d) {
    const auto k = static_cast<std::size_t>(d);
    const auto n = static_cast<double>(period[k]);
    const double steps = request.periodic[k] ? n : closed ? n + 1 : n - 1;
    if (!request.periodic[k] && closed) cell.origin -= field.steps.col(d);
    cell.vectors.col(d) = steps * field.steps.col(d);
    widths[d] = 1 / field.steps.inverse().row(d).norm();
  }
  const double step = grid_step(cell, field);
  const double edge = step / steps_per_edge * (1 + 1e-9);

  // Below zero inside.
  const shapes::ImplicitShape shape = [&](const Vec3& point) {
    double value = sign * (interpolant(point) - level);
    if (!closed) return value;
    const Vec3 at = interpolant.index(point);
    for (int d = 0; d < 3; ++d) {
      if (request.periodic[static_cast<std::size_t>(d)]) continue;
      const double last = static_cast<double>(period[static_cast<std::size_t>(d)]) - 1;
      value = std::max(value, widths[d] * (std::max(-at[d], at[d] - last) - 0.5));
    }
    return value;
  };
  const shapes::ImplicitSlope slope = [&](const Vec3& point, Vec3& gradient) {
    double value = sign * (interpolant(point, gradient) - level);
    gradient *= sign;
    if (!closed) return value;
    const Vec3 at = interpolant.index(point);
    for (int d = 0; d < 3; ++d) {
      if (request.periodic[static_cast<std::size_t>(d)]) continue;
      const double last = static_cast<double>(period[static_cast<std::size_t>(d)]) - 1;
      const bool low = -at[d] > at[d] - last;
      const double beyond = widths[d] * ((low ? -at[d] : at[d] - last) - 0.5);
      if (beyond <= value) continue;
      value = beyond;
      gradient = (low ? -widths[d] : widths[d]) * interpolant.steps_along(d);
    }
    return value;
  };
  TriangleMesh mesh;
  try {
    mesh = shapes::polygonise_in_cell(shape, cell, edge, slope);
  } catch (const UserError& error) {
    throw UserError(error.failure(), fmt::format("{}: {}", file, error.what()));
  }
  PolygonSoup soup = soup_of(unfolded(mesh).mesh);
  soup.notes = std::move(notes);
  soup.notes.push_back(fmt::format("took the surface where {} is {}", described(field), level));
  if (step > field.steps.colwise().norm().minCoeff())
    soup.notes.push_back(
        fmt::format("the surface is made at steps of {:.6g}, longer than the grid's shortest", step));
  if (cell.periodic != std::array<bool, 3>{false, false, false}) soup.cell = cell;
  soup.is_isosurface = true;
  soup.unit = field.unit;
  return soup;
}

}  // namespace nanocarbon::mesh
