// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/solid/wrap.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/triangulate.h"
#include "nanocarbon/shapes/shapes.h"
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

// Needles, as broken exporters leave them, are no spikes of the wrap; long thin triangles of a surface stay.
TEST(Wrap, HairsAreLeftOutAndToldButThinTrianglesOfASurfaceAreNot) {
  PolygonSoup hairy = soup_of(shapes::make_sphere(1.0, 8));
  for (int i = 0; i < 5; ++i) {
    const Vec3 out = Vec3(std::cos(i), std::sin(i), 0.3 * i).normalized();
    const auto first = static_cast<VertexIndex>(hairy.points.size());
    hairy.points.insert(hairy.points.end(), {0.9 * out, 1.7 * out, 1.4 * out + Vec3(0, 0, 1e-6)});
    hairy.corners.insert(hairy.corners.end(), {first, first + 1, first + 2});
    hairy.close_face();
  }
  const Wrapped bald = wrap(hairy, wrap_size(0.2));
  EXPECT_EQ(bald.hairs, 5u);
  EXPECT_THAT(describe(bald, wrap_size(0.2)), HasSubstr("left out 5 hairs"));
  // The hairs lie far from the wrap; what is told is true of the others.
  EXPECT_THAT(describe(bald, wrap_size(0.2)), HasSubstr("and the rest of the mesh nowhere farther"));
  EXPECT_LT(bald.from_original, 0.1);
  EXPECT_EQ(test::closed_surface(bald.mesh).genus, 0);
  for (const Vec3& p : bald.mesh.points) EXPECT_LT(p.norm(), 1.05);

  // A drum of sides that are a thousandth of its height wide, one of them missing.
  PolygonSoup drum;
  constexpr VertexIndex around = 6000;
  drum.points = {{0, 0, 0}, {0, 0, 6}};
  for (VertexIndex i = 0; i < around; ++i)
    for (const double z : {0.0, 6.0})
      drum.points.emplace_back(std::cos(2 * M_PI * i / around), std::sin(2 * M_PI * i / around), z);
  for (VertexIndex i = 0; i < around; ++i) {
    const VertexIndex a = 2 + 2 * i, b = i + 1 == around ? 2 : a + 2;
    for (const Triangle& t : {Triangle{a, b, b + 1}, {a, b + 1, a + 1}, {0, b, a}, {1, a + 1, b + 1}}) {
      if (i == 37 && t[0] == a && t[1] == b) continue;
      drum.corners.insert(drum.corners.end(), t.begin(), t.end());
      drum.close_face();
    }
  }
  const Wrapped whole = wrap(drum, {0.4, 0.04});
  EXPECT_EQ(whole.hairs, 0u);
  EXPECT_THAT(describe(whole, {0.4, 0.04}), HasSubstr("and the mesh nowhere farther"));
  EXPECT_NEAR(signed_volume(whole.mesh), 6 * M_PI, 0.1 * 6 * M_PI);
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
