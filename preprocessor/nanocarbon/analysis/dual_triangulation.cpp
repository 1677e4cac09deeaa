// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/analysis/dual_triangulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "nanocarbon/core/error.h"
#include "nanocarbon/molecule/molecule_graph.h"
#include "nanocarbon/topology/face_check.h"
#include "nanocarbon/topology/face_tracing.h"
#include "nanocarbon/topology/orientation.h"

namespace nanocarbon::analysis {
namespace {

[[noreturn]] void refuse(const std::string& why) {
  throw UserError(Failure::unsuitable, "the molecule is not the dual of a triangulation: " + why);
}

// A corner of an atom's triangle: it lies to the left of a half-edge, before or after a bond that is missing there.
struct Corner {
  std::uint32_t half_edge, beyond_missing, vertex;
};

struct Corners {
  std::array<Corner, 3> corner = {};
  std::uint8_t count = 0;
};

class Triangulation {
 public:
  Triangulation(const Molecule& molecule, topology::EmbeddedGraph graph, int max_ring)
      : molecule_(molecule),
        graph_(std::move(graph)),
        max_ring_(max_ring),
        space_(molecule.cell),
        corners_(molecule.size()) {}

  DualTriangulation make() {
    constexpr double short_edge = 2.0;  // Angstrom: between the middles of rings that share a stretched bond
    require_width(short_edge);
    topology::RotationSystem rotation = topology::rotation_system(graph_);
    if (!rotation.skeleton.problem) topology::orient(graph_, rotation);
    if (rotation.skeleton.problem) refuse(rotation.skeleton.problem->reason);
    const topology::Faces faces = topology::trace_faces(graph_, rotation);
    if (const auto problem = topology::find_doubtful_face(graph_, rotation, faces, max_ring_))
      refuse(problem->reason);
    degree_ = &rotation.skeleton.degree;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const std::uint32_t begin = faces.offsets[f], size = faces.offsets[f + 1] - begin;
      if (is_bare(rotation, faces.atoms[begin])) continue;
      const bool ring = size <= static_cast<std::uint32_t>(max_ring_) && faces.turning[f] > std::numbers::pi;
      if (ring)
        add_ring(faces, begin, size);
      else
        add_hole(faces, begin, size);
    }
    return assemble(rotation);
  }

 private:
  static bool is_bare(const topology::RotationSystem& rotation, AtomIndex atom) {
    return rotation.bare_cycle[rotation.skeleton.component[atom]] != 0;
  }

  // Meshes in a cell are told by nearest images: no edge is longer than a third of the least width.
  void require_width(double edge) const {
    constexpr double slack = 1.0 + 1e-6;
    if (space_.least_width() * slack < 3.0 * edge)
      refuse(fmt::format(
          "its periodic cell is only {:.3g} Angstrom wide, and edges of the triangulation, of up to {:.3g}, "
          "fit in it three times or more; repeat the cell first",
          space_.least_width(), edge));
  }

  std::uint32_t new_vertex() {
    incident_.emplace_back();
    fixed_.push_back(0);
    points_.push_back(Vec3::Zero());
    return static_cast<std::uint32_t>(points_.size() - 1);
  }

  void add_corner(AtomIndex atom, std::uint32_t half_edge, std::uint32_t vertex,
                  bool beyond_missing = false) {
    Corners& c = corners_[atom];
    if (c.count == 3)
      refuse(fmt::format("atom ID {} has holes on both sides; remove it first", graph_.id(atom)));
    c.corner[c.count++] = {half_edge, beyond_missing, vertex};
    incident_[vertex].push_back(atom);
  }

  void add_ring(const topology::Faces& faces, std::uint32_t begin, std::uint32_t size) {
    const std::uint32_t vertex = new_vertex();
    fixed_[vertex] = 1;
    Vec3 along = Vec3::Zero(), sum = Vec3::Zero();  // from the ring's first atom, across the cell's faces
    for (std::uint32_t k = begin; k < begin + size; ++k) {
      sum += along;
      along += graph_.vectors[faces.half_edges[k]];
      add_corner(faces.atoms[k], faces.half_edges[k], vertex);
    }
    points_[vertex] = molecule_.positions[faces.atoms[begin]] + sum / size;
  }

  // Around a hole a new vertex begins at each atom whose third bond is missing.
  void add_hole(const topology::Faces& faces, std::uint32_t begin, std::uint32_t size) {
    std::vector<std::uint32_t> missing;
    for (std::uint32_t k = 0; k < size; ++k)
      if ((*degree_)[faces.atoms[begin + k]] == 2) missing.push_back(k);
    if (missing.empty()) {
      add_ring(faces, begin, size);
      return;
    }
    if (missing.size() < 3)
      refuse(fmt::format("the hole at atom ID {} lacks only {} bond{}",
                         graph_.id(faces.atoms[begin + missing[0]]), missing.size(),
                         missing.size() == 1 ? "" : "s"));
    const std::uint32_t first = static_cast<std::uint32_t>(points_.size());
    for (std::size_t m = 0; m < missing.size(); ++m) new_vertex();
    for (std::size_t m = 0; m < missing.size(); ++m) {
      const auto vertex = first + static_cast<std::uint32_t>(m);
      const auto before = first + static_cast<std::uint32_t>((m + missing.size() - 1) % missing.size());
      const std::uint32_t at = begin + missing[m];
      add_corner(faces.atoms[at], faces.half_edges[at], vertex);
      add_corner(faces.atoms[at], faces.half_edges[at], before, true);
      const std::uint32_t until = m + 1 < missing.size() ? missing[m + 1] : missing[0] + size;
      for (std::uint32_t k = missing[m] + 1; k < until; ++k)
        add_corner(faces.atoms[begin + k % size], faces.half_edges[begin + k % size], vertex);
    }
  }

