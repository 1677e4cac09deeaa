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
// Facets this near to one that is measured, which face as it does, are taken to be as it is.
constexpr double patch_radius = 0.6;  // Angstrom
constexpr double patch_cosine = 0.97;
// An enlargement is sought between 1 and this, to this many halvings of its logarithm.
constexpr double largest_enlargement = 1e3;
constexpr int halvings = 10;

//! Whether the surface goes all the way round a centre: a limb does, a plate and its rim do not.
bool goes_round(const Facets& facets, const Vec3& centre, double width) {
  const double reach = 0.9 * width;
  Mat3 spread = Mat3::Zero();
  std::vector<std::uint32_t> near;
  double total = 0;
  facets.mesh.space.for_images([&](const Vec3& shift) {
    const Vec3 from = centre + shift;
    mesh::visit_triangles(
        facets.tree,
        [&](const mesh::BoundingBox& box) { return squared_distance(box, from) < reach * reach; },
        [&](std::uint32_t t) {
          if ((facets.centres[t] - from).squaredNorm() > reach * reach) return;
          if (facets.normals[t].dot(facets.centres[t] - from) < 0) return;  // the far side of another part
          near.push_back(t);
          total += facets.areas[t];
          spread += facets.areas[t] * facets.normals[t] * facets.normals[t].transpose();
        });
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
  Shortfall part, wall, gap;
};

//! For every facet the one that is measured for it: patches grown over neighbours around a first one.
std::vector<std::uint32_t> patches(const crystal::SurfaceGuide& guide, const Facets& facets) {
  constexpr std::uint32_t unassigned = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> measured(facets.centres.size(), unassigned), waiting;
  for (std::uint32_t first = 0; first < measured.size(); ++first) {
    if (measured[first] != unassigned) continue;
    measured[first] = first;
    waiting.assign(1, first);
    while (!waiting.empty()) {
      const std::uint32_t t = waiting.back();
      waiting.pop_back();
      for (crystal::HalfEdgeIndex h = 3 * t; h < 3 * t + 3; ++h) {
        const crystal::HalfEdgeIndex o = guide.table().twin(h);
        if (o == crystal::no_half_edge || measured[o / 3] != unassigned) continue;
        if ((facets.centres[o / 3] - facets.centres[first]).squaredNorm() > patch_radius * patch_radius ||
            facets.normals[o / 3].dot(facets.normals[first]) < patch_cosine)
          continue;
        measured[o / 3] = first;
        waiting.push_back(o / 3);
      }
    }
  }
  return measured;
}

Shortfalls measure(const Facets& facets, const std::vector<std::uint32_t>& measured,
                   const FeatureLimits& limits, unsigned threads) {
  const std::size_t n = facets.centres.size();
  const Shortfall none(n, std::numeric_limits<double>::infinity());
  Shortfalls result{none, none, none};
#pragma omp parallel for schedule(dynamic, 256) num_threads(threads)
  for (std::uint32_t t = 0; t < n; ++t) {
    if (measured[t] != t) continue;
    if (const auto outer = opposite(facets, t, 1, limits.sheet_distance))
      result.gap[t] = outer->distance / limits.sheet_distance;
    const auto inner = opposite(facets, t, -1, 2 * limits.tube_radius);
    if (!inner) continue;
    if (inner->parallel)
      result.gap[t] = std::min(result.gap[t], inner->distance / limits.sheet_distance);
    else if (goes_round(facets, 0.5 * (facets.centres[t] + inner->point), inner->distance))
      result.part[t] = inner->distance / (2 * limits.tube_radius);
    else if (inner->distance < limits.sheet_distance)
      result.wall[t] = inner->distance / limits.sheet_distance;
  }
  for (Shortfall* shortfall : {&result.part, &result.wall, &result.gap})
    for (std::uint32_t t = 0; t < n; ++t) (*shortfall)[t] = (*shortfall)[measured[t]];
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

//! Calls see(region) for every connected region of facets that fall short of a share of what is needed.
template <typename See>
void for_each_region(const crystal::SurfaceGuide& guide, const Shortfall& shortfall, double share,
                     const See& see) {
  std::vector<bool> seen(shortfall.size(), false);
  for (std::uint32_t first = 0; first < shortfall.size(); ++first) {
    if (seen[first] || shortfall[first] >= share) continue;
    std::vector<std::uint32_t> region = {first};
    seen[first] = true;
    for (std::size_t k = 0; k < region.size(); ++k)
      for (crystal::HalfEdgeIndex h = 3 * region[k]; h < 3 * region[k] + 3; ++h) {
        const crystal::HalfEdgeIndex o = guide.table().twin(h);
        if (o == crystal::no_half_edge || seen[o / 3] || shortfall[o / 3] >= share) continue;
        seen[o / 3] = true;
        region.push_back(o / 3);
      }
    see(std::move(region));
  }
}

void collect(const crystal::SurfaceGuide& guide, const Facets& facets, const Shortfall& shortfall,
             FeatureKind kind, const FeatureLimits& limits, std::vector<FeatureProblem>& problems) {
  const double needed = kind == FeatureKind::thin_part ? limits.tube_radius : limits.sheet_distance;
  for_each_region(guide, shortfall, 1, [&](std::vector<std::uint32_t> region) {
    double area = 0;
    for (const std::uint32_t t : region) area += facets.areas[t];
    if (const auto grow = enlargement(facets, shortfall, std::move(region), limits.least_area))
      problems.push_back({kind, facets.centres[grow->facet], needed / grow->ratio, needed, area});
  });
}

//! Boundary loops that are holes too small to stay open.
void collect_holes(const crystal::SurfaceGuide& guide, double needed, std::vector<FeatureProblem>& problems) {
  constexpr double outwards = -0.3;  // mean cosine between what is beside the loop and its middle
  const crystal::CornerTable& table = guide.table();
  const TriangleMesh& mesh = guide.mesh();
  std::vector<bool> seen(table.half_edges(), false);
  for (crystal::HalfEdgeIndex first = 0; first < table.half_edges(); ++first) {
    if (seen[first] || table.twin(first) != crystal::no_half_edge) continue;
    std::vector<crystal::HalfEdgeIndex> loop;
    std::vector<Vec3> points = {
        mesh.points[table.origin(first)]};  // side by side, the first again at the end
    for (crystal::HalfEdgeIndex h = first; !seen[h]; h = table.outgoing(table.target(h))) {
      seen[h] = true;
      loop.push_back(h);
      points.push_back(mesh.space.beside(mesh.points[table.target(h)], points.back()));
    }
    Vec3 centre = Vec3::Zero(), twice_area = Vec3::Zero();
    double length = 0;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const double side = (points[k + 1] - points[k]).norm();
      centre += side * 0.5 * (points[k] + points[k + 1]);
      length += side;
    }
    if ((points.back() - points.front()).norm() > 1e-3 * length) continue;  // it goes round the cell
    centre /= length;
    double towards = 0;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Vec3 &a = points[k], &b = points[k + 1];
      twice_area += (a - centre).cross(b - centre);
      const Vec3 beside = mesh.space.beside(mesh.points[table.apex(loop[k])], a) - a,
                 along = (b - a).normalized();
      towards +=
          (b - a).norm() * (beside - beside.dot(along) * along).normalized().dot((centre - a).normalized());
    }
    const double radius = twice_area.norm() / length;
    if (radius < needed && towards < outwards * length)
      problems.push_back({FeatureKind::small_hole, centre, radius, needed, 0.5 * twice_area.norm()});
  }
}

//! Whether no region of what would still fall short of an enlarged surface would be a problem there. The areas of
//! a region and the ratios at which it counts both grow with the enlargement, so that it drops out of the bound;
//! a larger enlargement leaves smaller regions.
bool would_do(const crystal::SurfaceGuide& guide, const Facets& facets, const Shortfalls& shortfalls,
              const FeatureLimits& limits, double factor) {
  bool fine = true;
  for (const Shortfall* shortfall : {&shortfalls.part, &shortfalls.wall, &shortfalls.gap})
    if (fine)
      for_each_region(guide, *shortfall, 1 / factor, [&](std::vector<std::uint32_t> region) {
        fine = fine && !enlargement(facets, *shortfall, std::move(region), limits.least_area);
      });
  return fine;
}

double least_enlargement(const crystal::SurfaceGuide& guide, const Facets& facets,
                         const Shortfalls& shortfalls, const FeatureLimits& limits, double worst) {
  double low = 1, high = std::min(worst, largest_enlargement);
  for (int i = 0; i < halvings; ++i) {
    const double middle = std::sqrt(low * high);
    (would_do(guide, facets, shortfalls, limits, middle) ? high : low) = middle;
  }
  return high;
}

}  // namespace

