// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/topology/face_tracing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace nanocarbon::topology {
namespace {

constexpr std::uint32_t none = Skeleton::none;
constexpr double full_turn = 2.0 * std::numbers::pi;

// A half-edge walked with the normal of its atom as it is (reversed = 0) or turned over (1).
struct Step {
  std::uint32_t half_edge;
  std::uint8_t reversed;
};

std::size_t index(const Step& step) { return 2 * std::size_t{step.half_edge} + step.reversed; }

// The next step with nothing between the two on the left.
Step following(const RotationSystem& r, const Step& step) {
  const std::uint32_t arrived = r.skeleton.twin[step.half_edge];
  const std::uint8_t reversed = step.reversed ^ r.twisted[step.half_edge];
  return {reversed ? r.next[arrived] : r.previous[arrived], reversed};
}

// The same step walked backwards on the other side of the surface.
Step mirrored(const RotationSystem& r, const Step& step) {
  const auto reversed = static_cast<std::uint8_t>(step.reversed ^ r.twisted[step.half_edge] ^ 1);
  return {r.skeleton.twin[step.half_edge], reversed};
}

// The turn to the left between arriving and leaving, from -pi to pi.
double turn_to_the_left(const EmbeddedGraph& graph, const RotationSystem& r, AtomIndex atom,
                        const Step& arriving, const Step& leaving) {
  const Vec3 back = graph.vectors[r.skeleton.twin[arriving.half_edge]].normalized();
  const Vec3 ahead = graph.vectors[leaving.half_edge].normalized();
  const double inner = std::acos(std::clamp(back.dot(ahead), -1.0, 1.0));
  const double left = ahead.cross(back).dot(r.normals[atom]) * (leaving.reversed ? -1.0 : 1.0);
  return left >= 0.0 ? std::numbers::pi - inner : inner - std::numbers::pi;
}

double turning(const EmbeddedGraph& graph, const RotationSystem& r, const std::vector<Step>& steps) {
  double sum = 0.0;
  for (std::size_t k = 0; k < steps.size(); ++k)
    sum +=
        turn_to_the_left(graph, r, graph.ends[steps[k].half_edge], steps[k], steps[(k + 1) % steps.size()]);
  return sum;
}

// A bare cycle has no sides: one of its two faces is called its inside.
double turning_of_bare_cycle(const RotationSystem& r, const Step& first) {
  return first.half_edge < r.next[first.half_edge] ? full_turn : -full_turn;
}

}  // namespace

Faces trace_faces(const EmbeddedGraph& graph, const RotationSystem& rotation) {
  const Skeleton& skeleton = rotation.skeleton;
  Faces faces;
  faces.atoms.reserve(graph.ends.size());
  faces.half_edges.reserve(graph.ends.size());
  std::vector<bool> visited(2 * graph.ends.size(), false);
  std::vector<Step> steps;
  const auto tail = [&](const Step& s) { return graph.ends[skeleton.twin[s.half_edge]]; };
  const auto trace = [&](const Step& first) {
    steps.clear();
    for (Step s = first; !visited[index(s)]; s = following(rotation, s)) {
      visited[index(s)] = visited[index(mirrored(rotation, s))] = true;
      steps.push_back(s);
    }
    const auto lowest = std::min_element(steps.begin(), steps.end(),
                                         [&](const Step& a, const Step& b) { return tail(a) < tail(b); });
    std::rotate(steps.begin(), lowest, steps.end());
    for (const Step& s : steps) {
      faces.atoms.push_back(tail(s));
      faces.half_edges.push_back(s.half_edge);
    }
    faces.offsets.push_back(static_cast<std::uint32_t>(faces.atoms.size()));
    const bool bare_cycle = rotation.bare_cycle[skeleton.component[tail(first)]] != 0;
    faces.turning.push_back(bare_cycle ? turning_of_bare_cycle(rotation, first)
                                       : turning(graph, rotation, steps));
  };
  for (AtomIndex a = 0; a < graph.atoms(); ++a)
    for (std::uint32_t h = graph.offsets[a]; h < graph.offsets[a + 1]; ++h) {
      if (skeleton.twin[h] == none) continue;
      const Step step{h, rotation.flipped[a]};
      if (!visited[index(step)]) trace(step);
      const Step other_side{h, static_cast<std::uint8_t>(step.reversed ^ 1)};
      if (rotation.one_sided[skeleton.component[a]] && !visited[index(other_side)]) trace(other_side);
    }
  return faces;
}

}  // namespace nanocarbon::topology