  // Each triangle's middle should be its atom: coordinate descent on the squared distances, from the vertices of
  // rings, which stay.
  void place_boundary() {
    constexpr int sweeps = 200;
    std::vector<std::uint32_t> free;
    for (std::uint32_t v = 0; v < points_.size(); ++v) {
      if (fixed_[v]) continue;
      free.push_back(v);
      Vec3 outwards = Vec3::Zero(), middle = Vec3::Zero();
      const Vec3& first = molecule_.positions[incident_[v].front()];
      for (const AtomIndex a : incident_[v]) {
        middle += space_.beside(molecule_.positions[a], first) / static_cast<double>(incident_[v].size());
        Vec3 bonds = Vec3::Zero();
        for (std::uint32_t h = graph_.offsets[a]; h < graph_.offsets[a + 1]; ++h)
          if (graph_.elements[graph_.ends[h]] == Element::carbon) bonds += graph_.vectors[h];
        if ((*degree_)[a] == 2) outwards -= bonds;
      }
      points_[v] = middle + outwards / static_cast<double>(incident_[v].size());
    }
    for (int sweep = 0; sweep < sweeps; ++sweep)
      for (const std::uint32_t v : free) {
        Vec3 sum = Vec3::Zero();
        for (const AtomIndex a : incident_[v]) {
          Vec3 others = Vec3::Zero();
          for (const Corner& c : corners_[a].corner)
            if (c.vertex != v) others += space_.beside(points_[c.vertex], points_[v]);
          sum += 3.0 * space_.beside(molecule_.positions[a], points_[v]) - others;
        }
        points_[v] = sum / static_cast<double>(incident_[v].size());
      }
  }

  // Counter-clockwise seen from outside, as the half-edges beside the corners go round the atom. (A surface with one
  // side only has no outside: there corners come as they were found.)
  Triangle triangle_of(const topology::RotationSystem& rotation, AtomIndex atom) const {
    const auto& corner = corners_[atom].corner;
    Triangle triangle{corner[0].vertex, corner[1].vertex, corner[2].vertex};
    const std::vector<std::uint32_t>& after = rotation.flipped[atom] ? rotation.previous : rotation.next;
    std::uint32_t half_edge = corner[0].half_edge;
    std::size_t k = 0;
    do {
      for (const std::uint32_t beyond : {0u, 1u})
        for (const Corner& c : corner)
          if (k < 3 && c.half_edge == half_edge && c.beyond_missing == beyond) triangle[k++] = c.vertex;
      half_edge = after[half_edge];
    } while (half_edge != corner[0].half_edge);
    return triangle;
  }

  static double longest_edge(const TriangleMesh& mesh) {
    double longest = 0.0;
    for (const Triangle& t : mesh.triangles) {
      const auto [a, b, c] = corners_of(mesh, t);
      longest = std::max({longest, (b - a).norm(), (c - b).norm(), (a - c).norm()});
    }
    return longest;
  }

  DualTriangulation assemble(const topology::RotationSystem& rotation) {
    for (AtomIndex a = 0; a < corners_.size(); ++a)
      if (corners_[a].count > 0 && corners_[a].count < 3)
        refuse(fmt::format("atom ID {} is beside {} faces only", graph_.id(a), corners_[a].count));
    place_boundary();
    DualTriangulation result;
    result.mesh.points = points_;
    result.mesh.space = space_;
    for (AtomIndex a = 0; a < corners_.size(); ++a) {
      if (corners_[a].count == 0) continue;
      const Triangle t = triangle_of(rotation, a);
      if (t[0] == t[1] || t[1] == t[2] || t[0] == t[2])
        refuse(fmt::format("the face beside atom ID {} passes it twice", graph_.id(a)));
      result.mesh.triangles.push_back(t);
      result.atoms.push_back(a);
    }
    if (result.atoms.empty()) refuse("it has no rings");
    require_width(longest_edge(result.mesh));
    return result;
  }

  const Molecule& molecule_;
  topology::EmbeddedGraph graph_;
  int max_ring_;
  Space space_;
  const std::vector<std::uint8_t>* degree_ = nullptr;
  std::vector<Corners> corners_;  // of each atom
  std::vector<Vec3> points_;
  std::vector<std::uint8_t> fixed_;
  std::vector<std::vector<AtomIndex>> incident_;
};

}  // namespace

DualTriangulation dual_triangulation(const Molecule& molecule, std::span<const std::int64_t> ids,
                                     int max_ring) {
  topology::EmbeddedGraph graph = molecule::embedded_graph(molecule);
  graph.ids.assign(ids.begin(), ids.end());
  return Triangulation(molecule, std::move(graph), max_ring).make();
}

}  // namespace nanocarbon::analysis
