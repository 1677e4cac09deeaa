// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/formats/cell_request.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/periodic_mesh.h"
#include "nanocarbon/mesh/repair/sew_in_cell.h"

namespace nanocarbon::mesh {
namespace {

[[noreturn]] void refuse(const std::string& what) { throw UserError(Failure::usage, what); }

void require_usable(const Cell& cell) {
  const Mat3& m = cell.vectors;
  const double lengths = m.col(0).norm() * m.col(1).norm() * m.col(2).norm();
  if (!m.allFinite() || !(std::abs(m.determinant()) > 1e-6 * lengths))
    refuse("the cell is flat: its three edges lie in a plane; give edges that span a volume");
  if (m.determinant() < 0)
    refuse("the cell is left-handed: the volume of its edges a, b, c is negative; exchange two of them");
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      if (i == j || !cell.periodic[static_cast<std::size_t>(i)] ||
          !cell.periodic[static_cast<std::size_t>(j)])
        continue;
      const double tilt = m.col(i).dot(m.col(j)) / m.col(j).squaredNorm();
      if (m.col(i).norm() >= m.col(j).norm() && std::abs(tilt) > 0.5 + 1e-6)
        refuse(fmt::format(
            "the cell is more skewed than necessary: use {} minus {} times {} instead of its edge {}",
            "abc"[i], std::round(tilt), "abc"[j], "abc"[i]));
    }
}

}  // namespace

FieldRequest field_in_cell(FieldRequest field, const CellRequest& request) {
  if (request.periodic)
    field.periodic = *request.periodic;
  else if (request.vectors)
    field.periodic = {true, true, true};
  return field;
}

std::optional<Cell> requested_cell(const CellRequest& request, const PolygonSoup& soup) {
  std::array<bool, 3> periodic = {false, false, false};
  if (request.periodic)
    periodic = *request.periodic;
  else if (request.vectors)
    periodic = {true, true, true};
  else if (soup.cell)
    periodic = soup.cell->periodic;
  if (periodic == std::array<bool, 3>{false, false, false}) return std::nullopt;
  Cell cell;
  if (!request.vectors && soup.cell) {
    cell = *soup.cell;
  } else if (request.vectors) {
    cell.vectors = *request.vectors;
    if (std::abs(cell.vectors.determinant()) > 0.0) {
      std::vector<Vec3> fractional;
      for (const Vec3& p : soup.points) fractional.push_back(cell.vectors.inverse() * p);
      cell.origin = cell.vectors * bounding_box(fractional).low;
    }
  } else {
    const BoundingBox box = bounding_box(soup.points);
    cell.origin = box.low;
    for (int d = 0; d < 3; ++d) {
      const double extent = box.extent()[d];
      if (periodic[static_cast<std::size_t>(d)] && !(extent > 0.0))
        refuse(fmt::format(
            "the mesh has no extent along {}, so its bounding box cannot be its cell; give --cell",
            "xyz"[d]));
      cell.vectors(d, d) = extent > 0.0 ? extent : box.longest_side();
    }
  }
  cell.periodic = periodic;
  require_usable(cell);
  return cell;
}

void drop_findings_of_the_cut(MeshDiagnosis& diagnosis) {
  std::erase_if(diagnosis.findings, [](const MeshFinding& finding) {
    return finding.problem == MeshProblem::components_intersect ||
           finding.problem == MeshProblem::self_intersection ||
           finding.problem == MeshProblem::search_given_up ||
           finding.problem == MeshProblem::duplicate_vertex;
  });
}

TriangleMesh in_cell(const TriangleMesh& mesh, const Cell& cell, const CellRequest& request,
                     std::vector<std::string>& notes) {
  for (std::size_t d = 0; d < 3; ++d)
    if (request.cells[d] > 1 && !cell.periodic[d])
      refuse(fmt::format(
          "the mesh is not periodic along {}, so it cannot be repeated there; give --cells 1 for that edge",
          "abc"[d]));
  SewnSurface sewn = sew_in_cell(mesh, cell, request.match);
  notes.insert(notes.end(), sewn.notes.begin(), sewn.notes.end());
  return repeated(sewn.mesh, request.cells);
}

}  // namespace nanocarbon::mesh
