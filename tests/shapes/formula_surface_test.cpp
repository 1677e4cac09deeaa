// SPDX-License-Identifier: GPL-2.0-or-later
// Surfaces given by formulas.
#include "nanocarbon/shapes/formula_surface.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/mesh/periodic_mesh.h"
#include "nanocarbon/shapes/periodic_shapes.h"

namespace nanocarbon::shapes {
namespace {

constexpr double pi = std::numbers::pi;

FormulaSurface of(const std::string& formula, double period = 2 * pi,
                  std::array<bool, 3> periodic = {true, true, true}) {
  FormulaSurface surface;
  surface.formula = formula;
  surface.cell = orthogonal_cell(Vec3::Constant(period), periodic);
  return surface;
}

std::string refusal(const FormulaSurface& surface) {
  try {
    make_formula_surface(surface);
  } catch (const UserError& error) {
    EXPECT_EQ(error.failure(), Failure::usage);
    return error.what();
  }
  return "made";
}

TEST(FormulaSurface, IsTheSameAsTheSurfaceThatIsKnownByName) {
  MinimalSurface known;
  known.kind = MinimalSurface::Kind::gyroid;
  known.period = 2 * pi;
  known.edge = 2 * pi / 25;
  const TriangleMesh named = make_minimal_surface(known),
                     made = make_formula_surface(of("sin(x)*cos(y) + sin(y)*cos(z) + sin(z)*cos(x)"));
  const mesh::MeshTopology topology = mesh::mesh_topology(made);
  EXPECT_EQ(topology.genus, 5);  // of the cubic cell
  EXPECT_EQ(topology.boundary_loops, 0u);
  EXPECT_EQ(mesh::wrapping_ranks(made, topology), std::vector<int>{3});
  EXPECT_NEAR(mesh::area(made), mesh::area(named), 1e-3 * mesh::area(named));
}

TEST(FormulaSurface, KnowsPowersConditionsAndConstants) {
  EXPECT_NEAR(shape_of_formula("x^2 + 2*y - sqrt(z) + pi")(Vec3(3, 1, 4)), 9 + 2 - 2 + pi, 1e-14);
  EXPECT_EQ(shape_of_formula("x > 1 ? 5 : min(y, z)")(Vec3(0, 7, 6)), 6);
}

TEST(FormulaSurface, ASheetIsPeriodicInTwoDirections) {
  const TriangleMesh sheet = make_formula_surface(of("z - 0.3*sin(x)*sin(y)", 2 * pi, {true, true, false}));
  const mesh::MeshTopology topology = mesh::mesh_topology(sheet);
  EXPECT_EQ(topology.boundary_loops, 0u);
  EXPECT_EQ(mesh::wrapping_ranks(sheet, topology), std::vector<int>{2});
  for (const Vec3& p : sheet.points) EXPECT_NEAR(p.z(), 0.3 * std::sin(p.x()) * std::sin(p.y()), 1e-6);
}

TEST(FormulaSurface, ALevelAndAShell) {
  FormulaSurface ball = of("x^2 + y^2 + z^2", 5, {false, false, false});
  ball.level = 4;
  ball.edge = 0.15;
  const TriangleMesh sphere = make_formula_surface(ball);
  EXPECT_FALSE(sphere.space.periodic());
  EXPECT_NEAR(mesh::signed_volume(sphere), 4.0 / 3 * pi * 8, 0.3);
  ball.thickness = 0.4;
  const TriangleMesh shell = make_formula_surface(ball);
  EXPECT_EQ(mesh::mesh_topology(shell).components, 2u);
  EXPECT_NEAR(mesh::area(shell), 4 * pi * (1.8 * 1.8 + 2.2 * 2.2), 0.02 * mesh::area(shell));
  EXPECT_NEAR(mesh::signed_volume(shell), 4.0 / 3 * pi * (std::pow(2.2, 3) - std::pow(1.8, 3)), 0.8);
}

TEST(FormulaSurface, ATriclinicCell) {
  FormulaSurface surface = of("cos(x) + cos(y) + cos(z)");
  surface.cell.vectors << 2 * pi, 2 * pi, 0, 0, 2 * pi, 0, 0, 0, 2 * pi;  // another cell of the same lattice
  const TriangleMesh made = make_formula_surface(surface);
  EXPECT_EQ(mesh::mesh_topology(made).euler_characteristic, -4);
  EXPECT_NEAR(mesh::area(made), 2.35 * 4 * pi * pi, 0.05 * 4 * pi * pi);
}

// Two networks, of genus 5 each, 0.6 apart: on the default grid, with steps of 0.35, they run into each other.
TEST(FormulaSurface, PartsThatComeNearEachOtherStayApart) {
  FormulaSurface surface = of("(sin(x)*cos(y) + sin(y)*cos(z) + sin(z)*cos(x))^2");
  for (const double level : {0.16, 0.25, 0.64}) {
    surface.level = level;
    const mesh::MeshTopology topology = mesh::mesh_topology(make_formula_surface(surface));
    EXPECT_EQ(topology.components, 2u) << level;
    EXPECT_EQ(topology.euler_characteristic, -16) << level;
  }
  surface.level = 0.25;
  surface.edge = 0.3;
  EXPECT_THAT(refusal(surface), testing::HasSubstr("use --edge 0."));
}

TEST(FormulaSurface, SaysWhatIsWrongAndWhere) {
  using testing::HasSubstr;
  EXPECT_THAT(refusal(of("cos(x) + cosine(y)")), HasSubstr("cosine"));
  EXPECT_THAT(refusal(of("cos(x) + w")), HasSubstr("\"w\""));
  EXPECT_THAT(refusal(of("cos(x) + (")), HasSubstr("Unexpected end"));
  EXPECT_THAT(refusal(of("")), HasSubstr("formula"));
  EXPECT_THAT(refusal(of("x, y")), HasSubstr("comma"));
  EXPECT_THAT(refusal(of("sqrt(cos(x) - 2)")), HasSubstr("no finite value at"));
  EXPECT_THAT(refusal(of("cos(x) + cos(y) + cos(1.1*z)")), HasSubstr("along the cell's edge c"));
  EXPECT_THAT(refusal(of("cos(x) + 5")), HasSubstr("same sign"));
  FormulaSurface thin = of("cos(x) + cos(y) + cos(z)");
  thin.thickness = 0.01;
  EXPECT_THAT(refusal(thin), HasSubstr("thickness"));
}

}  // namespace
}  // namespace nanocarbon::shapes
