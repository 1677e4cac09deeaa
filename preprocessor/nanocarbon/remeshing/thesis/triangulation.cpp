// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/thesis/triangulation.h"

#include <fmt/format.h>

#include "nanocarbon/core/error.h"

namespace nanocarbon::thesis {
namespace {

[[noreturn]] void refuse(std::size_t triangle, const char* reason) {
  throw UserError(Failure::unsuitable,
                  fmt::format("triangle {} {}: only oriented 2-manifold surfaces can be remeshed; run "
                              "'nanocarbon inspect' on the mesh to see all that is wrong with it",
                              triangle, reason));
}

}  // namespace

Triangulation to_triangulation(const TriangleMesh& mesh) {
  Triangulation result;
  result.reserve(mesh.points.size(), mesh.points.size() + mesh.triangles.size() + 2, mesh.triangles.size());
  for (const Vec3& p : mesh.points) result.add_vertex(p);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [a, b, c] = mesh.triangles[t];
    if (std::max({a, b, c}) >= mesh.points.size()) refuse(t, "names a vertex that is not there");
    if (a == b || b == c || c == a) refuse(t, "names one vertex twice");
    const VertexHandle corners[3] = {VertexHandle(static_cast<int>(a)), VertexHandle(static_cast<int>(b)),
                                     VertexHandle(static_cast<int>(c))};
    // OpenMesh would print and give up on these; asked beforehand, add_face cannot fail for any other reason.
    for (int k = 0; k < 3; ++k) {
      if (!result.is_boundary(corners[k]))
        refuse(t, "touches a vertex whose triangles already close around it");
      const HalfedgeHandle h = result.find_halfedge(corners[k], corners[(k + 1) % 3]);
      if (h.is_valid() && !result.is_boundary(h))
        refuse(t, "shares an edge, in the same direction, with another");
    }
    if (!result.add_face(corners[0], corners[1], corners[2]).is_valid())
      refuse(t, "touches a vertex whose triangles do not form one fan");
  }
  return result;
}

TriangleMesh to_triangle_mesh(const Triangulation& triangulation) {
  TriangleMesh mesh;
  std::vector<VertexIndex> index(triangulation.n_vertices());
  mesh.points.reserve(triangulation.n_vertices());
  mesh.triangles.reserve(triangulation.n_faces());
  for (const VertexHandle v : triangulation.all_vertices()) {
    if (triangulation.status(v).deleted()) continue;
    index[static_cast<std::size_t>(v.idx())] = static_cast<VertexIndex>(mesh.points.size());
    mesh.points.push_back(triangulation.point(v));
  }
  for (const FaceHandle f : triangulation.all_faces()) {
    if (triangulation.status(f).deleted()) continue;
    HalfedgeHandle h = triangulation.halfedge_handle(f);
    Triangle triangle;
    for (VertexIndex& corner : triangle) {
      corner = index[static_cast<std::size_t>(triangulation.from_vertex_handle(h).idx())];
      h = triangulation.next_halfedge_handle(h);
    }
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

void compact(Triangulation& triangulation) { triangulation.garbage_collection(); }

}  // namespace nanocarbon::thesis
