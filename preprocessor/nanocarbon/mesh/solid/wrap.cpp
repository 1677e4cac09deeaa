// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/solid/wrap.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/distance.h"
#include "nanocarbon/mesh/join_points.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/mesh/solid/alpha_wrap.h"
#include "nanocarbon/mesh/triangulate.h"

namespace nanocarbon::mesh {
namespace {

constexpr double most_faces = 2e6;                              // a minute or so, and less than 2 GB
constexpr double smallest_offset = 0.01, largest_offset = 1.0;  // in sizes

// Both sides of sheets are wrapped, by triangles with edges of about a size and, at creases, smaller ones.
double faces_expected(double area, double size) { return 10.0 * area / (size * size); }

void require_fitting(const WrapSize& size, const TriangleMesh& mesh) {
  if (size.offset < smallest_offset * size.size || size.offset > largest_offset * size.size)
    throw UserError(
        Failure::usage,
        fmt::format("a wrap of size {:g} lies from {:g} to {:g} outside of the mesh, "
                    "not {:g}: choose another offset",
                    size.size, smallest_offset * size.size, largest_offset * size.size, size.offset));
  const double diagonal = bounding_box(mesh.points).extent().norm();
  if (size.size > diagonal)
    throw UserError(Failure::usage,
                    fmt::format("a wrap of size {:g} is larger than the whole mesh, {:g} from corner to "
                                "corner: nothing of its shape would be left",
                                size.size, diagonal));
  const double least = std::sqrt(faces_expected(area(mesh), 1.0) / most_faces);
  if (size.size < least)
    throw UserError(Failure::usage,
                    fmt::format("a wrap of size {:g} would take millions of faces: ask for {:.2g} "
                                "or more",
                                size.size, 1.05 * least));
}

// Takes out what the wrap would have spikes without thickness around, and tells how many.
std::size_t drop_hairs(TriangleMesh& mesh, double widest) {
  constexpr double most_area = 1e-3;  // what is made of nothing else is meant to be there
  const std::vector<VertexIndex> place = coincident_points(mesh.points).representative;
  const auto side = [&](const Triangle& t, std::size_t k) {
    return std::minmax({place[t[k]], place[t[(k + 1) % 3]]});
  };
  std::map<std::pair<VertexIndex, VertexIndex>, int> faces_at;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++faces_at[side(t, k)];
  const auto is_hair = [&](const Triangle& t) {
    double longest = 0.0;
    bool hangs = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const double length = (mesh.points[t[(k + 1) % 3]] - mesh.points[t[k]]).norm();
      longest = std::max(longest, length);
      hangs = hangs && (length <= widest || faces_at[side(t, k)] == 1);
    }
    const auto [a, b, c] = corners_of(mesh, t);
    return hangs && longest > widest && (b - a).cross(c - a).norm() < widest * longest;
  };
  TriangleMesh others{mesh.points, {}};
  std::remove_copy_if(mesh.triangles.begin(), mesh.triangles.end(), std::back_inserter(others.triangles),
                      is_hair);
  const std::size_t hairs = mesh.triangles.size() - others.triangles.size();
  if (hairs == 0 || area(others) < (1.0 - most_area) * area(mesh)) return 0;
  drop_unused_points(others);
  mesh = std::move(others);
  return hairs;
}

double largest_distance(const TriangleMesh& from, const TriangleMesh& to) {
  std::vector<Vec3> points = sample_by_area(from, std::max<std::size_t>(from.triangles.size(), 20'000));
  points.insert(points.end(), from.points.begin(), from.points.end());
  return distances_to_surface(points, NearestPoint(to)).max;
}

}  // namespace

Wrapped wrap(const PolygonSoup& soup, const WrapSize& size) {
  if (!can_be_triangulated(soup))
    throw UserError(Failure::unsuitable,
                    soup.faces() == 0
                        ? std::string("the mesh has no faces to wrap; point clouds need to be meshed first")
                        : fmt::format("a face has more than {} corners: triangulate the mesh", most_corners));
  TriangleMesh original = triangulate(soup).mesh;
  std::erase_if(original.triangles, [&](const Triangle& t) { return has_no_area(original.points, t); });
  drop_unused_points(original);
  if (original.triangles.empty())
    throw UserError(Failure::unsuitable, "no face of the mesh has an area that could be wrapped");
  require_fitting(size, original);
  Wrapped wrapped;
  wrapped.hairs = drop_hairs(original, 0.1 * size.offset);
  wrapped.mesh = alpha_wrap(original, size.size, size.offset);
  wrapped.components = mesh_topology(wrapped.mesh).components;
  wrapped.to_original = largest_distance(wrapped.mesh, original);
  wrapped.from_original = largest_distance(original, wrapped.mesh);
  return wrapped;
}

std::string describe(const Wrapped& wrapped, const WrapSize& size) {
  return fmt::format(
      "wrapped, size {:g}, offset {:.3g}: {} faces in {} piece{}, nowhere farther than {:.3g} from "
      "the mesh, and {}the mesh nowhere farther than {:.3g} from them (mesh units){}",
      size.size, size.offset, wrapped.mesh.triangles.size(), wrapped.components,
      wrapped.components == 1 ? "" : "s", wrapped.to_original, wrapped.hairs == 0 ? "" : "the rest of ",
      wrapped.from_original,
      wrapped.hairs == 0 ? ""
                         : fmt::format("; left out {} hair{}: faces narrower than {:.2g} that hang free",
                                       wrapped.hairs, wrapped.hairs == 1 ? "" : "s", 0.1 * size.offset));
}

}  // namespace nanocarbon::mesh
