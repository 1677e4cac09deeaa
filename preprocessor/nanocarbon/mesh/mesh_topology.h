// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "nanocarbon/mesh/edge_table.h"
#include "nanocarbon/mesh/polygon_soup.h"
#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

//! One component of a mesh: faces connected over edges. Where a mesh hangs together by single vertices, these
//! count once for each sheet, so that the numbers are those of the surface that the component is.
struct MeshComponent {
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t faces = 0;
  std::size_t boundary_loops = 0;
  bool orientable = true;
  FaceIndex first_face = 0;  //!< its lowest face

  std::int64_t euler_characteristic() const;
  //! Handles, (2 - Euler characteristic - loops) / 2; where not orientable, cross-caps, 2 - Euler
  //! characteristic - loops.
  std::int64_t genus() const;
};

//! What a mesh is, up to continuous deformation. For meshes that are not manifold the counts still hold.
struct MeshTopology {
  std::size_t vertices = 0;  //!< those that a face uses
  std::size_t edges = 0;
  std::size_t faces = 0;
  std::size_t components = 0;
  std::size_t boundary_loops = 0;
  std::int64_t euler_characteristic = 0;  //!< vertices - edges + faces
  bool orientable = true;
  std::int64_t genus = 0;  //!< sum over the components

  std::vector<MeshComponent> component;  //!< ordered by their lowest face
  std::vector<std::uint32_t> component_of_face;
  std::vector<std::size_t> non_manifold_edges;     //!< places in the edge table; more than two faces
  std::vector<VertexIndex> non_manifold_vertices;  //!< the faces around it form more than one fan
  std::vector<std::size_t> twisted_edges;          //!< both faces run along the edge in the same direction

  bool manifold() const { return non_manifold_edges.empty() && non_manifold_vertices.empty(); }
  bool consistently_wound() const { return twisted_edges.empty(); }
  bool closed() const { return faces > 0 && boundary_loops == 0; }
};

//! Linear in faces while valences are bounded.
MeshTopology mesh_topology(const PolygonSoup& soup, const EdgeTable& edges);
MeshTopology mesh_topology(const TriangleMesh& mesh);

}  // namespace nanocarbon::mesh
