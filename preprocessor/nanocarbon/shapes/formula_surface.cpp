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
#include "nanocarbon/mesh/mesh_topology.h"
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

// Grids that are so many times as fine as each other are compared, down to this share of the cell's shortest edge.
constexpr double finer = 1.5, finest = 1.0 / 120;

// Where parts of a surface come nearer to each other than the steps of a grid, it joins them. The longest of the edges tried
// that show the surface as the next do, or nothing.
std::optional<double> edge_that_resolves(const ImplicitShape& shape, const Cell& cell, double edge) {
  const double least = finest * cell.vectors.colwise().norm().minCoeff();
  if (edge < finer * least) return edge;
  const auto seen = [&](double with) {
    const mesh::MeshTopology t = mesh::mesh_topology(marched_in_cell(shape, cell, with));
    return std::pair(t.components, t.euler_characteristic);
  };
  for (auto coarse = seen(edge); edge >= finer * least; edge /= finer) {
    const auto fine = seen(edge / finer);
    if (fine == coarse) return edge;
    coarse = fine;
  }
  return {};
}

double resolved(const ImplicitShape& shape, const FormulaSurface& s, const Cell& cell, double edge) {
  const std::optional<double> good = edge_that_resolves(shape, cell, edge);
  if (!good)
    throw UserError(
        Failure::usage,
        fmt::format(
            "the surface where '{}' is {:.6g} comes so near to itself that no grid up to {:.0f} steps "
            "along the cell shows which parts hang together; choose another value with --level",
            s.formula, s.level, 1 / finest));
  if (s.edge && *good < edge)
    throw UserError(
        Failure::usage,
        fmt::format(
            "with edges of {:.4g} parts of the surface that come near each other run into each other; "
            "use --edge {:.4g} or shorter",
            edge, *good));
  return *good;
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
  if (periodic[0] && periodic[1] && periodic[2])
    return polygonise_in_cell(shape, cell, resolved(shape, s, cell, edge));
  if (periodic[0] || periodic[1] || periodic[2]) return polygonise_in_cell(shape, cell, edge);
  if (!cell.vectors.isDiagonal(1e-12))
    throw UserError(Failure::usage, "the box of a formula that is not periodic must have right angles");
  return polygonise(shape, cell.origin, -cell.origin, edge);
}

}  // namespace nanocarbon::shapes
