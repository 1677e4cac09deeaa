// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/crystal/particle_annealing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "nanocarbon/core/chunks.h"
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

//! Neighbours of each vertex, in the order of the half-edges that stand for the edges.
struct Neighbours {
  std::vector<std::uint32_t> offsets;
  std::vector<VertexIndex> vertices;

  std::span<const VertexIndex> of(std::size_t v) const {
    return {vertices.data() + offsets[v], vertices.data() + offsets[v + 1]};
  }
};

void list_neighbours(const Tiling& tiling, Neighbours& list) {
  const CornerTable& table = tiling.table;
  list.offsets.assign(1, 0);
  for (VertexIndex v = 0; v < table.vertices(); ++v)
    list.offsets.push_back(list.offsets.back() +
                           static_cast<std::uint32_t>(table.vertex_alive(v) ? table.valence(v) : 0));
  list.vertices.resize(list.offsets.back());
  for_chunks(tiling.team, table.vertices(), [&](std::size_t begin, std::size_t end) {
    std::vector<std::pair<HalfEdgeIndex, VertexIndex>> edges;
    for (auto v = static_cast<VertexIndex>(begin); v < end; ++v) {
      if (!table.vertex_alive(v)) continue;
      edges.clear();
      table.for_outgoing(v, [&](HalfEdgeIndex h) {
        edges.emplace_back(std::min(h, table.twin(h)), table.target(h));
        if (const HalfEdgeIndex last = CornerTable::previous(h); table.twin(last) == no_half_edge)
          edges.emplace_back(last, table.apex(h));
      });
      std::sort(edges.begin(), edges.end());
      for (std::size_t k = 0; k < edges.size(); ++k) list.vertices[list.offsets[v] + k] = edges[k].second;
    }
  });
}

//! Forces of the pair energy 2 (a/r)^12 - 4 (a/r)^6, in units of energy over spacing.
void pair_forces(const Neighbours& neighbours, const Tiling& tiling, double spacing,
                 std::vector<Vec3>& forces) {
  const Space& space = tiling.space();
  const std::vector<Vec3>& points = tiling.points;
  const double a2 = spacing * spacing;
  for_chunks(tiling.team, points.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      Vec3 force = Vec3::Zero();
      for (const VertexIndex j : neighbours.of(i)) {
        const Vec3 d = space.displacement(points[i], points[j]);
        const double s = std::min(a2 / std::max(d.squaredNorm(), 1e-300), 2.5);
        const double s3 = s * s * s;
        force -= (24 * (s3 * s3 - s3) * s / spacing) * d;
      }
      forces[i] = force;
    }
  });
}

//! Forces of springs with energy 1/2 (length / spacing - 1)^2.
void springs(const Neighbours& neighbours, const Tiling& tiling, double spacing, std::vector<Vec3>& forces) {
  const Space& space = tiling.space();
  const std::vector<Vec3>& points = tiling.points;
  for_chunks(tiling.team, points.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      Vec3 force = Vec3::Zero();
      for (const VertexIndex j : neighbours.of(i)) {
        const Vec3 d = space.displacement(points[i], points[j]);
        const double length = std::max(d.norm(), 1e-300);
        force += (1 / spacing - 1 / length) * d;
      }
      forces[i] = force;
    }
  });
}

//! Three uniform numbers of variance 1 from the bits of one draw.
Vec3 uniform_noise(std::uint64_t bits) {
  constexpr double scale = 2 * 1.7320508075688772 / 2097152.0;
  const auto part = [&](int shift) {
    return (static_cast<double>((bits >> shift) & 0x1fffff) - 1048575.5) * scale;
  };
  return {part(0), part(21), part(42)};
}

//! Multiplies velocities and adds noise.
void kick(std::vector<Vec3>& velocities, double keep, double strength, std::mt19937_64& random,
          ThreadTeam* team) {
  std::vector<std::uint64_t> draws(velocities.size());
  for (std::uint64_t& draw : draws) draw = random();
  for_chunks(team, velocities.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      velocities[i] = keep * velocities[i] + strength * uniform_noise(draws[i]);
  });
}

struct Saved {
  std::vector<Vec3> points, normals;
  std::vector<std::uint32_t> places;
};

//! Triangles, by their first half-edges, that a move has turned or folded over an edge.
class TurnedTriangles {
 public:
  TurnedTriangles(const Tiling& tiling, const Saved& before) : tiling_(tiling), before_(before) {}

  // What was turned before need not go back: it would never come free.
  bool turned(HalfEdgeIndex h) const {
    const CornerTable& table = tiling_.table;
    const VertexIndex a = table.origin(h), b = table.origin(h + 1), c = table.origin(h + 2);
    const double now = facing(tiling_, a, b, c);
    return now < turned_below && now < facing(*tiling_.guide, was(a), was(b), was(c));
  }

