// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/crystal/particle_annealing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "nanocarbon/remeshing/crystal/flips.h"
#include "nanocarbon/remeshing/crystal/soundness.h"
#include "nanocarbon/remeshing/crystal/tiling_moves.h"

namespace nanocarbon::crystal {
namespace {

// In units of spacing, pair energy and particle mass. The stiffest mode of the crystal has a period of about
// 0.2.
constexpr double time_step = 0.012;
constexpr int steps_between_settling = 8;
constexpr int settlings_between_unfolding = 25;
constexpr double friction = 1.0;
constexpr double longest_step = 0.05;

struct Ends {
  VertexIndex a, b;
};

void list_edges(const CornerTable& table, std::vector<Ends>& edges) {
  edges.clear();
  for (HalfEdgeIndex h = 0; h < table.half_edges(); ++h)
    if (table.is_edge(h)) edges.push_back({table.origin(h), table.target(h)});
}

//! Forces of the pair energy 2 (a/r)^12 - 4 (a/r)^6, in units of energy over spacing.
void pair_forces(const std::vector<Ends>& edges, const Space& space, const std::vector<Vec3>& points,
                 double spacing, std::vector<Vec3>& forces) {
  std::fill(forces.begin(), forces.end(), Vec3::Zero());
  const double a2 = spacing * spacing;
  for (const Ends& e : edges) {
    const Vec3 d = space.displacement(points[e.a], points[e.b]);
    const double s = std::min(a2 / std::max(d.squaredNorm(), 1e-300), 2.5);
    const double s3 = s * s * s;
    const Vec3 f = (24 * (s3 * s3 - s3) * s / spacing) * d;
    forces[e.a] -= f;
    forces[e.b] += f;
  }
}

//! Forces of springs with energy 1/2 (length / spacing - 1)^2.
void springs(const std::vector<Ends>& edges, const Space& space, const std::vector<Vec3>& points,
             double spacing, std::vector<Vec3>& forces) {
  std::fill(forces.begin(), forces.end(), Vec3::Zero());
  for (const Ends& e : edges) {
    const Vec3 d = space.displacement(points[e.a], points[e.b]);
    const double length = std::max(d.norm(), 1e-300);
    const Vec3 f = (1 / spacing - 1 / length) * d;
    forces[e.a] += f;
    forces[e.b] -= f;
  }
}

//! Three uniform numbers of variance 1 from one draw.
Vec3 uniform_noise(std::mt19937_64& random) {
  const std::uint64_t bits = random();
  constexpr double scale = 2 * 1.7320508075688772 / 2097152.0;
  const auto part = [&](int shift) {
    return (static_cast<double>((bits >> shift) & 0x1fffff) - 1048575.5) * scale;
  };
  return {part(0), part(21), part(42)};
}

struct Saved {
  std::vector<Vec3> points, normals;
  std::vector<std::uint32_t> places;
};

//! Puts every particle back on the surface; where that turned a triangle, its corners go back to where they
//! were.
std::size_t settle_or_restore(Tiling& tiling, Saved& before, std::vector<Vec3>& velocities) {
  const CornerTable& table = tiling.table;
  for (VertexIndex v = 0; v < table.vertices(); ++v) place_vertex(tiling, v, tiling.points[v]);
  std::vector<VertexIndex> restored;
  const auto was = [&](VertexIndex v) {
    return Corner{before.points[v], before.normals[v],
                  table.on_boundary(v) ? before.places[v] / 3 : before.places[v]};
  };
  // What was turned before need not go back: it would never come free.
  const auto turned = [&](HalfEdgeIndex h) {
    const VertexIndex a = table.origin(h), b = table.origin(h + 1), c = table.origin(h + 2);
    const double now = facing(tiling, a, b, c);
    return now < turned_below && now < facing(*tiling.guide, was(a), was(b), was(c));
  };
  const auto restore = [&](VertexIndex v) {
    if (tiling.points[v] == before.points[v]) return false;
    tiling.points[v] = before.points[v];
    tiling.normals[v] = before.normals[v];
    tiling.places[v] = before.places[v];
    velocities[v].setZero();
    restored.push_back(v);
    return true;
  };
  const auto normal = [&](const std::vector<Vec3>& points, HalfEdgeIndex h) {
    return unit_normal(tiling.space(), points[table.origin(h)], points[table.target(h)],
                       points[table.apex(h)]);
  };
  const auto creased = [&](HalfEdgeIndex h) {
    const HalfEdgeIndex o = table.twin(h);
    if (o == no_half_edge) return false;
    const double now = normal(tiling.points, h).dot(normal(tiling.points, o));
    return now < creased_below && now < normal(before.points, h).dot(normal(before.points, o));
  };
  std::vector<HalfEdgeIndex> suspects;
  for (HalfEdgeIndex h = 0; h < table.half_edges(); h += 3)
    if (turned(h)) suspects.push_back(h);
  for (HalfEdgeIndex h = 0; h < table.half_edges(); ++h)
    if (table.is_edge(h) && creased(h))
      suspects.insert(suspects.end(), {h - h % 3, table.twin(h) - table.twin(h) % 3});
  while (!suspects.empty()) {
    std::vector<HalfEdgeIndex> affected;
    for (const HalfEdgeIndex h : suspects)
      for (int k = 0; k < 3; ++k) {
        const VertexIndex v = table.origin(h + static_cast<HalfEdgeIndex>(k));
        if (restore(v)) table.for_outgoing(v, [&](HalfEdgeIndex o) { affected.push_back(o - o % 3); });
      }
    std::sort(affected.begin(), affected.end());
    affected.erase(std::unique(affected.begin(), affected.end()), affected.end());
    suspects.clear();
    for (const HalfEdgeIndex h : affected)
      if (turned(h) || creased(h) || creased(h + 1) || creased(h + 2)) suspects.push_back(h);
  }
  // A sliver that is pressed on would be set back for ever; in the middle of its neighbours a vertex is free
  // again.
  for (const VertexIndex v : restored) relax_vertex(tiling, v, 0.5);
  return restored.size();
}

void remember(const Tiling& tiling, Saved& saved) {
  saved.points = tiling.points;
  saved.normals = tiling.normals;
  saved.places = tiling.places;
}

}  // namespace

AnnealingResult anneal_particles(Tiling& tiling, double spacing, const AnnealingSchedule& schedule) {
  AnnealingResult result;
  std::mt19937_64 random(schedule.seed);
  const std::size_t n = tiling.points.size();
  std::vector<Vec3> velocities(n), forces(n);
  for (Vec3& v : velocities) v = std::sqrt(schedule.hot) * uniform_noise(random);
  std::vector<Ends> edges;
  list_edges(tiling.table, edges);
  Saved before;
  remember(tiling, before);
  const double keep = std::exp(-friction * time_step * steps_between_settling);
  for (std::size_t step = 0; step < schedule.steps; ++step) {
    pair_forces(edges, tiling.space(), tiling.points, spacing, forces);
    for (std::size_t i = 0; i < n; ++i) {
      Vec3& v = velocities[i];
      v += time_step * forces[i];
      const Vec3& normal = tiling.normals[i];
      v -= v.dot(normal) * normal;
      const double speed = v.norm() * time_step;
      if (speed > longest_step) v *= longest_step / speed;
      tiling.points[i] += (time_step * spacing) * v;
    }
    if ((step + 1) % steps_between_settling != 0 && step + 1 != schedule.steps) continue;
    result.set_back += settle_or_restore(tiling, before, velocities);
    const std::size_t flips = flip_to_delaunay(tiling, 2);
    result.flips += flips;
    if ((step + 1) % (steps_between_settling * settlings_between_unfolding) == 0) unfold(tiling, 1);
    list_edges(tiling.table, edges);
    remember(tiling, before);
    const double progress = static_cast<double>(step + 1) / static_cast<double>(schedule.steps);
    const double temperature = schedule.hot + (schedule.cold - schedule.hot) * progress;
    const double kick = std::sqrt(temperature * (1 - keep * keep));
    for (Vec3& v : velocities) v = keep * v + kick * uniform_noise(random);
  }
  return result;
}

double even_edges(Tiling& tiling, double spacing, std::size_t steps) {
  const std::size_t n = tiling.points.size();
  std::vector<Vec3> velocities(n, Vec3::Zero()), forces(n);
  std::vector<Ends> edges;
  list_edges(tiling.table, edges);
  Saved before;
  remember(tiling, before);
  double largest = 0;
  double dt = 0.2;
  for (std::size_t step = 0; step < steps; ++step) {
    springs(edges, tiling.space(), tiling.points, spacing, forces);
    // FIRE (Bitzek et al. 2006) on the tangential forces.
    double power = 0, vv = 0, ff = 0;
    largest = 0;
    for (std::size_t i = 0; i < n; ++i) {
      forces[i] -= forces[i].dot(tiling.normals[i]) * tiling.normals[i];
      velocities[i] -= velocities[i].dot(tiling.normals[i]) * tiling.normals[i];
      power += forces[i].dot(velocities[i]);
      vv += velocities[i].squaredNorm();
      ff += forces[i].squaredNorm();
      largest = std::max(largest, forces[i].squaredNorm());
    }
    if (power < 0) {
      dt = std::max(0.5 * dt, 0.05);
      std::fill(velocities.begin(), velocities.end(), Vec3::Zero());
    } else {
      dt = std::min(1.05 * dt, 0.6);
      const double mix = ff > 0 ? 0.1 * std::sqrt(vv / ff) : 0;
      for (std::size_t i = 0; i < n; ++i) velocities[i] = 0.9 * velocities[i] + mix * forces[i];
    }
    for (std::size_t i = 0; i < n; ++i) {
      velocities[i] += dt * forces[i];
      tiling.points[i] += (dt * spacing) * velocities[i];
    }
    if ((step + 1) % 4 == 0 || step + 1 == steps) {
      settle_or_restore(tiling, before, velocities);
      remember(tiling, before);
    }
  }
  return std::sqrt(largest);
}

}  // namespace nanocarbon::crystal
