// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/scenes/read_gltf.h"

#include <gmock/gmock.h>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/formats/read_mesh.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/triangulate.h"
#include "support/refusal.h"
#include "support/scene_files.h"
#include "support/small_meshes.h"
#include "support/temporary_folder.h"

namespace nanocarbon::mesh {
namespace {

using testing::Contains;
using testing::HasSubstr;

// A box of 1 by 2 by 3 with a corner at the origin, wound outward: volume 6.
TriangleMesh box() {
  TriangleMesh mesh = triangulate(test::cube()).mesh;
  const BoundingBox bounds = bounding_box(mesh.points);
  for (Vec3& p : mesh.points) p = (p - bounds.low).cwiseQuotient(bounds.extent()).cwiseProduct(Vec3(1, 2, 3));
  return mesh;
}

std::string with_scene(const std::string& scene) {
  return test::glb(test::gltf_json(box(), "", scene), test::gltf_buffer(box()));
}

double volume_of(const PolygonSoup& soup) { return signed_volume(triangulate(soup).mesh); }

std::string malformed(const std::string& contents) {
  return test::refusal(Failure::malformed, [&] { parse_mesh(contents, "a.glb"); });
}

TEST(ReadGltf, ABoxHasItsVolumeWhereverItsBufferIs) {
  const test::TemporaryFolder folder;
  folder.file("b c.bin", test::gltf_buffer(box()));
  const std::string inside =
      "\"data:application/octet-stream;base64," + test::base64(test::gltf_buffer(box())) + "\"";
  for (const auto& path :
       {folder.file("a.glb", test::glb(box())), folder.file("a.gltf", test::gltf_json(box(), inside)),
        folder.file("b.gltf", test::gltf_json(box(), "\"b%20c.bin\"")),
        folder.file("a.off", test::glb(box()))}) {
    const PolygonSoup soup = read_mesh(path);
    EXPECT_EQ(soup.points.size(), 8u) << path;
    EXPECT_EQ(soup.faces(), 12u) << path;
    EXPECT_NEAR(volume_of(soup), 6.0, 1e-12) << path;
    EXPECT_EQ(soup.unit, "metre");
  }
}

// glTF 2.0, 3.5.3: children are placed by their parents; T * R * S; matrices by columns.
TEST(ReadGltf, NodesStandWhereTheirParentsPutThem) {
  const PolygonSoup soup = parse_mesh(with_scene(R"("scene": 0, "scenes": [{"nodes": [0]}], "nodes": [
        {"children": [1, 2], "translation": [10, 0, 0]},
        {"mesh": 0, "matrix": [0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1]},
        {"mesh": 0, "rotation": [0, 0, 0.7071067811865476, 0.7071067811865476], "scale": [2, 1, 1], "translation": [0, 0, 100]},
        {"mesh": 0}])"),
                                      "a.glb");
  ASSERT_EQ(soup.points.size(), 16u);  // the fourth node is not in the scene
  const BoundingBox first = bounding_box({soup.points.data(), 8}),
                    second = bounding_box({soup.points.data() + 8, 8});
  const bool in_order = first.low.z() < 50;
  const BoundingBox& turned = in_order ? first : second;
  const BoundingBox& scaled = in_order ? second : first;
  // x goes to y and y to -x: from (0..1, 0..2, 0..3) to (-2..0, 0..1, 0..3), moved by (5, 6, 7) and (10, 0, 0).
  EXPECT_NEAR((turned.low - Vec3(13, 6, 7)).norm(), 0, 1e-9);
  EXPECT_NEAR((turned.high - Vec3(15, 7, 10)).norm(), 0, 1e-9);
  EXPECT_NEAR((scaled.low - Vec3(8, 0, 100)).norm(), 0, 1e-9);
  EXPECT_NEAR((scaled.high - Vec3(10, 2, 103)).norm(), 0, 1e-9);
  EXPECT_NEAR(volume_of(soup), 6 + 12, 1e-9);
  EXPECT_THAT(soup.notes, Contains(HasSubstr("placed 2 objects")));
}

// 3.7.4: where the determinant is negative, the winding is turned.
TEST(ReadGltf, AReflectionDoesNotTurnItInsideOut) {
  const PolygonSoup soup = parse_mesh(
      with_scene(R"("scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0, "scale": [1, -1, 1]}])"), "a.glb");
  EXPECT_NEAR(volume_of(soup), 6, 1e-12);
}

TEST(ReadGltf, FilesWithoutASceneGiveAllTheyHave) {
  EXPECT_EQ(parse_mesh(with_scene(R"("nodes": [{"mesh": 0}, {"children": [0]}])"), "a.glb").faces(), 12u);
}

// A square of quantised positions, four bytes apart, and its indices; element 3 stands at (5, 6, 7) where sparse.
std::string square(const std::string& primitive, const std::string& accessor) {
  const std::string buffer(
      "\0\0\0\0\x7f\0\0\0\0\x7f\0\0\x7f\x7f\0\0"
      "\0\1\2\3"
      "\3\5\6\7",
      24);
  const std::string json = R"({"asset": {"version": "2.0"}, "extensionsRequired": ["KHR_mesh_quantization"],
    "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, PRIMITIVE}]}],
    "accessors": [{"bufferView": 0, "componentType": 5120, "count": 4, "type": "VEC3"ACCESSOR},
                  {"bufferView": 1, "componentType": 5121, "count": 4, "type": "SCALAR"}],
    "bufferViews": [{"buffer": 0, "byteLength": 16, "byteStride": 4}, {"buffer": 0, "byteOffset": 16, "byteLength": 4},
                    {"buffer": 0, "byteOffset": 20, "byteLength": 1}, {"buffer": 0, "byteOffset": 21, "byteLength": 3}],
    "buffers": [{"byteLength": 24}]})";
  return test::glb(test::replaced(test::replaced(json, "PRIMITIVE", primitive), "ACCESSOR", accessor),
                   buffer);
}

