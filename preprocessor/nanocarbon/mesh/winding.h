#pragma once

#include <cstddef>

#include "nanocarbon/mesh/disjoint_sets.h"
#include "nanocarbon/mesh/edge_table.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon {

//! \brief Which sides of the faces belong together across the edges with two faces.
//! \details Number 2 f is face f as wound, 2 f + 1 is face f turned. A piece is orientable when no face's two
//! numbers are in one set.
DisjointSets face_sides(std::size_t faces, const EdgeTable& edges);

//! \brief Winds the faces of each orientable piece alike, turning the fewer ones.
//! \return how many faces were turned
std::size_t wind_alike(TriangleMesh& mesh, const MeshTopology& topology, const EdgeTable& edges);

//! \brief Turns closed pieces that are inside-out: outermost pieces with a negative volume, each with all
//! that it encloses. A piece within another keeps its winding relative to it: opposite, as the wall of a
//! cavity, or alike, as a shell of its own.
//! \return how many pieces were turned
//! \pre consistently wound and manifold
std::size_t turn_outside(TriangleMesh& mesh, const MeshTopology& topology);

}  // namespace nanocarbon
