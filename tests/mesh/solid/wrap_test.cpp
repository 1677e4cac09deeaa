// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/solid/wrap.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/triangulate.h"
#include "support/closed_surface.h"
#include "support/refusal.h"
#include "support/small_meshes.h"

namespace nanocarbon::mesh {
namespace {

using testing::HasSubstr;

//! Every triangle with vertices of its own, in any order and wound either way: no two of them are connected.
PolygonSoup shuffled(const TriangleMesh& mesh) {
  std::vector<Triangle> triangles = mesh.triangles;
  std::mt19937 random(1);
  std::shuffle(triangles.begin(), triangles.end(), random);
  PolygonSoup soup;
  for (const auto& [a, b, c] : triangles) {
    const bool turned = random() % 2 == 0;
    for (const VertexIndex v : {a, turned ? c : b, turned ? b : c}) {
      soup.corners.push_back(static_cast<VertexIndex>(soup.points.size()));
      soup.points.push_back(mesh.points[v]);
    }
    soup.close_face();
  }
  return soup;
}

PolygonSoup without_face(PolygonSoup soup, std::size_t face) {
  PolygonSoup rest;
  rest.points = soup.points;
  for (std::size_t f = 0; f < soup.faces(); ++f) {
    if (f == face) continue;
    rest.corners.insert(rest.corners.end(), soup.face(f).begin(), soup.face(f).end());
    rest.close_face();
  }
  return rest;
}

TEST(Wrap, ASoupOfShuffledTrianglesIsTheTorusThatTheyCameFrom) {
  const TriangleMesh torus = triangulate(test::torus(60, 24)).mesh;  // radii 3 and 1
  const WrapSize size = wrap_size(0.3);
  const Wrapped wrapped = wrap(shuffled(torus), size);
  const MeshTopology topology = test::closed_surface(wrapped.mesh);
  EXPECT_EQ(topology.components, 1u);
  EXPECT_EQ(wrapped.components, 1u);
  EXPECT_EQ(topology.genus, 1);
  double farthest = 0.0;
  for (const Vec3& p : wrapped.mesh.points) {
    const double outside = std::hypot(std::hypot(p.x(), p.y()) - 3.0, p.z()) - 1.0;
    // The torus's triangles lie up to 0.013 inside of the torus.
    EXPECT_GT(outside, size.offset - 0.02);
    farthest = std::max(farthest, outside);
  }
  EXPECT_LE(farthest, wrapped.to_original + 0.02);
  EXPECT_LE(wrapped.to_original, size.size);
  EXPECT_GE(wrapped.to_original, 0.99 * size.offset);
  EXPECT_LE(wrapped.from_original, size.size);
  const double volume = 2.0 * M_PI * M_PI * 3.0;
  EXPECT_GT(signed_volume(wrapped.mesh), 0.97 * volume);
  EXPECT_LT(signed_volume(wrapped.mesh), 1.1 * volume);
}

TEST(Wrap, ABallThatDoesNotFitThroughAMissingFaceLeavesACube) {
  const Wrapped wrapped = wrap(without_face(test::cube(), 1), wrap_size(0.9));
  EXPECT_EQ(test::closed_surface(wrapped.mesh).genus, 0);
  EXPECT_GT(signed_volume(wrapped.mesh), 0.9);
  EXPECT_LT(signed_volume(wrapped.mesh), std::pow(1.0 + 2.0 * 0.03, 3));
}

TEST(Wrap, ABallThatFitsThroughItLeavesTheFiveWalls) {
  const Wrapped wrapped = wrap(without_face(test::cube(), 1), wrap_size(0.2));
  EXPECT_EQ(test::closed_surface(wrapped.mesh).genus, 0);
  EXPECT_GT(signed_volume(wrapped.mesh), 5 * 0.2 / 30);
  EXPECT_LT(signed_volume(wrapped.mesh),
            0.35);  // eight edges inside, which the ball does not reach, are filled
}

TEST(Wrap, ASheetWithoutThicknessBecomesAPlateOfTwoOffsets) {
  const Wrapped wrapped =
      wrap(test::soup({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}}), {0.1, 0.05});
  EXPECT_EQ(test::closed_surface(wrapped.mesh).genus, 0);
  EXPECT_NEAR(signed_volume(wrapped.mesh), 2 * 0.05, 0.3 * 2 * 0.05);
  EXPECT_NEAR(area(wrapped.mesh), 2.0 + 4 * M_PI * 0.05, 0.2);
  EXPECT_NEAR(bounding_box(wrapped.mesh.points).extent().z(), 0.1, 1e-3);
}

// A tube thicker than its ring: the torus crosses itself around the axis, where nothing of it is left.
TEST(Wrap, AMeshThatCrossesItselfIsItsOutside) {
  const Wrapped wrapped = wrap(test::torus(60, 30, 1.0, 1.5), wrap_size(0.3));
  EXPECT_EQ(test::closed_surface(wrapped.mesh).genus, 0);
  // What lies inside is as far from the wrap as the inner cusps are from the dimples at the poles.
  EXPECT_GT(wrapped.from_original, 0.1);
  EXPECT_LT(wrapped.to_original, 0.3);
}

TEST(Wrap, PartsStayApartOrBecomeOneByTheGapBetweenThem) {
  const TriangleMesh two = test::together(test::tetrahedron(), test::tetrahedron({2.5, 0, 0}));
  EXPECT_EQ(test::closed_surface(wrap(soup_of(two), wrap_size(0.1)).mesh).components, 2u);
  EXPECT_EQ(wrap(soup_of(two), wrap_size(3.0)).components, 1u);
}

TEST(Wrap, TheSameMeshGivesTheSameWrap) {
  const PolygonSoup soup = test::cube();
  const Wrapped first = wrap(soup, wrap_size(0.1)), second = wrap(soup, wrap_size(0.1));
  EXPECT_EQ(first.mesh.points, second.mesh.points);
  EXPECT_EQ(first.mesh.triangles, second.mesh.triangles);
}

TEST(Wrap, SaysWhatItCannotDo) {
  EXPECT_THAT(test::refusal(Failure::unsuitable, [] { wrap({}, wrap_size(1.0)); }), HasSubstr("no faces"));
  const PolygonSoup line = test::soup({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}});
  EXPECT_THAT(test::refusal(Failure::unsuitable, [&] { wrap(line, wrap_size(0.1)); }), HasSubstr("area"));
  const std::string fine = test::refusal(Failure::usage, [] { wrap(test::cube(), wrap_size(1e-7)); });
  EXPECT_THAT(fine, HasSubstr("millions of faces"));
  EXPECT_THAT(test::refusal(Failure::usage, [] { wrap(test::cube(), wrap_size(2.0)); }),
              HasSubstr("larger than the whole"));
  EXPECT_THAT(test::refusal(Failure::usage, [] { wrap(test::cube(), {0.1, 1e-6}); }), HasSubstr("offset"));
  EXPECT_THAT(test::refusal(Failure::usage, [] { wrap(test::cube(), {0.1, 5.0}); }), HasSubstr("offset"));
}

}  // namespace
}  // namespace nanocarbon::mesh
