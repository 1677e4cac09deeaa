// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/formats/write_mesh.h"

#include <gmock/gmock.h>

#include <limits>

#include "nanocarbon/mesh/formats/read_mesh.h"
#include "nanocarbon/mesh/triangulate.h"
#include "support/refusal.h"
#include "support/small_meshes.h"
#include "support/temporary_folder.h"

namespace nanocarbon::mesh {
namespace {

using testing::HasSubstr;

class WriteMesh : public testing::Test {
 protected:
  void SetUp() override {
    mesh = triangulate(test::torus(13, 7)).mesh;
    mesh.points[0] = Vec3(0.1 + 0.2, -1.0 / 3.0, 1e-300);
    mesh.points[1] = Vec3(std::numeric_limits<double>::denorm_min(), 123456789012345678.0, -9.87654321e49);
  }

  test::TemporaryFolder folder;
  TriangleMesh mesh;
};

void expect_same(const PolygonSoup& read, const TriangleMesh& written) {
  EXPECT_EQ(read.points, written.points);
  EXPECT_EQ(read.corners, soup_of(written).corners);
  EXPECT_EQ(read.offsets, soup_of(written).offsets);
}

TEST_F(WriteMesh, WhatIsReadBackIsTheSameToTheLastBit) {
  for (const std::string name : {"a.off", "a.obj", "a.ply", "a.OFF"})
    for (const bool text : {true, false}) {
      write_mesh(folder / name, mesh, {text, nullptr});
      const PolygonSoup read = read_mesh(folder / name);
      expect_same(read, mesh);
      EXPECT_THAT(read.notes, testing::IsEmpty()) << name;
    }
}

TEST_F(WriteMesh, WithColoursItIsStillTheSame) {
  const MeshColours colours = colours_by_quality(mesh, 0.5, 1.0);
  for (const std::string name : {"a.off", "a.ply"})
    for (const bool text : {true, false}) {
      write_mesh(folder / name, mesh, {text, &colours});
      expect_same(read_mesh(folder / name), mesh);
    }
}

TEST_F(WriteMesh, StlNumbersVerticesAnewAndInBinaryHoldsFloats) {
  write_mesh(folder / "a.stl", mesh, {true, nullptr});
  const PolygonSoup text = read_mesh(folder / "a.stl");
  ASSERT_EQ(text.corners.size(), 3 * mesh.triangles.size());
  for (std::size_t i = 0; i < text.corners.size(); ++i)
    EXPECT_EQ(text.points[text.corners[i]], mesh.points[mesh.triangles[i / 3][i % 3]]);

  mesh = triangulate(test::torus(13, 7)).mesh;
  write_mesh(folder / "a.stl", mesh);
  EXPECT_EQ(std::filesystem::file_size(folder / "a.stl"), 84 + 50 * mesh.triangles.size());
  const PolygonSoup binary = read_mesh(folder / "a.stl");
  EXPECT_EQ(binary.points.size(), mesh.points.size());
  for (std::size_t i = 0; i < binary.corners.size(); ++i)
    EXPECT_EQ(binary.points[binary.corners[i]],
              mesh.points[mesh.triangles[i / 3][i % 3]].cast<float>().cast<double>());
}

TEST_F(WriteMesh, ColoursByQualityAreThoseOfTheThesis) {
  // All edges of the tetrahedron are sqrt(8) long and all its valences are 3.
  const TriangleMesh small = test::tetrahedron();
  const double edge = std::sqrt(8.0);
  const auto only_colour = [&](double low, double high) {
    const MeshColours colours = colours_by_quality(small, low, high);
    EXPECT_EQ(colours.edges.size(), 6u);
    EXPECT_EQ(colours.vertices.size(), 4u);
    for (const ColouredEdge& e : colours.edges) EXPECT_EQ(e.colour, colours.edges[0].colour);
    return colours.edges[0].colour;
  };
  const auto strongest = [](const Rgb& c) { return std::max_element(c.begin(), c.end()) - c.begin(); };
  EXPECT_EQ(strongest(only_colour(edge + 1, edge + 2)), 1);              // short: green
  EXPECT_EQ(strongest(only_colour(edge - 1, edge + 1)), 2);              // good: blue
  EXPECT_EQ(strongest(only_colour(edge - 2, edge - 1)), 0);              // long: red
  EXPECT_EQ(strongest(colours_by_quality(small, 1, 2).vertices[0]), 1);  // valence 3: green
  TriangleMesh regular;  // a torus with all diagonals alike, so that every valence is 6
  const PolygonSoup quads = test::torus(30, 10);
  regular.points = quads.points;
  for (std::size_t f = 0; f < quads.faces(); ++f) {
    const auto q = quads.face(f);
    regular.triangles.push_back({q[0], q[1], q[2]});
    regular.triangles.push_back({q[0], q[2], q[3]});
  }
  for (const Rgb& colour : colours_by_quality(regular, 1, 2).vertices) EXPECT_EQ(strongest(colour), 2);
}

TEST_F(WriteMesh, ThePlyHeaderDeclaresTheColours) {
  const MeshColours colours = colours_by_quality(test::tetrahedron(), 1, 2);
  write_mesh(folder / "a.ply", test::tetrahedron(), {true, &colours});
  const std::string text = test::contents_of(folder / "a.ply");
  EXPECT_THAT(text, HasSubstr("element vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
                              "property uchar red\n"));
  EXPECT_THAT(text,
              HasSubstr("element edge 6\nproperty int vertex1\nproperty int vertex2\nproperty uchar red\n"));
}

TEST_F(WriteMesh, OtherExtensionsAreRefused) {
  EXPECT_THAT(test::refusal(Failure::usage, [&] { write_mesh(folder / "a.txt", mesh); }),
              HasSubstr(".off, .obj"));
  EXPECT_THAT(test::refusal(Failure::unwritable, [&] { write_mesh(folder / "no/a.off", mesh); }),
              HasSubstr("cannot be written"));
}

}  // namespace
}  // namespace nanocarbon::mesh
