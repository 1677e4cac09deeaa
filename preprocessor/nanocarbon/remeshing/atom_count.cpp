#include "nanocarbon/remeshing/atom_count.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "nanocarbon/core/error.h"

namespace nanocarbon {

double scale_for_atoms(const TriangleMesh& surface, std::size_t atoms, const ThesisOptions& options) {
  double area = 0.0;
  for (const auto& [a, b, c] : surface.triangles)
    area += 0.5 * (surface.points[b] - surface.points[a]).cross(surface.points[c] - surface.points[a]).norm();
  if (!(area > 0.0) || !std::isfinite(area))
    throw UserError(Failure::unsuitable, "the surface has no area: it cannot be scaled to a number of atoms");
  const double m = edge_interval(options.min_bond, options.max_bond).mean();
  const double area_per_atom = 0.25 * std::numbers::sqrt3 * m * m;
  return std::sqrt(static_cast<double>(atoms) * area_per_atom / area);
}

TriangleMesh scaled(TriangleMesh surface, double scale) {
  for (Vec3& p : surface.points) p *= scale;
  return surface;
}

}  // namespace nanocarbon
