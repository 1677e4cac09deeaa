// SPDX-License-Identifier: GPL-2.0-or-later
#include "cell_options.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "nanocarbon/core/error.h"
#include "number_checks.h"

namespace nanocarbon::cli {
namespace {

constexpr double degree = std::numbers::pi / 180;

CLI::Validator directions() {
  return CLI::Validator(
      [](std::string& value) {
        const bool known =
            value == "none" || (!value.empty() && value.find_first_not_of("xyz") == value.npos);
        return known ? std::string()
                     : fmt::format("{}: give directions, such as xyz, xy or z; or none", value);
      },
      "");
}

// a along x, b in the xy plane, as LAMMPS and crystallographers have it.
Mat3 vectors_of(double a, double b, double c, double alpha, double beta, double gamma) {
  const auto cosine = [](double angle) { return angle == 90 ? 0.0 : std::cos(angle * degree); };
  const double ca = cosine(alpha), cb = cosine(beta), cg = cosine(gamma), sg = std::sqrt(1 - cg * cg);
  const double cy = (ca - cb * cg) / sg, squared = 1 - cb * cb - cy * cy;
  if (!(squared > 1e-9))
    throw UserError(
        Failure::usage,
        fmt::format("no cell has the angles {}, {} and {}; give those between b and c, a and c, a "
                    "and b, in degrees",
                    alpha, beta, gamma));
  Mat3 vectors;
  vectors << a, b * cg, c * cb, 0, b * sg, c * cy, 0, 0, c * std::sqrt(squared);
  return vectors;
}

}  // namespace

void add_cell_options(CLI::App& sub, CellOptions& o) {
  auto* group =
      sub.add_option_group("Cell", "The periodic cell of the mesh; by default the one given in its file");
  group
      ->add_option("--periodic", o.periodic,
                   "Directions in which the mesh is periodic, along the edges a, b, c of the cell: xyz, xy, "
                   "z, ...; none: free space, whatever the file says")
      ->check(directions())
      ->type_name("XYZ");
  group
      ->add_option(
          "--cell", o.cell,
          "Lengths a,b,c of the cell's edges in mesh units, which the angles alpha,beta,gamma in degrees may "
          "follow; or the edges as nine numbers. By default the cell given in the file, or the bounding box")
      ->expected(3, 9)
      ->delimiter(',')
      ->type_name("A,B,C");
  group->add_option("--cells", o.cells, "Treat this many cells as one, along every edge or along each (1)")
      ->expected(1, 3)
      ->delimiter(',')
      ->check(between(1, 1000))
      ->type_name("N");
  group
      ->add_option("--match", o.match,
                   "Distance within which boundary vertices at opposite faces are the same, as a fraction of "
                   "the mean edge")
      ->check(between(0.0, 0.1))
      ->capture_default_str();
}

void add_period_options(CLI::App& sub, CellOptions& o) {
  o.name = "--period";
  sub.add_option("--period", o.cell,
                 "Edge of the cube that the surface repeats itself in, mesh units; or the edges a,b,c of a "
                 "cell, with the "
                 "angles alpha,beta,gamma in degrees; or the edges as nine numbers (6.283, 2 pi)")
      ->expected(1, 9)
      ->delimiter(',')
      ->type_name("A[,B,C]");
  sub.add_option(
         "--periodic", o.periodic,
         "Directions in which it does: xyz (default), xy, z, ... of the edges a, b, c; in others the period "
         "is the length of the box. none: free space, closed off at the box")
      ->check(directions())
      ->type_name("XYZ");
}

mesh::CellRequest cell_request(const CellOptions& o) {
  mesh::CellRequest request;
  if (o.periodic) {
    std::array<bool, 3> periodic = {false, false, false};
    for (const char c : *o.periodic == "none" ? std::string() : *o.periodic)
      periodic[static_cast<std::size_t>(c - 'x')] = true;
    request.periodic = periodic;
  }
  std::vector<double> n = o.cell;
  if (n.size() == 1) n = {n[0], n[0], n[0]};  // a cube
  for (std::size_t k = 0; k < std::min<std::size_t>(n.size(), 6) && n.size() < 9; ++k)
    if (!(n[k] > 0))
      throw UserError(Failure::usage, fmt::format("{}: {} is not a length or an angle above zero", o.name, n[k]));
  if (n.size() == 3) request.vectors = Vec3(n[0], n[1], n[2]).asDiagonal();
  if (n.size() == 6) request.vectors = vectors_of(n[0], n[1], n[2], n[3], n[4], n[5]);
  if (n.size() == 9) {
    request.vectors.emplace();
    *request.vectors << n[0], n[3], n[6], n[1], n[4], n[7], n[2], n[5], n[8];
  }
  if (!n.empty() && !request.vectors)
    throw UserError(Failure::usage,
                    fmt::format("{}: {} numbers are not a cell: give 3, 6 or 9", o.name, n.size()));
  request.cells = cells_each_way(o.cells);
  request.match = o.match;
  return request;
}

std::array<int, 3> cells_each_way(const std::vector<int>& cells) {
  if (cells.empty()) return {1, 1, 1};
  if (cells.size() == 1) return {cells[0], cells[0], cells[0]};
  if (cells.size() == 2)
    throw UserError(Failure::usage, "--cells: give one number for all edges of the cell, or three");
  return {cells[0], cells[1], cells[2]};
}

std::string describe_cell(const Cell& cell) {
  const Mat3& m = cell.vectors;
  const auto angle = [&](int i, int j) {
    return std::acos(m.col(i).dot(m.col(j)) / (m.col(i).norm() * m.col(j).norm())) / degree;
  };
  std::string directions;
  for (std::size_t d = 0; d < 3; ++d)
    if (cell.periodic[d]) directions += "abc"[d];
  return fmt::format("{:.6g} x {:.6g} x {:.6g}, angles {:.5g}, {:.5g}, {:.5g}, periodic along {}",
                     m.col(0).norm(), m.col(1).norm(), m.col(2).norm(), angle(1, 2), angle(0, 2), angle(0, 1),
                     directions);
}

}  // namespace nanocarbon::cli