std::string_view name(FeatureKind kind) {
  switch (kind) {
    case FeatureKind::thin_part:
      return "thin part";
    case FeatureKind::thin_wall:
      return "thin wall (two sides of one solid)";
    case FeatureKind::narrow_gap:
      return "narrow gap";
    case FeatureKind::small_hole:
      return "small hole";
  }
  return "";
}

FeatureReport check_features(const TriangleMesh& surface, const FeatureLimits& limits, unsigned threads) {
  crystal::SurfaceGuide guide(surface, 0.7 * ring_spacing);
  guide.smooth_normals(0.5 * ring_spacing);
  const Facets facets(guide);
  const Shortfalls shortfalls = measure(facets, patches(guide, facets), limits, threads);
  FeatureReport report;
  report.facets = facets.centres.size();
  collect(guide, facets, shortfalls.part, FeatureKind::thin_part, limits, report.problems);
  collect(guide, facets, shortfalls.wall, FeatureKind::thin_wall, limits, report.problems);
  collect(guide, facets, shortfalls.gap, FeatureKind::narrow_gap, limits, report.problems);
  collect_holes(guide, limits.hole_radius, report.problems);
  std::stable_sort(report.problems.begin(), report.problems.end(),
                   [](const auto& a, const auto& b) { return a.size / a.needed < b.size / b.needed; });
  if (!report.ok()) {
    const FeatureProblem& worst = report.problems.front();
    report.enlargement = least_enlargement(guide, facets, shortfalls, limits, worst.needed / worst.size);
    for (const FeatureProblem& problem : report.problems)
      if (problem.kind == FeatureKind::small_hole)
        report.enlargement = std::max(report.enlargement, problem.needed / problem.size);
  }
  return report;
}

}  // namespace nanocarbon::features
