// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/solid/advice.h"

#include <gmock/gmock.h>

#include <cmath>

#include "nanocarbon/mesh/repair/repair_surface.h"
#include "nanocarbon/mesh/solid/unite.h"
#include "nanocarbon/mesh/solid/wrap.h"
#include "nanocarbon/mesh/triangulate.h"
#include "nanocarbon/shapes/shapes.h"
#include "support/closed_surface.h"
#include "support/small_meshes.h"

namespace nanocarbon::mesh {
namespace {

using testing::StartsWith;

std::string advised(const PolygonSoup& soup) {
  const std::optional<MeshAdvice> advice = advise(soup);
  return advice ? advice->options : "nothing";
}

//! What the advised wrap of a mesh is.
Wrapped wrapped_as_advised(const PolygonSoup& soup) {
  const std::string options = advised(soup);
  EXPECT_THAT(options, StartsWith("--wrap "));
  if (!options.starts_with("--wrap ")) return {};
  WrapSize size = wrap_size(std::stod(options.substr(7)));
  if (const auto comma = options.find(','); comma != options.npos)
    size.offset = std::stod(options.substr(comma + 1));
  return wrap(soup, size);
}

TriangleMesh two_spheres() {
  const TriangleMesh sphere = shapes::make_sphere(1.0, 3);
  TriangleMesh other = sphere;
  for (Vec3& point : other.points) point += Vec3(1.2, 0.01, 0.02);
  return test::together(sphere, other);
}

TEST(Advice, SolidsThatOverlapAreUnited) { EXPECT_EQ(advised(soup_of(two_spheres())), "--unite"); }

// As STL files have them: boxes that overlap in a row, so that faces of one lie on faces of the other.
TEST(Advice, SolidsThatShareFacesAreUnitedInFormatsWithoutSharedVertices) {
  const TriangleMesh boxes =
      test::together(triangulate(test::cube()).mesh, triangulate(test::cube({0.5, 0, 0})).mesh);
  PolygonSoup faces;
  for (const Triangle& t : boxes.triangles) {
    for (const VertexIndex v : t) {
      faces.corners.push_back(static_cast<VertexIndex>(faces.points.size()));
      faces.points.push_back(boxes.points[v]);
    }
    faces.close_face();
  }
  EXPECT_EQ(advised(faces), "--unite");
}

TEST(Advice, TheirSmallHolesAreClosedFirst) {
  TriangleMesh mesh = two_spheres();
  mesh.triangles.erase(mesh.triangles.begin());
  const std::string options = advised(soup_of(mesh));
  ASSERT_THAT(options, StartsWith("--close-holes "));
  EXPECT_THAT(options, testing::EndsWith(" --unite"));
  const RepairedSurface closed = repair_surface(soup_of(mesh), std::stod(options.substr(14)));
  EXPECT_EQ(test::closed_surface(unite(closed.mesh).mesh).components, 1u);
}

// Two rooms of a house: the wall between them has edges with three faces.
TEST(Advice, ASolidWithAWallInsideIsWrapped) {
  PolygonSoup house = test::cube();
  PolygonSoup second = test::cube({1, 0, 0});
  for (std::size_t face = 0; face < second.faces(); ++face) {
    const auto corners = second.face(face);
    if (std::all_of(corners.begin(), corners.end(),
                    [&](VertexIndex v) { return second.points[v].x() == 1.0; }))
      continue;
    for (const VertexIndex v : corners) house.corners.push_back(v + 8);
    house.close_face();
  }
  house.points.insert(house.points.end(), second.points.begin(), second.points.end());
  ASSERT_FALSE(repair_surface(house).diagnosis.usable());
  const Wrapped wrapped = wrapped_as_advised(house);
  EXPECT_EQ(test::closed_surface(wrapped.mesh).genus, 0);
  EXPECT_NEAR(signed_volume(wrapped.mesh), 2.0, 0.1);
}

// With no two sides and no thickness: its surface, once it has one, is a torus.
TEST(Advice, AMoebiusStripBecomesABandThatIsThickEnoughToSee) {
  PolygonSoup strip;
  constexpr VertexIndex around = 40;
  for (VertexIndex i = 0; i < around; ++i) {
    const double u = 2 * M_PI * i / around;
    for (const double t : {-0.4, 0.4}) {
      const double r = 2.0 + t * std::cos(u / 2);
      strip.points.emplace_back(r * std::cos(u), r * std::sin(u), t * std::sin(u / 2));
    }
    const bool last = i + 1 == around;
    const VertexIndex a = 2 * i, b = a + 1, c = last ? 1 : a + 2, d = last ? 0 : a + 3;
    strip.corners.insert(strip.corners.end(), {a, b, d, c});
    strip.close_face();
  }
  ASSERT_FALSE(repair_surface(strip).diagnosis.usable());
  const Wrapped wrapped = wrapped_as_advised(strip);
  EXPECT_EQ(test::closed_surface(wrapped.mesh).genus, 1);
  EXPECT_GT(2.0 * signed_volume(wrapped.mesh) / area(wrapped.mesh), 0.1);
}

// A box with partitions and no lid, which no ball fits into that fits between them: not a shell of walls, whose corners
// are filled so that it is thicker than two offsets.
TEST(Advice, WallsOfAnOpenBoxAreToldToBeAShell) {
  PolygonSoup box;
  const auto wall = [&](const Vec3& at, const Vec3& u, const Vec3& v) {
    const auto first = static_cast<VertexIndex>(box.points.size());
    box.points.insert(box.points.end(), {at, at + u, at + u + v, at + v});
    box.corners.insert(box.corners.end(), {first, first + 1, first + 2, first + 3});
    box.close_face();
  };
  for (int i = 0; i <= 4; ++i) {
    wall({double(i), 0, 0}, {0, 4, 0}, {0, 0, 4});
    wall({0, double(i), 0}, {4, 0, 0}, {0, 0, 4});
  }
  wall({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
  ASSERT_FALSE(repair_surface(box).diagnosis.usable());
  const std::optional<MeshAdvice> advice = advise(box);
  ASSERT_TRUE(advice);
  const Wrapped wrapped = wrapped_as_advised(box);
  const double thickness = 2.0 * signed_volume(wrapped.mesh) / area(wrapped.mesh);
  EXPECT_EQ(thickness < 1.0, advice->outcome.find("as a shell") != std::string::npos) << advice->options;
  // Not a foil that a molecule could not be: thicker than a fortieth of the box.
  EXPECT_GT(thickness, 0.1) << advice->options;
}

TEST(Advice, IsNotGivenWithoutNeed) {
  EXPECT_EQ(advised(test::cube()), "nothing");
  EXPECT_EQ(advised({}), "nothing");
  EXPECT_EQ(advised(test::soup({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}})), "nothing");
}

}  // namespace
}  // namespace nanocarbon::mesh
