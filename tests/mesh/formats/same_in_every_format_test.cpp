// SPDX-License-Identifier: GPL-2.0-or-later
// The same surface is the same mesh, and is refused for the same reason, in whatever format it comes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "nanocarbon/mesh/formats/load_surface.h"
#include "nanocarbon/mesh/formats/write_mesh.h"
#include "nanocarbon/mesh/triangulate.h"
#include "support/grid_files.h"
#include "support/scene_files.h"
#include "support/small_meshes.h"
#include "support/temporary_folder.h"

namespace nanocarbon::mesh {
namespace {

struct Shape {
  std::string name;
  TriangleMesh mesh;
  bool usable;
  std::int64_t euler;  // of what is right
};

//! A sphere as programs for pictures write it: the seam's vertices twice, a vertex at the poles for each
//! meridian, triangles without area there. Floats, so that STL holds it as well.
TriangleMesh uv_sphere(VertexIndex columns, VertexIndex rows) {
  TriangleMesh mesh;
  for (VertexIndex j = 0; j <= rows; ++j)
    for (VertexIndex i = 0; i <= columns; ++i) {
      const double u = 2 * std::numbers::pi * (i % columns) / columns, v = std::numbers::pi * j / rows;
      const double r = j == 0 || j == rows ? 0.0 : std::sin(v);
      mesh.points.emplace_back(static_cast<float>(r * std::cos(u)), static_cast<float>(r * std::sin(u)),
                               static_cast<float>(std::cos(v)));
    }
  for (VertexIndex j = 0; j < rows; ++j)
    for (VertexIndex i = 0; i < columns; ++i) {
      const VertexIndex a = j * (columns + 1) + i, b = a + columns + 1;
      mesh.triangles.push_back({a, b, b + 1});
      mesh.triangles.push_back({a, b + 1, a + 1});
    }
  return mesh;
}

//! Every face, or every triangle, with vertices of its own.
TriangleMesh apart(const PolygonSoup& soup) {
  PolygonSoup result;
  for (std::size_t face = 0; face < soup.faces(); ++face) {
    for (const VertexIndex v : soup.face(face)) {
      result.corners.push_back(static_cast<VertexIndex>(result.points.size()));
      result.points.push_back(soup.points[v]);
    }
    result.close_face();
  }
  return triangulate(result).mesh;
}

TriangleMesh with_zero_edge(TriangleMesh mesh) {
  mesh.points[mesh.triangles[5][0]] = mesh.points[mesh.triangles[5][1]];
  return mesh;
}

//! As isosurfaces are where they pass through points of their grid: each vertex several times, within rounding.
TriangleMesh with_slivers_at_vertices(const TriangleMesh& mesh, double size) {
  TriangleMesh result = mesh;
  for (VertexIndex v = 0; v < mesh.points.size(); v += 5) {
    // The triangles of the vertex get one of their own each, and a fan of slivers between them.
    std::vector<std::size_t> around;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      if (std::count(mesh.triangles[t].begin(), mesh.triangles[t].end(), v) > 0) around.push_back(t);
    std::map<VertexIndex, VertexIndex> before,
        after;  // by the neighbour along the edge that two of them share
    for (std::size_t k = 0; k < around.size(); ++k) {
      const auto copy = static_cast<VertexIndex>(result.points.size());
      result.points.push_back(mesh.points[v] + size * Vec3(k % 2 == 0 ? 1 : -1, k % 3 == 0 ? 1 : 0, 0.5));
      Triangle& t = result.triangles[around[k]];
      const auto at = std::find(t.begin(), t.end(), v) - t.begin();
      before[t[(at + 1) % 3]] = copy;
      after[t[(at + 2) % 3]] = copy;
      t[at] = copy;
    }
    for (const auto& [neighbour, copy] : before) {
      result.triangles.push_back({copy, v, after.at(neighbour)});
      result.triangles.push_back({neighbour, copy, after.at(neighbour)});
    }
  }
  return result;
}

TriangleMesh in_floats(TriangleMesh mesh) {
  for (Vec3& p : mesh.points) p = p.cast<float>().cast<double>();
  return mesh;
}

std::vector<Shape> shapes() {
  const TriangleMesh cube = triangulate(test::cube()).mesh;
  const TriangleMesh torus = in_floats(triangulate(test::torus(24, 12)).mesh);
  TriangleMesh moebius;
  for (VertexIndex i = 0; i < 12; ++i) {
    const double u = 2 * std::numbers::pi * i / 12;
    for (const double w : {-0.5, 0.5})
      moebius.points.emplace_back((2 + w * std::cos(u / 2)) * std::cos(u),
                                  (2 + w * std::cos(u / 2)) * std::sin(u), w * std::sin(u / 2));
    const VertexIndex a = 2 * i, b = i == 11 ? 1 : a + 2, c = i == 11 ? 0 : a + 3;
    moebius.triangles.push_back({a, b, a + 1});
    moebius.triangles.push_back({b, c, a + 1});
  }
  TriangleMesh fin = cube;
  fin.points.emplace_back(0.5, -1, -1);
  fin.triangles.push_back({0, 1, 8});
  return {
      {"UV sphere", uv_sphere(20, 10), true, 2},
      {"box with the vertices of each side its own", apart(test::cube()), true, 2},
      {"torus of loose triangles", apart(soup_of(torus)), true, 0},
      {"torus with an edge without length", with_zero_edge(torus), true, 0},
      {"hourglass", test::together(test::tetrahedron(), test::turned(test::tetrahedron(Vec3(2, 2, 2), -1))),
       true, 4},
      {"cubes that share an edge", test::together(cube, triangulate(test::cube(Vec3(1, 1, 0))).mesh), true,
       4},
      {"torus with slivers below doubles' rounding", with_slivers_at_vertices(torus, 1e-15), true, 0},
      {"torus with slivers below floats' rounding", with_slivers_at_vertices(torus, 1e-8), true, 0},
      {"inside-out", test::turned(torus), true, 0},
      {"fin", fin, false, 0},
      {"Moebius strip", in_floats(moebius), false, 0},
      {"crossing", test::together(test::tetrahedron(), test::tetrahedron(Vec3(0.5, 0.25, 0.125))), false, 0}};
}

std::vector<std::string> reasons(const LoadedSurface& surface) {
  std::vector<std::string> names;
  for (const MeshFinding& finding : surface.diagnosis.findings)
    if (severity(finding.problem) == Severity::reason) names.push_back(name(finding.problem));
  return names;
}

using Place = std::array<double, 3>;

//! Triangles by the places of their corners, since vertices are numbered as each format has them.
std::vector<std::array<Place, 3>> places_of(const TriangleMesh& mesh) {
  std::vector<std::array<Place, 3>> places;
  for (const Triangle& t : mesh.triangles) {
    std::array<Place, 3>& triangle = places.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = mesh.points[t[k]];
      for (int d = 0; d < 3; ++d) triangle[k][d] = std::round(p[d] * 1e6) / 1e6 + 0.0;  // as floats have them
    }
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
  }
  std::sort(places.begin(), places.end());
  return places;
}

//! By the program where it writes the format, else from its specification.
void write(const test::TemporaryFolder& folder, const std::string& file, const TriangleMesh& mesh,
           bool text) {
  if (file.ends_with(".glb"))
    folder.file(file, test::glb(mesh));
  else if (file.ends_with(".3mf"))
    folder.file(file, test::file_3mf(mesh));
  else if (file.ends_with(".vtk"))
    folder.file(file, test::vtk_text(mesh));
  else if (file.ends_with(".vtp"))
    folder.file(file, test::vtp_text(mesh));
  else if (file.ends_with(".msh"))
    folder.file(file, test::msh_text(mesh));
  else
    write_mesh(folder / file, mesh, {.text = text});
}

TEST(SameInEveryFormat, ASurfaceIsTheSameMesh) {
  const test::TemporaryFolder folder;
  for (const Shape& shape : shapes()) {
    SCOPED_TRACE(shape.name);
    std::optional<LoadedSurface> first;
    for (const auto& [file, text] : std::vector<std::pair<std::string, bool>>{{"a.off", true},
                                                                              {"a.obj", true},
                                                                              {"a.ply", true},
                                                                              {"b.ply", false},
                                                                              {"a.stl", true},
                                                                              {"b.stl", false},
                                                                              {"a.glb", false},
                                                                              {"a.3mf", true},
                                                                              {"a.vtk", true},
                                                                              {"a.vtp", true},
                                                                              {"a.msh", true}}) {
      SCOPED_TRACE(file);
      write(folder, file, shape.mesh, text);
      const LoadedSurface surface = examine_surface(folder / file);
      EXPECT_EQ(surface.diagnosis.usable(), shape.usable);
      if (shape.usable) {
        EXPECT_EQ(surface.diagnosis.topology.euler_characteristic, shape.euler);
        EXPECT_TRUE(surface.diagnosis.topology.closed());
      }
      if (!first) first = surface;
      EXPECT_EQ(reasons(surface), reasons(*first));
      EXPECT_EQ(surface.mesh.points.size(), first->mesh.points.size());
      EXPECT_EQ(places_of(surface.mesh), places_of(first->mesh));
    }
  }
}

}  // namespace
}  // namespace nanocarbon::mesh
