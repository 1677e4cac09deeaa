// SPDX-License-Identifier: GPL-2.0-or-later
// Surfaces of scalar fields, from files of every format that holds some.
#include "nanocarbon/mesh/grids/isosurface.h"

#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <numbers>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/formats/load_surface.h"
#include "nanocarbon/mesh/formats/read_mesh.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "support/grid_files.h"
#include "support/refusal.h"
#include "support/scene_files.h"
#include "support/temporary_folder.h"

namespace nanocarbon::mesh {
namespace {

using std::numbers::pi;
using testing::Contains;
using testing::HasSubstr;

test::SampledField field_of(std::size_t count, double step, double low,
                            std::function<double(const Vec3&)> value) {
  return {{count, count, count}, Vec3::Constant(low), step * Mat3::Identity(), std::move(value)};
}

// 10 at the centre, falling by one for each unit of length: 6 on the sphere of radius 4.
test::SampledField ball() {
  return field_of(21, 0.5, -5, [](const Vec3& p) { return 10 - p.norm(); });
}

LoadedSurface loaded(const std::string& name, const std::string& contents, const FieldRequest& field,
                     const CellRequest& cell = {}) {
  const test::TemporaryFolder folder;
  return load_surface(folder.file(name, contents), {.cell = cell, .field = field});
}

CellRequest periodic(std::array<bool, 3> directions) {
  CellRequest request;
  request.periodic = directions;
  return request;
}

void expect_sphere(const LoadedSurface& surface) {
  EXPECT_TRUE(surface.diagnosis.topology.closed());
  EXPECT_EQ(surface.diagnosis.topology.euler_characteristic, 2);
  for (const Vec3& p : surface.mesh.points) EXPECT_NEAR(p.norm(), 4, 0.01);
  EXPECT_NEAR(signed_volume(surface.mesh), 4.0 / 3 * pi * 64, 5);
}

TEST(Isosurface, ABallIsASphereInEveryFormat) {
  const std::map<std::string, std::string> files = {
      {"a.cube", test::cube_text(ball())}, {"b.cube", test::cube_text(ball(), true)},
      {"a.mrc", test::mrc_bytes(ball())},  {"b.mrc", test::mrc_bytes(ball(), true, {3, 1, 2})},
      {"a.vti", test::vti_text(ball())},   {"a.vtk", test::structured_points_text(ball())}};
  std::optional<LoadedSurface> first;
  for (const auto& [name, contents] : files)
    for (const std::string& file : {name, std::string("without_extension")}) {
      SCOPED_TRACE(name + " " + file);
      const LoadedSurface surface = loaded(file, contents, {.level = 6});
      expect_sphere(surface);
      if (!first) first = surface;
      ASSERT_EQ(surface.mesh.triangles, first->mesh.triangles);
      for (std::size_t i = 0; i < surface.mesh.points.size(); ++i)
        EXPECT_NEAR((surface.mesh.points[i] - first->mesh.points[i]).norm(), 0, 1e-4);
      const std::string unit = name == "a.cube" ? "Bohr" : name.find("v") == name.npos ? "Angstrom" : "";
      EXPECT_EQ(surface.unit, unit);
    }
}

// Schwarz's P surface has genus 3 in its cell, whether the file has the last plane, which is the first again, or not.
TEST(Isosurface, APeriodicFieldHasAPeriodicSurface) {
  const auto p = [](const Vec3& x) { return std::cos(x.x()) + std::cos(x.y()) + std::cos(x.z()); };
  for (const std::size_t count : {16u, 17u})
    for (const std::string name : {"p.cube", "p.vti"}) {
      SCOPED_TRACE(name + " " + std::to_string(count));
      const test::SampledField field = field_of(count, 2 * pi / 16, 0, p);
      const LoadedSurface surface =
          loaded(name, name == "p.cube" ? test::cube_text(field) : test::vti_text(field), {.level = 0.1},
                 periodic({true, true, true}));
      ASSERT_TRUE(surface.cell);
      const auto again =
          Contains(HasSubstr("the last values along b are the first again: the cell has 16 steps"));
      if (count == 17) {
        EXPECT_THAT(surface.repairs, again);
      } else {
        EXPECT_THAT(surface.repairs, testing::Not(again));
      }
      EXPECT_NEAR(surface.cell->vectors(1, 1), 2 * pi, 1e-9);
      const MeshTopology topology = mesh_topology(surface.mesh);
      EXPECT_TRUE(topology.closed());
      EXPECT_EQ(topology.components, 1u);
      EXPECT_EQ(topology.genus, 3);
      for (const Vec3& x : surface.mesh.points) EXPECT_NEAR(p(x), 0.1, 0.02);
    }
}

// Vacuum on both sides of a slab, the same to all digits, is no sign that the last plane is the first.
TEST(Isosurface, TheVacuumBesideASlabIsPartOfItsCell) {
  test::SampledField slab = field_of(12, 0.5, 0, [](const Vec3& x) {
    return std::max(0.0, 1 + 0.2 * std::cos(2 * pi * x.x() / 6) - std::abs(x.z() - 3));
  });
  const LoadedSurface surface =
      loaded("a.cube", test::cube_text(slab), {.level = 0.5}, periodic({true, true, true}));
  EXPECT_NEAR(surface.cell->vectors(2, 2), 6, 1e-9);
  EXPECT_NEAR(surface.cell->vectors(0, 0), 6, 1e-9);
  EXPECT_EQ(mesh_topology(surface.mesh).components, 2u);
}

// A skewed cell, as of a hexagonal crystal: a sheet along two of its edges.
TEST(Isosurface, CellsMayBeSkewed) {
  test::SampledField field = field_of(12, 0.5, 0, [](const Vec3& x) { return std::abs(x.z() - 2.75); });
  field.steps.col(1) = Vec3(-0.25, 0.5 * std::sqrt(0.75), 0);
  const LoadedSurface surface =
      loaded("a.cube", test::cube_text(field), {.level = 1}, periodic({true, true, false}));
  EXPECT_EQ(mesh_topology(surface.mesh).components,
            2u);  // not closed off above and below: all is above 1 there
  EXPECT_NEAR(area(surface.mesh), 2 * 36 * std::sqrt(0.75), 0.01);
  for (const Vec3& x : surface.mesh.points) EXPECT_NEAR(std::abs(x.z() - 2.75), 1, 0.05);
}

// The half space z > 1.3 in a box: closed half a step outside of the outermost values, or left open.
TEST(Isosurface, EndsAtTheFieldsEdgeAsAsked) {
  const std::string contents = test::vti_text(field_of(13, 0.5, 0, [](const Vec3& x) { return x.z(); }));
  const double side = 6.5, above = 6.25 - 1.3, below = 1.3 + 0.25;
  const LoadedSurface top = loaded("a.vti", contents, {.level = 1.3});
  EXPECT_TRUE(top.diagnosis.topology.closed());
  EXPECT_NEAR(signed_volume(top.mesh), side * side * above, 0.04 * side * side * above);
  const LoadedSurface bottom = loaded("a.vti", contents, {.level = 1.3, .edge = FieldEdge::below});
  EXPECT_TRUE(bottom.diagnosis.topology.closed());
  EXPECT_NEAR(signed_volume(bottom.mesh), side * side * below, 0.06 * side * side * below);
  const LoadedSurface open = loaded("a.vti", contents, {.level = 1.3, .edge = FieldEdge::open});
  EXPECT_EQ(open.diagnosis.topology.boundary_loops, 1u);
  EXPECT_NEAR(area(open.mesh), 36, 0.01);
}

// What is outside of a ball, closed off at the box, is asked for by name.
TEST(Isosurface, WhatIsAboveMayBeClosedOffAllTheSame) {
  const std::string distance = test::vti_text(field_of(13, 0.5, -3, [](const Vec3& x) { return x.norm(); }));
  const auto components = [&](FieldEdge edge) {
    return loaded("a.vti", distance, {.level = 2, .edge = edge}).diagnosis.topology.components;
  };
  EXPECT_EQ(components(FieldEdge::closed), 1u);
  EXPECT_EQ(components(FieldEdge::below), 1u);
  EXPECT_EQ(components(FieldEdge::above), 2u);
}

TEST(Isosurface, WhatCannotBeMadeIsSaidSo) {
  const std::string cube = test::cube_text(ball());
  const auto usage = [&](const std::string& contents, const FieldRequest& field) {
    return test::refusal(Failure::usage, [&] { parse_mesh(contents, "a.cube", field); });
  };
  EXPECT_THAT(usage(cube, {}),
              HasSubstr("a.cube: the file holds a scalar field of 21 x 21 x 21 values; give the value "
                        "on the surface with --level: they are between 1.3"));
  EXPECT_THAT(usage(cube, {.level = 10.5}), HasSubstr("has no surface at 10.5"));
  EXPECT_THAT(usage(test::vti_text(ball()), {.level = 6, .array = "mass"}), HasSubstr("--field: density"));
  EXPECT_THAT(usage("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", {.level = 1}), HasSubstr("holds a mesh"));
  std::string map = test::mrc_bytes(ball());
  map[28] = 40;  // its cell has 40 steps along a
  EXPECT_THAT(usage(map, {.level = 6, .periodic = {true, false, false}}),
              HasSubstr("has 21 values along a, but its cell 40 steps"));
  const auto malformed = [&](const std::string& contents) {
    return test::refusal(Failure::malformed, [&] { parse_mesh(contents, "a.cube", {.level = 6}); });
  };
  EXPECT_THAT(malformed(cube.substr(0, cube.size() - 200)), HasSubstr("a.cube:"));
  EXPECT_THAT(malformed(test::replaced(cube, " 21 0 0.5 0", " 21 0 0 0")), HasSubstr("span no volume"));
  EXPECT_THAT(malformed(test::replaced(cube, " 6 6.0 0.0", " 6 6.0 x")),
              HasSubstr("a.cube:7: the number of an atom 'x'"));
  EXPECT_THAT(malformed(test::mrc_bytes(ball()).substr(0, 5000)),
              HasSubstr("the file ends after 994 of 9261 values"));
  map = test::mrc_bytes(ball());
  map.replace(64, 12, std::string("\0\0\0\x80\2\0\0\0\2\0\0\0", 12));
  EXPECT_THAT(malformed(map), HasSubstr("the axes of the map are -2147483648, 2 and 2"));
}

// Two orbitals in one file, their values in turn.
// A damaged length in a header once meant 48 million nodes, and minutes, for sixty values.
TEST(Isosurface, StepsOfVeryDifferentLengthsDoNotMakeItHuge) {
  const test::SampledField flat = {
      {4, 3, 5}, Vec3::Zero(), Vec3(0.5, 0.5, 1e-7).asDiagonal(), [](const Vec3& p) {
        return p.x() + p.y();
      }};
  FieldRequest field;
  field.level = 0.6;
  const PolygonSoup surface = parse_mesh(test::mrc_bytes(flat), "flat.mrc", field);
  EXPECT_GT(surface.points.size(), 0u);
  EXPECT_LT(surface.points.size(), 2 * 64u * 60);
}

TEST(Isosurface, OneOfSeveralFieldsIsNamed) {
  std::string cube = "two\norbitals\n-1 0 0 0\n 2 1 0 0\n 2 0 1 0\n 2 0 0 1\n 6 6 0 0 0\n 2 7 9\n";
  for (int i = 0; i < 8; ++i) cube += i == 0 ? "1 5 " : "0 0 ";
  EXPECT_THAT(test::refusal(Failure::usage, [&] { parse_mesh(cube, "a.cube", {.level = 3}); }),
              HasSubstr("7, 9"));
  EXPECT_THAT(test::refusal(Failure::usage, [&] { parse_mesh(cube, "a.cube", {.level = 3, .array = "7"}); }),
              HasSubstr("between 0 and 1"));
  EXPECT_GT(parse_mesh(cube, "a.cube", {.level = 3, .array = "9"}).faces(), 0u);
}

}  // namespace
}  // namespace nanocarbon::mesh
