// SPDX-License-Identifier: GPL-2.0-or-later
// `nanocarbon inspect` as a user runs it.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "nanocarbon/mesh/formats/write_mesh.h"
#include "nanocarbon/mesh/triangulate.h"
#include "nanocarbon/shapes/shapes.h"
#include "support/grid_files.h"
#include "support/program_test.h"
#include "support/small_meshes.h"

namespace nanocarbon::cli {
namespace {

using testing::HasSubstr;

using Inspect = test::ProgramTest;

TEST_F(Inspect, TellsWhatAMeshIs) {
  const auto json = nlohmann::json::parse(run("inspect --json " + octahedron()).out);
  EXPECT_EQ(json["vertices"], 6);
  EXPECT_EQ(json["faces"], 8);
  EXPECT_EQ(json["euler_characteristic"], 2);
  EXPECT_EQ(json["genus"], 0);
  EXPECT_EQ(json["usable"], true);
}

TEST_F(Inspect, NamesEveryReasonAgainstAMesh) {
  // Three faces at edge 0-1, and a face that repeats a vertex (which alone would be dropped).
  const std::string mesh =
      file("bad.off", "OFF\n5 4 0\n0 0 0\n1 0 0\n0 1 0\n0 -1 0\n0 0 1\n3 0 1 2\n3 1 0 3\n3 0 1 4\n3 2 2 3\n");
  const Outcome outcome = run("inspect --json " + mesh);
  EXPECT_EQ(outcome.exit_code, 5);
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["usable"], false);
  ASSERT_FALSE(json["reasons"].empty());
  EXPECT_EQ(json["reasons"][0]["problem"], "non_manifold_edge");
}

// A ball in a cube file: without a level its values are told, with one it is a mesh like any other.
TEST_F(Inspect, AFieldIsAMeshAtALevel) {
  const std::string field =
      file("ball.cube",
           test::cube_text({{13, 13, 13}, Vec3::Constant(-3), 0.5 * Mat3::Identity(), [](const Vec3& x) {
                              return 10 - x.norm();
                            }}));
  const Outcome asked = run("inspect " + field);
  EXPECT_EQ(asked.exit_code, 2);
  EXPECT_THAT(asked.err, HasSubstr("--level: they are between"));
  const auto json = nlohmann::json::parse(run("inspect --json --level 8 " + field).out);
  EXPECT_EQ(json["genus"], 0);
  EXPECT_EQ(json["unit"], "Bohr");
  EXPECT_THAT(run("inspect --level 8 " + field).out, HasSubstr("(unit of the file: Bohr)"));
  EXPECT_EQ(run("inspect --level 8 --field-edge sideways " + field).exit_code, 2);
  EXPECT_EQ(run("inspect --level 8 " + octahedron()).exit_code, 2);
  EXPECT_EQ(
      run("build --quiet --quality draft --level 8 " + field + " --atoms 300 -o " + path("a.data")).exit_code,
      0);
}

// A surface that the field's cell cuts is sewn again by build.
TEST_F(Inspect, APeriodicFieldHasItsGenusInTheCell) {
  const double step = 2 * M_PI / 12;
  const std::string field =
      file("p.vti", test::vti_text({{12, 12, 12}, Vec3::Zero(), step * Mat3::Identity(), [](const Vec3& x) {
                                      return std::cos(x.x()) + std::cos(x.y()) + std::cos(x.z());
                                    }}));
  const Outcome outcome = run("inspect --level 0 --periodic xyz " + field);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("genus 3"));
  EXPECT_THAT(outcome.out, HasSubstr("6.28319 x 6.28319 x 6.28319"));
}

// The square of each side with vertices of its own, as programs write boxes with textures or flat normals.
TEST_F(Inspect, TellsWhatBuildTakes) {
  std::string box = "OFF\n24 6 0\n";
  for (int axis = 0; axis < 3; ++axis)
    for (const int side : {0, 1})
      for (const auto& [u, v] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
        std::array<int, 3> p{};
        p[axis] = side;
        p[(axis + 1) % 3] = side ? u : v;
        p[(axis + 2) % 3] = side ? v : u;
        box += std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) + "\n";
      }
  for (int face = 0; face < 24; face += 4)
    box += "4 " + std::to_string(face) + " " + std::to_string(face + 1) + " " + std::to_string(face + 2) +
           " " + std::to_string(face + 3) + "\n";
  const auto json = nlohmann::json::parse(run("inspect --json " + file("box.off", box)).out);
  EXPECT_EQ(json["as_read"]["vertices"], 24);
  EXPECT_EQ(json["vertices"], 8);
  EXPECT_EQ(json["pieces"], 1);
  EXPECT_EQ(json["boundary_loops"], 0);
  EXPECT_NEAR(json["volume"], 1.0, 1e-12);
  const Outcome refused = run("build " + path("box.off") + " --no-repair -o " + path("out.data"));
  EXPECT_EQ(refused.exit_code, 5);
  EXPECT_THAT(refused.err, HasSubstr("--no-repair"));
  EXPECT_THAT(refused.err, HasSubstr("joined vertices to others at the same place: 16"));
}

