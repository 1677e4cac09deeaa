// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/shapes/formula_surface.h"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "nanocarbon/core/error.h"
#include "nanocarbon/core/random_stream.h"
#include "nanocarbon/shapes/polygonise.h"
#include "nanocarbon/shapes/polygonise_in_cell.h"

namespace nanocarbon::shapes {
namespace {

class Formula {
 public:
  explicit Formula(const std::string& text) : text_(text) {
    try {
      parser_.DefineConst("pi", std::numbers::pi);
      for (int d = 0; d < 3; ++d) parser_.DefineVar(std::string(1, "xyz"[d]), &at_[d]);
      parser_.SetExpr(text);
      parser_.Eval();
    } catch (const mu::Parser::exception_type& error) {
      fail(error.GetMsg());
    }
    if (parser_.GetNumResults() != 1) fail("it has a comma outside of brackets");
  }

  double operator()(const Vec3& point) {
    at_ = point;
    double value = 0.0;
    try {
      value = parser_.Eval();
    } catch (const mu::Parser::exception_type& error) {
      fail(error.GetMsg());
    }
    if (!std::isfinite(value))
      fail(
          fmt::format("it has no finite value at ({:.6g}, {:.6g}, {:.6g})", point.x(), point.y(), point.z()));
    return value;
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw UserError(Failure::usage,
                    fmt::format("the formula '{}' cannot be used: {}; write one of x, y and z, such as "
                                "'cos(x)+cos(y)+cos(z)', with ^ for powers",
                                text_, reason));
  }

  const std::string text_;
  Vec3 at_ = Vec3::Zero();
  mu::Parser parser_;
};

// A formula that is not periodic would have a crack along the cell's faces.
void require_periodic(const ImplicitShape& shape, const Cell& cell) {
  constexpr int places = 100;
  constexpr double rounding = 1e-6;
  RandomStream random(1, 0);
  std::vector<std::pair<Vec3, double>> values;
  double largest = 0.0;
  for (int i = 0; i < places; ++i) {
    const Vec3 at = cell.origin + cell.vectors * Vec3(random.uniform(), random.uniform(), random.uniform());
    values.emplace_back(at, shape(at));
    largest = std::max(largest, std::abs(values.back().second));
  }
  for (int d = 0; d < 3; ++d)
    for (const auto& [at, value] : values) {
      if (!cell.periodic[static_cast<std::size_t>(d)]) continue;
      const double there = shape(at + cell.vectors.col(d));
      if (std::abs(there - value) <= rounding * largest) continue;
      throw UserError(
          Failure::usage,
          fmt::format(
              "the formula does not repeat itself along the cell's edge {}: it is {:.6g} at ({:.4g}, "
              "{:.4g}, {:.4g}) and {:.6g} an edge of {:.6g} further; give its period with --period, or "
              "the directions in which it has one with --periodic",
              "abc"[d], value, at.x(), at.y(), at.z(), there, cell.vectors.col(d).norm()));
    }
}

}  // namespace

ImplicitShape shape_of_formula(const std::string& formula) {
  return [parsed = std::make_shared<Formula>(formula)](const Vec3& point) { return (*parsed)(point); };
}

TriangleMesh make_formula_surface(const FormulaSurface& s) {
  Cell cell = s.cell;
  cell.origin = -0.5 * cell.vectors * Vec3::Ones();
  const double shortest = cell.vectors.colwise().norm().minCoeff();
  const double edge = s.edge.value_or(shortest / 25);
  if (!(edge > 0.0) || !(edge <= 0.25 * shortest))
    throw UserError(Failure::usage,
                    "the edge must be above zero, and at most a quarter of the cell's shortest");
  if (s.thickness != 0.0 && !(s.thickness >= 1.5 * edge))
    throw UserError(Failure::usage, "the thickness must be 0, or at least 1.5 edges");
  const ImplicitShape formula = shape_of_formula(s.formula);
  require_periodic(formula, cell);
  const ImplicitShape at_level = [&](const Vec3& p) { return formula(p) - s.level; };
  // To first order the distance from the surface is the value over the slope.
  const ImplicitShape shell = [&](const Vec3& p) {
    return std::abs(at_level(p)) - 0.5 * s.thickness * gradient(at_level, p, 1e-3 * edge).norm();
  };
  const ImplicitShape& shape = s.thickness > 0.0 ? shell : at_level;
  const auto& periodic = cell.periodic;
  if (periodic[0] || periodic[1] || periodic[2]) return polygonise_in_cell(shape, cell, edge);
  if (!cell.vectors.isDiagonal(1e-12))
    throw UserError(Failure::usage, "the box of a formula that is not periodic must have right angles");
  return polygonise(shape, cell.origin, -cell.origin, edge);
}

}  // namespace nanocarbon::shapes
