// SPDX-License-Identifier: GPL-2.0-or-later
// Meshes in a periodic cell: how they go through it, and what they are in free space.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

//! Translations of a lattice, in multiples of a cell's edges, that others generate.
class Translations {
 public:
  void add(std::array<std::int32_t, 3> image);
  bool contains(std::array<std::int32_t, 3> image) const;
  int rank() const;

 private:
  std::array<std::array<std::int32_t, 3>, 3> rows_ = {};  // an upper triangle; zero on its diagonal where none leads
};

//! How a mesh goes on through the faces of its cell.
struct Wrapping {
  //! Cell multiples to add to each vertex so that its component is in one piece, as far as that goes.
  std::vector<std::array<std::int32_t, 3>> image;
  //! Of each component, those that lead along its edges from a vertex to an image of it.
  std::vector<Translations> translations;
};
Wrapping wrapping(const TriangleMesh& mesh, const MeshTopology& topology);

//! \brief For each component in how many independent directions it goes on through the cell's faces for ever:
//! 0 for a bubble, 1 for a tube, 2 for a sheet, 3 for a network.
//! \details The rank of the translations that lead along the component's edges from a vertex to its images.
std::vector<int> wrapping_ranks(const TriangleMesh& mesh, const MeshTopology& topology);

//! Several cells as one: copies of the mesh along the edges of its cell.
//! \param cells along each edge, from 1; 1 in directions that are not periodic
TriangleMesh repeated(const TriangleMesh& mesh, const std::array<int, 3>& cells);

//! Strains a mesh and its cell about the origin: positions x are now at deformation * x.
void deform(TriangleMesh& mesh, const Mat3& deformation);

//! A mesh cut open so that it can be drawn and written.
struct Unfolded {
  TriangleMesh mesh;                //!< in free space
  std::vector<VertexIndex> source;  //!< of each of its vertices in the mesh in the cell
};

//! Each triangle in one piece, its centre in the cell; vertices come once for each image that is needed. In
//! free space the mesh as it is.
Unfolded unfolded(const TriangleMesh& mesh);

}  // namespace nanocarbon::mesh