  bool creased(HalfEdgeIndex h) const {
    return tiling_.table.twin(h) != no_half_edge &&
           creased(h, normal(tiling_.points, h), normal(tiling_.points, tiling_.table.twin(h)));
  }

  std::vector<HalfEdgeIndex> all() const {
    const CornerTable& table = tiling_.table;
    const std::size_t triangles = table.half_edges() / 3;
    std::vector<Vec3> normals(triangles);
    std::vector<std::vector<HalfEdgeIndex>> found(chunks_of(triangles)), folded(chunks_of(triangles));
    for_chunks(tiling_.team, triangles, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t) {
        const auto h = static_cast<HalfEdgeIndex>(3 * t);
        normals[t] = normal(tiling_.points, h);
        if (!surely_not_turned(h, normals[t]) && turned(h)) found[begin / chunk_size].push_back(h);
      }
    });
    for_chunks(tiling_.team, triangles, [&](std::size_t begin, std::size_t end) {
      for (auto h = static_cast<HalfEdgeIndex>(3 * begin); h < 3 * end; ++h) {
        const HalfEdgeIndex o = table.twin(h);
        if (o == no_half_edge || o < h || !creased(h, normals[h / 3], normals[o / 3])) continue;
        folded[begin / chunk_size].insert(folded[begin / chunk_size].end(), {h - h % 3, o - o % 3});
      }
    });
    std::vector<HalfEdgeIndex> result;
    for (const auto* lists : {&found, &folded})
      for (const std::vector<HalfEdgeIndex>& list : *lists)
        result.insert(result.end(), list.begin(), list.end());
    return result;
  }

 private:
  Corner was(VertexIndex v) const {
    return {before_.points[v], before_.normals[v],
            tiling_.table.on_boundary(v) ? before_.places[v] / 3 : before_.places[v]};
  }
  Vec3 normal(const std::vector<Vec3>& points, HalfEdgeIndex h) const {
    const CornerTable& table = tiling_.table;
    return unit_normal(tiling_.space(), points[table.origin(h)], points[table.target(h)],
                       points[table.apex(h)]);
  }
  bool creased(HalfEdgeIndex h, const Vec3& left, const Vec3& right) const {
    const double now = left.dot(right);
    return now < creased_below &&
           now < normal(before_.points, h).dot(normal(before_.points, tiling_.table.twin(h)));
  }
  // Without a root, where the corners' normals are alike.
  bool surely_not_turned(HalfEdgeIndex h, const Vec3& normal) const {
    const CornerTable& table = tiling_.table;
    const Vec3 sum = tiling_.normals[table.origin(h)] + tiling_.normals[table.origin(h + 1)] +
                     tiling_.normals[table.origin(h + 2)];
    return sum.squaredNorm() > 2 * 2 && normal.dot(sum) > 3.01 * turned_below;
  }

  const Tiling& tiling_;
  const Saved& before_;
};

//! Puts every particle back on the surface; where that turned a triangle, its corners go back to where they
//! were.
std::size_t settle_or_restore(Tiling& tiling, Saved& before, std::vector<Vec3>& velocities) {
  const CornerTable& table = tiling.table;
  for_chunks(tiling.team, table.vertices(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v)
      place_vertex(tiling, static_cast<VertexIndex>(v), tiling.points[v]);
  });
  std::vector<VertexIndex> restored;
  const auto restore = [&](VertexIndex v) {
    if (tiling.points[v] == before.points[v]) return false;
    tiling.points[v] = before.points[v];
    tiling.normals[v] = before.normals[v];
    tiling.places[v] = before.places[v];
    velocities[v].setZero();
    restored.push_back(v);
    return true;
  };
  const TurnedTriangles triangles(tiling, before);
  std::vector<HalfEdgeIndex> suspects = triangles.all();
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
      if (triangles.turned(h) || triangles.creased(h) || triangles.creased(h + 1) || triangles.creased(h + 2))
        suspects.push_back(h);
  }
  // A sliver that is pressed on would be set back for ever; in the middle of its neighbours a vertex is free
  // again.
  for (const VertexIndex v : restored) relax_vertex(tiling, v, 0.5);
  return restored.size();
}

void remember(const Tiling& tiling, Saved& saved) {
  const std::size_t n = tiling.points.size();
  saved.points.resize(n);
  saved.normals.resize(n);
  saved.places.resize(n);
  for_chunks(tiling.team, n, [&](std::size_t begin, std::size_t end) {
    const auto copy = [&](const auto& from, auto& to) {
      std::copy(from.begin() + static_cast<std::ptrdiff_t>(begin),
                from.begin() + static_cast<std::ptrdiff_t>(end),
                to.begin() + static_cast<std::ptrdiff_t>(begin));
    };
    copy(tiling.points, saved.points);
    copy(tiling.normals, saved.normals);
    copy(tiling.places, saved.places);
  });
}

