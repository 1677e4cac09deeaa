// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/mesh_topology.h"

#include <algorithm>

#include "nanocarbon/core/disjoint_sets.h"

namespace nanocarbon::mesh {
namespace {

// The two ends of a side as places in PolygonSoup::corners, the lower vertex first.
struct Ends {
  std::uint32_t low, high;
};

Ends ends_of(const PolygonSoup& soup, const EdgeUse& use) {
  const std::uint32_t next = next_corner(soup, use.face, use.corner);
  return use.forward ? Ends{use.corner, next} : Ends{next, use.corner};
}

// Corners of one vertex that are connected over edges: one class for each sheet of the surface at the vertex.
DisjointSets fans_of(const PolygonSoup& soup, const EdgeTable& edges) {
  DisjointSets fans(soup.corners.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto uses = edges.uses_of(e);
    const Ends first = ends_of(soup, uses[0]);
    for (const EdgeUse& use : uses.subspan(1)) {
      const Ends other = ends_of(soup, use);
      fans.join(first.low, other.low);
      fans.join(first.high, other.high);
    }
  }
  return fans;
}

void find_components(MeshTopology& topology, const EdgeTable& edges) {
  DisjointSets faces(topology.faces);
  for (std::size_t e = 0; e < edges.size(); ++e)
    for (const EdgeUse& use : edges.uses_of(e)) faces.join(edges.uses_of(e)[0].face, use.face);
  topology.component_of_face.resize(topology.faces);
  for (FaceIndex face = 0; face < topology.faces; ++face) {
    const FaceIndex first = faces.find(face);
    if (first == face) {
      topology.component_of_face[face] = static_cast<std::uint32_t>(topology.component.size());
      topology.component.emplace_back().first_face = face;
    }
    topology.component_of_face[face] = topology.component_of_face[first];
    ++topology.component[topology.component_of_face[face]].faces;
  }
  topology.components = topology.component.size();
  for (std::size_t e = 0; e < edges.size(); ++e)
    ++topology.component[topology.component_of_face[edges.uses_of(e)[0].face]].edges;
}

void count_vertices(MeshTopology& topology, const PolygonSoup& soup, DisjointSets& fans) {
  std::vector<std::uint32_t> sheets(soup.points.size(), 0);
  for (FaceIndex face = 0; face < topology.faces; ++face)
    for (std::uint32_t corner = soup.offsets[face]; corner < soup.offsets[face + 1]; ++corner)
      if (fans.find(corner) == corner) {
        ++topology.component[topology.component_of_face[face]].vertices;
        ++sheets[soup.corners[corner]];
      }
  for (VertexIndex v = 0; v < sheets.size(); ++v) {
    if (sheets[v] > 0) ++topology.vertices;
    if (sheets[v] > 1) topology.non_manifold_vertices.push_back(v);
  }
}

// Boundary edges hang together in loops where they meet at the same sheet of a vertex.
void count_boundary_loops(MeshTopology& topology, const PolygonSoup& soup, const EdgeTable& edges,
                          DisjointSets& fans) {
  DisjointSets loops(soup.corners.size());
  std::vector<std::uint32_t> on_boundary;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges.uses_of(e).size() != 1) continue;
    const Ends ends = ends_of(soup, edges.uses_of(e)[0]);
    loops.join(fans.find(ends.low), fans.find(ends.high));
    on_boundary.push_back(fans.find(ends.low));
  }
  for (std::uint32_t& corner : on_boundary) corner = loops.find(corner);
  std::sort(on_boundary.begin(), on_boundary.end());
  on_boundary.erase(std::unique(on_boundary.begin(), on_boundary.end()), on_boundary.end());
  topology.boundary_loops = on_boundary.size();
  for (const std::uint32_t corner : on_boundary) {
    const auto after = std::upper_bound(soup.offsets.begin(), soup.offsets.end(), corner);
    const auto face = static_cast<std::size_t>(after - soup.offsets.begin()) - 1;
    ++topology.component[topology.component_of_face[face]].boundary_loops;
  }
}

void find_orientability(MeshTopology& topology, const EdgeTable& edges) {
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto uses = edges.uses_of(e);
    if (uses.size() > 2) topology.non_manifold_edges.push_back(e);
    if (uses.size() == 2 && uses[0].forward == uses[1].forward) topology.twisted_edges.push_back(e);
  }
  DisjointSets sides = face_sides(topology.faces, edges);
  for (MeshComponent& component : topology.component) {
    component.orientable = sides.find(2 * component.first_face) != sides.find(2 * component.first_face + 1);
    topology.orientable = topology.orientable && component.orientable;
  }
}

}  // namespace

std::int64_t MeshComponent::euler_characteristic() const {
  return static_cast<std::int64_t>(vertices) - static_cast<std::int64_t>(edges) +
         static_cast<std::int64_t>(faces);
}

std::int64_t MeshComponent::genus() const {
  const std::int64_t caps = 2 - euler_characteristic() - static_cast<std::int64_t>(boundary_loops);
  return orientable ? caps / 2 : caps;
}

MeshTopology mesh_topology(const PolygonSoup& soup, const EdgeTable& edges) {
  MeshTopology topology;
  topology.faces = soup.faces();
  topology.edges = edges.size();
  DisjointSets fans = fans_of(soup, edges);
  find_components(topology, edges);
  count_vertices(topology, soup, fans);
  count_boundary_loops(topology, soup, edges, fans);
  find_orientability(topology, edges);
  topology.euler_characteristic = static_cast<std::int64_t>(topology.vertices) -
                                  static_cast<std::int64_t>(topology.edges) +
                                  static_cast<std::int64_t>(topology.faces);
  for (const MeshComponent& component : topology.component) topology.genus += component.genus();
  return topology;
}

MeshTopology mesh_topology(const TriangleMesh& mesh) {
  const PolygonSoup soup = soup_of(mesh);
  return mesh_topology(soup, edge_table(soup));
}

}  // namespace nanocarbon::mesh
