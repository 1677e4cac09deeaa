// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

// OpenMesh moves default-made points into its arrays, which gcc takes for a use of what was never set.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

// Specialises templates of the header above, and so comes after it.
#include <OpenMesh/Core/Geometry/EigenVectorT.hh>

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

#include "nanocarbon/core/vec3.h"
#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::thesis {

struct TriangulationTraits : OpenMesh::DefaultTraits {
  using Point = Vec3;
  using Normal = Vec3;
  VertexAttributes(OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge | OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
};

//! \brief The mesh being remeshed: a half-edge mesh of triangles in double precision, points in Angstrom.
//! \details Its connectivity changes only through stellar_operations.h. Elements that an operation removed
//! stay as deleted until compact(); n_vertices() and its like count them until then.
using Triangulation = OpenMesh::TriMesh_ArrayKernelT<TriangulationTraits>;

using VertexHandle = OpenMesh::VertexHandle;
using HalfedgeHandle = OpenMesh::HalfedgeHandle;
using EdgeHandle = OpenMesh::EdgeHandle;
using FaceHandle = OpenMesh::FaceHandle;

//! \brief The half-edge mesh of a plain one: vertex i is point i, face i is triangle i.
//! \pre finite points
//! \throw UserError (unsuitable) naming the triangle, where the mesh is not an oriented 2-manifold
Triangulation to_triangulation(const TriangleMesh& mesh);

//! The plain mesh of a half-edge mesh, deleted elements left out, the others in the order of their handles.
TriangleMesh to_triangle_mesh(const Triangulation& triangulation);

//! Removes deleted elements. The last elements move into the holes: all handles held outside become stale.
void compact(Triangulation& triangulation);

//! The distance between the ends of an edge, Angstrom.
inline double edge_length(const Triangulation& mesh, EdgeHandle edge) {
  const HalfedgeHandle h = mesh.halfedge_handle(edge, 0);
  return (mesh.point(mesh.to_vertex_handle(h)) - mesh.point(mesh.from_vertex_handle(h))).norm();
}

}  // namespace nanocarbon::thesis
