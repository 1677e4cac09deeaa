// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/features/make_room.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "nanocarbon/remeshing/features/opposite_sides.h"

namespace nanocarbon::features {
namespace {

constexpr double ring_spacing = 2.46;  // Angstrom, of rings in graphene
constexpr double farthest = 0.6;       // Angstrom that a side moves
constexpr double least = 0.05;         // Angstrom below which nothing need move
// Angstrom around a thin place that go along.
constexpr double surroundings = 2.5;

//! What each facet lacks to one side, halved.
std::vector<double> missing(const Facets& facets, double side, double distance, unsigned threads) {
  std::vector<double> half(facets.centres.size(), 0.0);
#pragma omp parallel for schedule(dynamic, 256) num_threads(threads)
  for (std::uint32_t t = 0; t < half.size(); ++t)
    if (const auto found = opposite(facets, t, side, distance))
      half[t] = std::min(farthest, 0.5 * (distance - found->distance));
  return half;
}

//! From facets to vertices, and on to their surroundings: the mean of the neighbours wherever that is more.
std::vector<double> spread_out(const TriangleMesh& mesh, const std::vector<double>& of_facet) {
  std::vector<double> own(mesh.points.size(), 0.0);
  double edges = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const VertexIndex v = mesh.triangles[t][k];
      own[v] = std::max(own[v], of_facet[t]);
      edges += mesh.space.displacement(mesh.points[v], mesh.points[mesh.triangles[t][(k + 1) % 3]]).norm();
    }
  const double edge = edges / static_cast<double>(3 * mesh.triangles.size());
  const int rounds = static_cast<int>(std::clamp(std::pow(surroundings / edge, 2), 3.0, 40.0));
  std::vector<double> shift = own;
  for (int round = 0; round < rounds; ++round) {
    std::vector<double> sum(shift.size(), 0.0), count(shift.size(), 0.0);
    for (const Triangle& t : mesh.triangles)
      for (int k = 0; k < 3; ++k) {
        sum[t[k]] += shift[t[(k + 1) % 3]] + shift[t[(k + 2) % 3]];
        count[t[k]] += 2;
      }
    for (std::size_t v = 0; v < shift.size(); ++v)
      if (count[v] > 0) shift[v] = std::max(0.5 * (own[v] + shift[v]), sum[v] / count[v]);
  }
  return shift;
}

}  // namespace

std::optional<TriangleMesh> with_room_for_sheets(const TriangleMesh& surface, double distance,
                                                 unsigned threads) {
  crystal::SurfaceGuide guide(surface, 0.7 * ring_spacing);
  guide.smooth_normals(0.5 * ring_spacing);
  const Facets facets(guide);
  const std::vector<double> inner = missing(facets, -1, distance, threads),
                            outer = missing(facets, 1, distance, threads);
  const auto some = [](const std::vector<double>& half) {
    return std::any_of(half.begin(), half.end(), [](double h) { return h > least; });
  };
  if (!some(inner) && !some(outer)) return std::nullopt;
  const std::vector<double> outwards = spread_out(guide.mesh(), inner),
                            inwards = spread_out(guide.mesh(), outer);
  TriangleMesh roomy = guide.mesh();
  std::vector<Vec3> normals(roomy.points.size(), Vec3::Zero());
  for (std::uint32_t t = 0; t < roomy.triangles.size(); ++t)
    for (const VertexIndex v : roomy.triangles[t]) normals[v] += facets.areas[t] * facets.normals[t];
  for (std::size_t v = 0; v < normals.size(); ++v)
    if (normals[v].norm() > 0) roomy.points[v] += (outwards[v] - inwards[v]) * normals[v].normalized();
  return roomy;
}

}  // namespace nanocarbon::features