TEST(ReadGltf, FansAndStripsAreTriangles) {
  const PolygonSoup strip = parse_mesh(square(R"("mode": 5, "indices": 1)", ""), "a.glb");
  EXPECT_THAT(strip.corners, testing::ElementsAre(0, 1, 2, 1, 3, 2));
  const PolygonSoup fan = parse_mesh(square(R"("mode": 6)", ""), "a.glb");
  EXPECT_THAT(fan.corners, testing::ElementsAre(0, 1, 2, 0, 2, 3));
  EXPECT_THAT(malformed(square(R"("mode": 1)", "")), HasSubstr("no triangles"));
}

TEST(ReadGltf, PositionsMayBeQuantisedAndSparse) {
  EXPECT_EQ(parse_mesh(square(R"("mode": 6)", ""), "a.glb").points[3], Vec3(127, 127, 0));
  EXPECT_EQ(parse_mesh(square(R"("mode": 6)", R"(, "normalized": true)"), "a.glb").points[3], Vec3(1, 1, 0));
  const std::string sparse = R"(, "sparse": {"count": 1, "indices": {"bufferView": 2, "componentType": 5121},
    "values": {"bufferView": 3}})";
  const PolygonSoup soup = parse_mesh(square(R"("mode": 6)", sparse), "a.glb");
  EXPECT_EQ(soup.points[2], Vec3(0, 127, 0));
  EXPECT_EQ(soup.points[3], Vec3(5, 6, 7));
}

TEST(ReadGltf, VerticesOfOneNodeAtOnePlaceAreOne) {
  TriangleMesh loose;
  for (const Triangle& t : box().triangles) {
    const auto first = static_cast<VertexIndex>(loose.points.size());
    for (const VertexIndex v : t) loose.points.push_back(box().points[v]);
    loose.triangles.push_back({first, first + 1, first + 2});
  }
  const PolygonSoup soup = parse_mesh(test::glb(loose), "a.glb");
  EXPECT_EQ(soup.points.size(), 8u);
  EXPECT_THAT(soup.notes, Contains(HasSubstr("joined 28 glTF vertices")));
}

TEST(ReadGltf, WhatIsWrongIsNamed) {
  const std::string good = test::gltf_json(box(), ""), buffer = test::gltf_buffer(box());
  const auto bad = [&](std::string_view from, std::string_view to) {
    return malformed(test::glb(test::replaced(good, from, to), buffer));
  };
  EXPECT_THAT(bad("\"2.0\"", "\"1.0\""), HasSubstr("a.glb: asset: the version of glTF is '1.0'"));
  EXPECT_THAT(bad("\"count\": 8", "\"count\": 9"),
              HasSubstr("accessors[0]: it has 9 elements, but its buffer view holds 8"));
  EXPECT_THAT(bad("\"count\": 8", "\"count\": 18446744073709551615"), HasSubstr("accessors[0]"));
  EXPECT_THAT(bad("\"POSITION\": 0", "\"POSITION\": 7"),
              HasSubstr("accessors[7]: there is no such element of 2"));
  EXPECT_THAT(bad("\"byteLength\": 240", "\"byteLength\": 241"), HasSubstr("buffers[0]"));
  EXPECT_THAT(bad("\"bufferView\": 0, ", ""), HasSubstr("no data"));
  EXPECT_THAT(bad("[{\"mesh\": 0}]", "[{\"mesh\": 3}]"), HasSubstr("meshes[3]"));
  EXPECT_THAT(bad("[{\"mesh\": 0}]", "[{\"children\": [0]}]"),
              HasSubstr("nodes[0]: the node is in the scene more than once"));
  EXPECT_THAT(bad("[{\"mesh\": 0}]", "[{\"mesh\": 0, \"rotation\": [0, 0, 0, 0]}]"),
              HasSubstr("nodes[0]: its rotation is zero"));
  EXPECT_THAT(bad("\"asset\"", "\"extensionsRequired\": [\"KHR_draco_mesh_compression\"], \"asset\""),
              HasSubstr("Draco"));
  EXPECT_THAT(bad("\"asset\"", "\"asset"), HasSubstr("JSON"));
  std::string far = buffer;
  far[8 * 12 + 1] = '\x01';  // the first triangle's first vertex: 256 and more
  EXPECT_THAT(malformed(test::glb(good, far)), HasSubstr("meshes[0].primitives[0]: a triangle uses vertex"));
  std::string odd = buffer;
  odd.replace(0, 4, std::string("\0\0\xc0\x7f", 4));
  EXPECT_THAT(malformed(test::glb(good, odd)),
              HasSubstr("accessors[0]: a coordinate of vertex 0 is not finite"));
  EXPECT_THAT(malformed(test::glb(good, buffer).substr(0, 400)), HasSubstr("a chunk of the GLB file has"));
  const std::string beside = test::refusal(
      Failure::unreadable, [&] { parse_mesh(test::gltf_json(box(), "\"none.bin\""), "a.gltf"); });
  EXPECT_THAT(beside, HasSubstr("a.gltf: buffers[0]: the file 'none.bin' is not there"));
}

}  // namespace
}  // namespace nanocarbon::mesh
