// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/solid/advice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/repair/close_holes.h"
#include "nanocarbon/mesh/repair/repair_surface.h"
#include "nanocarbon/mesh/solid/cgal_version.h"
#include "nanocarbon/mesh/solid/repair_solids.h"
#include "nanocarbon/mesh/solid/unite.h"
#include "nanocarbon/mesh/solid/untangle.h"
#include "nanocarbon/mesh/solid/wrap.h"
#include "nanocarbon/mesh/triangulate.h"

namespace nanocarbon::mesh {
namespace {

constexpr double largest_hole = 0.1;  // in diagonals: what is wider may be meant to be open

// Up or down to two digits, so that what is tried is what is printed.
double two_digits(double value, double (*round)(double)) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return std::stod(fmt::format("{:.3g}", round(value / unit) * unit));
}

std::optional<MeshAdvice> try_union(const PolygonSoup& soup, double close_holes) {
  const RepairedSolids repaired = repair_solids(soup, close_holes);
  if (!repaired.manifold) return {};
  const std::string closing = close_holes > 0.0 ? fmt::format("--close-holes {:g} ", close_holes) : "";
  for (const bool untangling : {false, true}) try {
      const Untangled untangled = untangling ? untangle(repaired.mesh) : Untangled{repaired.mesh};
      if (untangling && untangled.components == 0) return {};
      const United united = unite(untangled.mesh);
      if (united.overlapping == 0 || !repair_surface(soup_of(united.mesh)).diagnosis.usable()) return {};
      if (!untangling) return MeshAdvice{closing + "--unite", describe(united)};
      return MeshAdvice{closing + "--untangle --unite", describe(untangled) + "; " + describe(united)};
    } catch (const UserError&) {  // pieces that cross themselves are not united
    }
  return {};
}

std::optional<MeshAdvice> try_untangling(const TriangleMesh& mesh) {
  try {
    const Untangled untangled = untangle(mesh);
    const MeshDiagnosis diagnosis = repair_surface(soup_of(untangled.mesh)).diagnosis;
    if (!diagnosis.usable() || diagnosis.find(MeshProblem::self_intersection)) return {};
    return MeshAdvice{"--untangle", describe(untangled)};
  } catch (const UserError&) {
    return {};
  }
}

bool closed_and_usable(const TriangleMesh& mesh) {
  const MeshDiagnosis diagnosis = repair_surface(soup_of(mesh)).diagnosis;
  return diagnosis.usable() && diagnosis.topology.closed() && !diagnosis.find(MeshProblem::self_intersection);
}

// Of a wrap's two sides, were all of it a wall.
double mean_thickness(const TriangleMesh& wrap) { return 2.0 * signed_volume(wrap) / area(wrap); }

// Whether the ball got in, so that what is wrapped are walls without thickness. Where these meet, wedges that the ball
// does not reach are filled, and the wall is thicker in the mean; but it still has both sides of what there was.
bool is_shell(const TriangleMesh& wrap, double area_before, const WrapSize& size) {
  constexpr double both_sides = 1.5;  // times the area
  const double thickness = mean_thickness(wrap);
  return thickness < 4.0 * size.offset ||
         (thickness < 2.0 * size.size && area(wrap) > both_sides * area_before);
}

std::optional<MeshAdvice> try_wrap(const PolygonSoup& soup, const WrapSize& size, bool accept_shells,
                                   std::string_view name) {
  try {
    const Wrapped wrapped = wrap(soup, size);
    const bool shell = is_shell(wrapped.mesh, area(triangulate(soup).mesh), size);
    if ((!accept_shells && shell) || !closed_and_usable(wrapped.mesh)) return {};
    return MeshAdvice{
        fmt::format("--wrap {}", name),
        describe(wrapped, size) +
            (shell ? fmt::format("; it goes around both sides of the mesh, as a shell that is {:.2g} thick",
                                 mean_thickness(wrapped.mesh))
                   : "")};
  } catch (const UserError&) {
    return {};
  }
}

std::optional<MeshAdvice> advise_union(const PolygonSoup& soup, const RepairedSurface& repaired,
                                       double diagonal) {
  if (!repaired.diagnosis.find(MeshProblem::components_intersect) &&
      !repaired.diagnosis.find(MeshProblem::non_manifold_edge))
    return {};
  if (auto advice = try_union(soup, 0.0)) return advice;
  const std::vector<double> radii = boundary_radii(repaired.mesh);
  if (radii.empty()) return {};
  const double widest = *std::max_element(radii.begin(), radii.end());
  if (!(widest > 0.0) || widest > largest_hole * diagonal) return {};
  return try_union(soup, two_digits(1.01 * widest, std::ceil));
}

}  // namespace

std::optional<MeshAdvice> advise(const PolygonSoup& soup) {
  if (std::string_view(cgal_version()).empty()) return {};
  const RepairedSurface repaired = repair_surface(soup);
  const double diagonal = repaired.diagnosis.box.diagonal();
  if (soup.faces() == 0 || !(diagonal > 0.0)) return {};
  if (repaired.diagnosis.usable() && repaired.diagnosis.find(MeshProblem::self_intersection))
    return try_untangling(repaired.mesh);
  if (repaired.diagnosis.usable()) return {};
  if (auto advice = advise_union(soup, repaired, diagonal)) return advice;
  for (const double part : {50.0, 25.0, 12.5}) {
    const double size = two_digits(diagonal / part, std::round);
    if (auto advice = try_wrap(soup, wrap_size(size), false, fmt::format("{:g}", size))) return advice;
  }
  const double size = two_digits(diagonal / 20.0, std::round), offset = two_digits(0.5 * size, std::round);
  return try_wrap(soup, {size, offset}, true, fmt::format("{:g},{:g}", size, offset));
}

}  // namespace nanocarbon::mesh