// Two balls that are apart in the file, one of them near the other's image in the cell.
TEST_F(Inspect, FindsAndLocatesWhatIntersectsThroughTheFacesOfTheCell) {
  const auto balls = [&](const std::string& name, double second_x, double radius) {
    TriangleMesh mesh = shapes::make_sphere(radius, 4);
    for (Vec3& p : mesh.points) p += Vec3(0.25, 0.5, 0.5);
    TriangleMesh other = shapes::make_sphere(0.2, 4);
    for (Vec3& p : other.points) p += Vec3(second_x, 0.5, 0.5);
    mesh = test::together(mesh, other);
    mesh::write_mesh(path(name), mesh);
    return path(name);
  };
  const std::string in_cell = " --cell 1,1,1";
  EXPECT_EQ(run("inspect " + balls("apart.off", 0.75, 0.2) + in_cell).exit_code, 0);

  const std::string near = balls("near.off", 0.9, 0.2);
  EXPECT_EQ(run("inspect " + near).exit_code, 0) << "in free space they are apart";
  const Outcome outcome = run("inspect --json " + near + in_cell);
  EXPECT_EQ(outcome.exit_code, 5);
  const auto json = nlohmann::json::parse(outcome.out);
  ASSERT_EQ(json["reasons"].size(), 1u);
  EXPECT_EQ(json["reasons"][0]["problem"], "pieces_intersect");
  const auto point = json["reasons"][0]["places"][0]["point"];
  const double x = point[0];
  EXPECT_LT(std::min(std::abs(x - 0.075), std::abs(x - 1.075)), 0.06) << "half way from 0.9 to 1.25";
  EXPECT_NEAR(point[1], 0.5, 0.15);
  EXPECT_NEAR(point[2], 0.5, 0.15);
  EXPECT_THAT(run("build " + near + in_cell + " --atoms 500 -o " + path("a.data")).err,
              HasSubstr("of different pieces intersect"));
}

nlohmann::json problems_of(const nlohmann::json& findings) {
  nlohmann::json names = nlohmann::json::array();
  for (const auto& finding : findings) names.push_back(finding["problem"]);
  return names;
}

// A piece that is too large for its cell passes through its images. Its own parts may cross as in free space.
TEST_F(Inspect, RefusesWhatCrossesAnImageOfItself) {
  const auto answer = [&](const TriangleMesh& mesh, const std::string& options) {
    mesh::write_mesh(path("piece.off"), mesh);
    const Outcome outcome = run("inspect --json " + path("piece.off") + options);
    const auto json = nlohmann::json::parse(outcome.out);
    const bool refused = !json["reasons"].empty();
    EXPECT_EQ(outcome.exit_code, refused ? 5 : 0);
    return std::pair{problems_of(json["reasons"]), problems_of(json["warnings"])};
  };
  const nlohmann::json none = nlohmann::json::array(), images = {"images_intersect"},
                       own = {"self_intersection"};
  const TriangleMesh ball = shapes::make_sphere(0.51, 4);
  EXPECT_EQ(answer(ball, " --cell 1,1,1"), std::pair(images, none));
  EXPECT_EQ(answer(ball, " --cell 1.03,1.03,1.03"), std::pair(none, none));
  EXPECT_EQ(answer(ball, " --cell 1,1.5,1.5"), std::pair(images, none)) << "in one direction alone";
  EXPECT_EQ(answer(ball, " --cell 1,1.5,1.5 --periodic yz"), std::pair(none, none));
  EXPECT_EQ(answer(ball, " --cell 1,1.5,1.5 --cells 3,1,1").first, nlohmann::json({"pieces_intersect"}));

  // A tube along z, in the image of itself in y.
  const auto tube = [&](const std::string& options) {
    EXPECT_EQ(run("make mesh implicit 'sqrt(x^2+y^2)-0.4' --periodic z --period 2,2,1 --edge 0.08 -q -o " +
                  path("tube.off"))
                  .exit_code,
              0);
    const Outcome outcome = run("inspect --json " + path("tube.off") + options);
    return problems_of(nlohmann::json::parse(outcome.out)["reasons"]);
  };
  EXPECT_EQ(tube(" --periodic xyz --cell 2,0.7,1"), images);
  EXPECT_EQ(tube(" --periodic xyz --cell 2,0.9,1"), none);

  // A spindle torus crosses itself, in a cell as well as in free space.
  const TriangleMesh spindle = mesh::triangulate(test::torus(24, 16, 0.2, 0.3)).mesh;
  EXPECT_EQ(answer(spindle, ""), std::pair(none, own));
  EXPECT_EQ(answer(spindle, " --cell 2,2,2"), std::pair(none, own));
  EXPECT_EQ(answer(spindle, " --cell 0.9,2,2"), std::pair(images, own));
}

// Long edges are halved in a cell, and then vertices of both pieces lie on the curve where they cross.
TEST_F(Inspect, FindsPiecesThatCrossInEdgesThatTheyHaveInCommon) {
  mesh::PolygonSoup cubes = test::cube(Vec3(0.1, 0.1, 0.1));
  const TriangleMesh one = mesh::triangulate(cubes).mesh;
  const auto reasons = [&](double offset, double edge) {
    const TriangleMesh other = mesh::triangulate(test::cube(Vec3::Constant(offset))).mesh;
    mesh::write_mesh(path("cubes.off"), test::together(one, other));
    const Outcome outcome = run(
        fmt::format("inspect --json {} --periodic xyz --cell {},{},{}", path("cubes.off"), edge, edge, edge));
    return problems_of(nlohmann::json::parse(outcome.out)["reasons"]);
  };
  for (const double edge : {2.3, 2.5, 3.0, 3.5, 4.0, 6.0})
    for (const double offset : {0.35, 0.6, 0.85})
      EXPECT_EQ(reasons(offset, edge), nlohmann::json({"pieces_intersect"})) << offset << " in " << edge;
  // Apart, in a corner of each other's cell.
  EXPECT_EQ(reasons(1.35, 2.6), nlohmann::json::array());
  EXPECT_EQ(reasons(1.35, 2.2), nlohmann::json({"pieces_intersect"})) << "with an image";
}

}  // namespace
}  // namespace nanocarbon::cli
