// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/topology/surface_topology.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>

#include "nanocarbon/topology/face_check.h"
#include "nanocarbon/topology/face_tracing.h"
#include "nanocarbon/topology/orientation.h"

namespace nanocarbon::topology {
namespace {

struct Counts {
  int atoms = 0, half_edges = 0, rings = 0, holes = 0;
};

std::vector<Counts> count_skeleton(const Skeleton& skeleton) {
  std::vector<Counts> counts(skeleton.components);
  for (std::size_t a = 0; a < skeleton.degree.size(); ++a)
    if (skeleton.degree[a] > 0) {
      ++counts[skeleton.component[a]].atoms;
      counts[skeleton.component[a]].half_edges += skeleton.degree[a];
    }
  return counts;
}

ComponentTopology component_topology(const Counts& c, bool one_sided) {
  if (c.atoms == 0) return {false, true, 0, 1};  // a fragment, as a disc
  // Euler's formula for the surface with its holes closed.
  const int closed = c.atoms - c.half_edges / 2 + c.rings + c.holes;
  return {c.rings > 0, !one_sided, one_sided ? 2 - closed : (2 - closed) / 2, c.holes};
}

void append(std::span<const AtomIndex> face, Rings& rings) {
  rings.atoms.insert(rings.atoms.end(), face.begin(), face.end());
  rings.offsets.push_back(static_cast<std::uint32_t>(rings.atoms.size()));
}

void add_ring(std::span<const AtomIndex> ring, SurfaceTopology& surface) {
  const auto size = static_cast<std::uint8_t>(ring.size());
  ++surface.ring_counts[size];
  for (const AtomIndex a : ring) {
    std::uint8_t& smallest = surface.smallest_ring[a];
    if (smallest == 0 || size < smallest) smallest = size;
  }
  append(ring, surface.rings);
}

std::string describe(const ComponentTopology& p) {
  const std::string loops =
      fmt::format("{} boundary loop{}", p.boundary_loops, p.boundary_loops == 1 ? "" : "s");
  if (!p.has_rings) return fmt::format("without rings, {}", loops);
  return fmt::format("{}, genus {}, {}", p.orientable ? "orientable" : "not orientable", p.genus, loops);
}

}  // namespace

SurfaceTopology surface_topology(const EmbeddedGraph& graph, const TopologyOptions& options) {
  SurfaceTopology surface;
  surface.ring_counts.assign(static_cast<std::size_t>(options.max_ring) + 1, 0);
  surface.smallest_ring.assign(graph.atoms(), 0);
  surface.coordination.resize(graph.atoms());
  for (AtomIndex a = 0; a < graph.atoms(); ++a)
    surface.coordination[a] = static_cast<std::uint8_t>(std::min(graph.degree(a), 255u));

  RotationSystem rotation = rotation_system(graph);
  if (!rotation.skeleton.problem) orient(graph, rotation);
  surface.components.resize(rotation.skeleton.components);
  surface.component_of_atom = rotation.skeleton.component;
  surface.problem = rotation.skeleton.problem;
  if (surface.problem) return surface;

  const Faces faces = trace_faces(graph, rotation);
  surface.problem = find_doubtful_face(graph, rotation, faces, options.max_ring);
  if (surface.problem) return surface;
  std::vector<Counts> counts = count_skeleton(rotation.skeleton);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const std::span<const AtomIndex> face(faces.atoms.data() + faces.offsets[f],
                                          faces.offsets[f + 1] - faces.offsets[f]);
    Counts& component = counts[surface.component_of_atom[face[0]]];
    const bool turns_left = faces.turning[f] > std::numbers::pi;
    if (turns_left && face.size() <= static_cast<std::size_t>(options.max_ring)) {
      ++component.rings;
      add_ring(face, surface);
    } else {
      ++component.holes;
      if (turns_left) append(face, surface.holes);
    }
  }
  for (std::size_t p = 0; p < counts.size(); ++p) {
    surface.components[p] = component_topology(counts[p], rotation.one_sided[p] != 0);
    surface.euler_characteristic += surface.components[p].euler_characteristic();
    surface.genus += surface.components[p].genus;
    surface.boundary_loops += surface.components[p].boundary_loops;
    surface.orientable = surface.orientable && surface.components[p].orientable;
  }
  return surface;
}

std::string_view name(Verdict verdict) {
  constexpr std::array<std::string_view, 4> names = {"intact", "homeomorphic", "broken", "not a surface"};
  return names[static_cast<std::size_t>(verdict)];
}

Judgement judge(const SurfaceTopology& start, const SurfaceTopology& now, bool same_bonds,
                std::size_t lost_atoms) {
  if (lost_atoms > 0)
    return {
        Verdict::broken, fmt::format("{} atom{} lost", lost_atoms, lost_atoms == 1 ? " was" : "s were"), {}};
  if (same_bonds) return {Verdict::intact, {}, {}};
  if (now.problem) return {Verdict::not_a_surface, now.problem->reason, now.problem->atom};
  if (start.problem)
    return {Verdict::not_a_surface,
            "the bonds did not form a surface to start with: " + start.problem->reason, start.problem->atom};
  std::vector<ComponentTopology> before = start.components, after = now.components;
  std::sort(before.begin(), before.end());
  std::sort(after.begin(), after.end());
  if (before == after) return {Verdict::homeomorphic, "other bonds, the same surface", {}};
  if (before.size() != after.size())
    return {
        Verdict::broken,
        fmt::format("{} piece{} instead of {}", after.size(), after.size() == 1 ? "" : "s", before.size()),
        {}};
  const auto [was, is] = std::mismatch(before.begin(), before.end(), after.begin());
  return {Verdict::broken, fmt::format("a piece was {}; now one is {}", describe(*was), describe(*is)), {}};
}

}  // namespace nanocarbon::topology