//! What held vertices do not follow.
void hold(const Tiling& tiling, std::vector<Vec3>& velocities) {
  for (VertexIndex v = 0; v < tiling.held.size(); ++v)
    if (tiling.is_held(v)) velocities[v].setZero();
}

}  // namespace

AnnealingResult anneal_particles(Tiling& tiling, double spacing, const AnnealingSchedule& schedule) {
  AnnealingResult result;
  std::mt19937_64 random(schedule.seed);
  const std::size_t n = tiling.points.size();
  std::vector<Vec3> velocities(n, Vec3::Zero()), forces(n);
  kick(velocities, 0, std::sqrt(schedule.hot), random, tiling.team);
  hold(tiling, velocities);
  Neighbours neighbours;
  list_neighbours(tiling, neighbours);
  Saved before;
  remember(tiling, before);
  const double keep = std::exp(-friction * time_step * steps_between_settling);
  for (std::size_t step = 0; step < schedule.steps; ++step) {
    pair_forces(neighbours, tiling, spacing, forces);
    for_chunks(tiling.team, n, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        if (tiling.is_held(static_cast<VertexIndex>(i))) continue;
        Vec3& v = velocities[i];
        v += time_step * forces[i];
        const Vec3& normal = tiling.normals[i];
        v -= v.dot(normal) * normal;
        const double speed = v.norm() * time_step;
        if (speed > longest_step) v *= longest_step / speed;
        tiling.points[i] += (time_step * spacing) * v;
      }
    });
    if ((step + 1) % steps_between_settling != 0 && step + 1 != schedule.steps) continue;
    result.set_back += settle_or_restore(tiling, before, velocities);
    const std::size_t flips = flip_to_delaunay(tiling, 2);
    result.flips += flips;
    if ((step + 1) % (steps_between_settling * settlings_between_unfolding) == 0) unfold(tiling, 1);
    list_neighbours(tiling, neighbours);
    remember(tiling, before);
    const double progress = static_cast<double>(step + 1) / static_cast<double>(schedule.steps);
    const double temperature = schedule.hot + (schedule.cold - schedule.hot) * progress;
    kick(velocities, keep, std::sqrt(temperature * (1 - keep * keep)), random, tiling.team);
    hold(tiling, velocities);
    if (schedule.progress) schedule.progress(progress);
  }
  return result;
}

double even_edges(Tiling& tiling, double spacing, std::size_t steps) {
  const std::size_t n = tiling.points.size();
  std::vector<Vec3> velocities(n, Vec3::Zero()), forces(n);
  Neighbours neighbours;
  list_neighbours(tiling, neighbours);
  Saved before;
  remember(tiling, before);
  double largest = 0;
  double dt = 0.2;
  for (std::size_t step = 0; step < steps; ++step) {
    springs(neighbours, tiling, spacing, forces);
    // FIRE (Bitzek et al. 2006) on the tangential forces.
    struct Sums {
      double power = 0, vv = 0, ff = 0, largest = 0;
    };
    std::vector<Sums> parts(chunks_of(n));
    for_chunks(tiling.team, n, [&](std::size_t begin, std::size_t end) {
      Sums& sums = parts[begin / chunk_size];
      for (std::size_t i = begin; i < end; ++i) {
        if (tiling.is_held(static_cast<VertexIndex>(i))) forces[i].setZero();
        forces[i] -= forces[i].dot(tiling.normals[i]) * tiling.normals[i];
        velocities[i] -= velocities[i].dot(tiling.normals[i]) * tiling.normals[i];
        sums.power += forces[i].dot(velocities[i]);
        sums.vv += velocities[i].squaredNorm();
        sums.ff += forces[i].squaredNorm();
        sums.largest = std::max(sums.largest, forces[i].squaredNorm());
      }
    });
    Sums sums;
    for (const Sums& part : parts) {
      sums.power += part.power;
      sums.vv += part.vv;
      sums.ff += part.ff;
      sums.largest = std::max(sums.largest, part.largest);
    }
    largest = sums.largest;
    const bool downhill = !(sums.power < 0);
    dt = downhill ? std::min(1.05 * dt, 0.6) : std::max(0.5 * dt, 0.05);
    const double mix = downhill && sums.ff > 0 ? 0.1 * std::sqrt(sums.vv / sums.ff) : 0;
    for_chunks(tiling.team, n, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        if (downhill)
          velocities[i] = 0.9 * velocities[i] + mix * forces[i];
        else
          velocities[i].setZero();
        velocities[i] += dt * forces[i];
        tiling.points[i] += (dt * spacing) * velocities[i];
      }
    });
    if ((step + 1) % 4 == 0 || step + 1 == steps) {
      settle_or_restore(tiling, before, velocities);
      remember(tiling, before);
    }
  }
  return std::sqrt(largest);
}

}  // namespace nanocarbon::crystal
