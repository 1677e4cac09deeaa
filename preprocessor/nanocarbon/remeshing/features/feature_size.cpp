// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/features/feature_size.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "nanocarbon/remeshing/features/opposite_sides.h"

namespace nanocarbon::features {
namespace {

// An equilateral triangle for each atom has this edge, sqrt(3) bonds of 1.42 Angstrom.
constexpr double ring_spacing = 2.46;
//! Whether the surface goes all the way round a centre: a limb does, a plate and its rim do not.
bool goes_round(const Facets& facets, const Vec3& centre, double width) {
  const double reach = 0.9 * width;
  Mat3 spread = Mat3::Zero();
  std::vector<std::uint32_t> near;
  double total = 0;
  mesh::visit_triangles(
      facets.tree,
      [&](const mesh::BoundingBox& box) { return squared_distance(box, centre) < reach * reach; },
      [&](std::uint32_t t) {
        if ((facets.centres[t] - centre).squaredNorm() > reach * reach) return;
        if (facets.normals[t].dot(facets.centres[t] - centre) < 0) return;  // the far side of another part
        near.push_back(t);
        total += facets.areas[t];
        spread += facets.areas[t] * facets.normals[t] * facets.normals[t].transpose();
      });
  if (total <= 0) return false;
  const Eigen::SelfAdjointEigenSolver<Mat3> axes(spread / total);
  if (axes.eigenvalues()[1] < 0.2) return false;
  const Vec3 across = axes.eigenvectors().col(1);
  double one = 0, other = 0;
  for (const std::uint32_t t : near) {
    const double c = facets.normals[t].dot(across);
    if (c > 0.5) one += facets.areas[t];
    if (c < -0.5) other += facets.areas[t];
  }
  return std::min(one, other) > 0.1 * total;
}

//! Size over needed size of every facet that is too small in one way; infinity elsewhere.
using Shortfall = std::vector<double>;

struct Shortfalls {
  Shortfall part, plate, gap;
};

Shortfalls measure(const Facets& facets, const FeatureLimits& limits, unsigned threads) {
  const std::size_t n = facets.centres.size();
  const Shortfall none(n, std::numeric_limits<double>::infinity());
  Shortfalls result{none, none, none};
#pragma omp parallel for schedule(dynamic, 256) num_threads(threads)
  for (std::uint32_t t = 0; t < n; ++t) {
    if (const auto outer = opposite(facets, t, 1, limits.sheet_distance))
      result.gap[t] = outer->distance / limits.sheet_distance;
    const auto inner = opposite(facets, t, -1, 2 * limits.tube_radius);
    if (!inner) continue;
    if (inner->parallel)
      result.gap[t] = std::min(result.gap[t], inner->distance / limits.sheet_distance);
    else if (goes_round(facets, 0.5 * (facets.centres[t] + inner->point), inner->distance))
      result.part[t] = inner->distance / (2 * limits.tube_radius);
    else if (inner->distance < limits.sheet_distance)
      result.plate[t] = inner->distance / limits.sheet_distance;
  }
  return result;
}

//! The ratio to enlarge by, so that what is still too small of a region has no more than the least area.
struct Enlargement {
  double ratio = 1;
  std::uint32_t facet = 0;
};

std::optional<Enlargement> enlargement(const Facets& facets, const Shortfall& shortfall,
                                       std::vector<std::uint32_t> region, double least_area) {
  std::sort(region.begin(), region.end(), [&](std::uint32_t a, std::uint32_t b) {
    return shortfall[a] != shortfall[b] ? shortfall[a] < shortfall[b] : a < b;
  });
  double area = 0;
  for (const std::uint32_t t : region) {
    area += facets.areas[t];
    const double ratio = 1 / shortfall[t];
    if (area * ratio * ratio > least_area) return Enlargement{ratio, t};
  }
  return std::nullopt;
}

void collect(const crystal::SurfaceGuide& guide, const Facets& facets, const Shortfall& shortfall,
             FeatureKind kind, const FeatureLimits& limits, std::vector<FeatureProblem>& problems) {
  const double needed = kind == FeatureKind::thin_part ? limits.tube_radius : limits.sheet_distance;
  std::vector<bool> seen(shortfall.size(), false);
  for (std::uint32_t first = 0; first < shortfall.size(); ++first) {
    if (seen[first] || shortfall[first] >= 1) continue;
    std::vector<std::uint32_t> region = {first};
    seen[first] = true;
    double area = 0;
    for (std::size_t k = 0; k < region.size(); ++k) {
      area += facets.areas[region[k]];
      for (crystal::HalfEdgeIndex h = 3 * region[k]; h < 3 * region[k] + 3; ++h) {
        const crystal::HalfEdgeIndex o = guide.table().twin(h);
        if (o == crystal::no_half_edge || seen[o / 3] || shortfall[o / 3] >= 1) continue;
        seen[o / 3] = true;
        region.push_back(o / 3);
      }
    }
    if (const auto grow = enlargement(facets, shortfall, std::move(region), limits.least_area))
      problems.push_back({kind, facets.centres[grow->facet], needed / grow->ratio, needed, area});
  }
}

}  // namespace

std::string_view name(FeatureKind kind) {
  switch (kind) {
    case FeatureKind::thin_part:
      return "thin part";
    case FeatureKind::thin_plate:
      return "thin plate";
    case FeatureKind::narrow_gap:
      return "narrow gap";
  }
  return "";
}

FeatureReport check_features(const TriangleMesh& surface, const FeatureLimits& limits, unsigned threads) {
  crystal::SurfaceGuide guide(surface, 0.7 * ring_spacing);
  guide.smooth_normals(0.5 * ring_spacing);
  const Facets facets(guide);
  const Shortfalls shortfalls = measure(facets, limits, threads);
  FeatureReport report;
  collect(guide, facets, shortfalls.part, FeatureKind::thin_part, limits, report.problems);
  collect(guide, facets, shortfalls.plate, FeatureKind::thin_plate, limits, report.problems);
  collect(guide, facets, shortfalls.gap, FeatureKind::narrow_gap, limits, report.problems);
  std::stable_sort(report.problems.begin(), report.problems.end(),
                   [](const auto& a, const auto& b) { return a.size / a.needed < b.size / b.needed; });
  return report;
}

}  // namespace nanocarbon::features
