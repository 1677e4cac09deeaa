// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/boundary_curve.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

namespace nanocarbon::annealing {

namespace {

constexpr double spacing = 0.75;  // Angstrom, of the points that stand for a loop
constexpr int window = 2;         // points to either side that one is smoothed over
constexpr int bonds_within_reach = 5;

struct Loop {
  std::vector<Vec3> points, normals;  // side by side: in a cell images follow each other
};

std::uint64_t side(VertexIndex from, VertexIndex to) { return (std::uint64_t{from} << 32) | to; }

// The vertices of each loop, the surface to the left.
std::vector<std::vector<VertexIndex>> loops_of(const TriangleMesh& mesh) {
  std::unordered_set<std::uint64_t> sides;  // looked up only
  for (const Triangle& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) sides.insert(side(t[k], t[(k + 1) % 3]));
  std::unordered_map<VertexIndex, VertexIndex> next;  // looked up only
  std::vector<VertexIndex> starts;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      if (!sides.contains(side(t[(k + 1) % 3], t[k])) && next.emplace(t[k], t[(k + 1) % 3]).second)
        starts.push_back(t[k]);
  std::vector<std::vector<VertexIndex>> loops;
  for (const VertexIndex start : starts) {
    std::vector<VertexIndex> loop;
    VertexIndex at = start;
    for (auto found = next.find(at); found != next.end(); found = next.find(at)) {
      loop.push_back(at);
      at = found->second;
      next.erase(found);
    }
    if (loop.size() > 2) loops.push_back(std::move(loop));
  }
  return loops;
}

// Points at even distances along a loop.
Loop resampled(const TriangleMesh& mesh, std::span<const Vec3> normals,
               std::span<const VertexIndex> vertices) {
  double length = 0;
  const auto step = [&](std::size_t k) {
    return mesh.space.displacement(mesh.points[vertices[k]],
                                   mesh.points[vertices[(k + 1) % vertices.size()]]);
  };
  for (std::size_t k = 0; k < vertices.size(); ++k) length += step(k).norm();
  const auto count = static_cast<std::size_t>(std::max(6.0, std::round(length / spacing)));
  Loop loop;
  double passed = 0;
  Vec3 at = mesh.points[vertices[0]];
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const Vec3 forward = step(k);
    const double here = forward.norm();
    const Vec3 &from = normals[vertices[k]], &to = normals[vertices[(k + 1) % vertices.size()]];
    while (loop.points.size() < count) {
      const double wanted = length * static_cast<double>(loop.points.size()) / static_cast<double>(count);
      if (wanted > passed + here) break;
      const double share = here > 0 ? (wanted - passed) / here : 0;
      loop.points.push_back(at + share * forward);
      loop.normals.push_back((1 - share) * from + share * to);
    }
    at += forward;
    passed += here;
  }
  return loop;
}

}  // namespace

BoundaryCurve::BoundaryCurve(const TriangleMesh& surface, std::span<const Vec3> normals) {
  TriangleMesh pieces;
  pieces.space = surface.space;
  for (const std::vector<VertexIndex>& vertices : loops_of(surface)) {
    const Loop loop = resampled(surface, normals, vertices);
    const auto count = static_cast<int>(loop.points.size());
    const auto first = static_cast<VertexIndex>(pieces.points.size());
    std::vector<Vec3> smooth, normal;
    for (int k = 0; k < count; ++k) {
      Vec3 offset = Vec3::Zero(), sum = Vec3::Zero();
      for (int w = -window; w <= window; ++w) {
        const auto other = static_cast<std::size_t>((k + w + count) % count);
        offset += surface.space.displacement(loop.points[static_cast<std::size_t>(k)], loop.points[other]);
        sum += loop.normals[other];
      }
      smooth.push_back(loop.points[static_cast<std::size_t>(k)] + offset / (2 * window + 1));
      normal.push_back(sum);
    }
    for (int k = 0; k < count; ++k) {
      const auto here = static_cast<std::size_t>(k), next = static_cast<std::size_t>((k + 1) % count);
      const Vec3 away =
          surface.space.displacement(smooth[here], smooth[next]).cross(normal[here] + normal[next]);
      pieces.points.push_back(smooth[here]);
      if (!(away.norm() > 1e-9)) continue;
      const auto a = static_cast<VertexIndex>(first + here), b = static_cast<VertexIndex>(first + next);
      pieces.triangles.push_back({a, b, b});
      outward_.push_back(away.normalized());
    }
  }
  if (!outward_.empty()) nearest_.emplace_back(pieces);
}

TangentPlane BoundaryCurve::plane_at(const Vec3& position) const {
  const mesh::SurfacePoint found = nearest_.front().nearest(position);
  return {found.point, outward_[found.triangle]};
}

std::vector<TangentPlane> boundary_planes(const BoundaryCurve& boundary, const FixedBondGraph& graph,
                                          std::span<const Vec3> positions) {
  std::vector<TangentPlane> planes(positions.size(), {Vec3::Zero(), Vec3::Zero()});
  std::vector<AtomIndex> reached;
  std::vector<bool> seen(positions.size(), false);
  for (AtomIndex a = 0; a < positions.size(); ++a)
    if (graph.open(a)) {
      reached.push_back(a);
      seen[a] = true;
    }
  std::size_t at = 0;
  for (int step = 0; step < bonds_within_reach; ++step)
    for (const std::size_t end = reached.size(); at < end; ++at)
      for (const AtomIndex n : graph.neighbours[reached[at]])
        if (n != no_atom && !seen[n]) {
          seen[n] = true;
          reached.push_back(n);
        }
  for (const AtomIndex a : reached) planes[a] = boundary.plane_at(positions[a]);
  return planes;
}

double mean_reach(std::span<const TangentPlane> planes, const FixedBondGraph& graph,
                  std::span<const Vec3> positions) {
  double sum = 0;
  std::size_t count = 0;
  for (AtomIndex a = 0; a < planes.size(); ++a)
    if (graph.open(a)) {
      sum += height_above(planes[a], positions[a]);
      ++count;
    }
  return count > 0 ? sum / static_cast<double>(count) : -open_atom_depth;
}

double add_boundary_tether(std::span<const TangentPlane> planes, const FixedBondGraph& graph, double reach,
                           std::span<const Vec3> positions, std::span<Vec3> gradient) {
  double energy = 0;
  for (AtomIndex a = 0; a < std::min(planes.size(), graph.inner_count()); ++a) {
    if (!graph.open(a) || planes[a].normal.isZero(0.0)) continue;
    const double off = height_above(planes[a], positions[a]) - reach;
    gradient[a] += boundary_tether * off * planes[a].normal;
    energy += 0.5 * boundary_tether * off * off;
  }
  return energy;
}

}  // namespace nanocarbon::annealing
