// SPDX-License-Identifier: GPL-2.0-or-later
// --wrap, --unite, --untangle and --close-holes of `nanocarbon build` and `inspect`, as a user runs them.
#include <gmock/gmock.h>

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "nanocarbon/mesh/formats/write_mesh.h"
#include "nanocarbon/mesh/triangulate.h"
#include "nanocarbon/shapes/shapes.h"
#include "support/program_test.h"
#include "support/small_meshes.h"

namespace nanocarbon::cli {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class SurfaceOptions : public test::ProgramTest {
 protected:
  static constexpr bool has_cgal = NANOCARBON_WITH_CGAL;

  //! A house of two rooms: the wall between them has edges with three faces.
  std::string house() const {
    std::string text = "OFF\n12 11 0\n";
    for (int x = 0; x < 3; ++x)
      for (const char* yz : {"0 0", "1 0", "1 1", "0 1"}) text += std::to_string(x) + " " + yz + "\n";
    text += "4 0 3 2 1\n4 4 5 6 7\n4 8 9 10 11\n";
    for (int x = 0; x < 8; x += 4)
      for (int i = 0; i < 4; ++i) {
        const int a = x + i, b = x + (i + 1) % 4;
        text += "4 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(b + 4) + " " +
                std::to_string(a + 4) + "\n";
      }
    return file("house.off", text);
  }

  //! Two cubes of which one has a corner in the other.
  std::string two_cubes() const {
    std::string text = "OFF\n16 12 0\n";
    for (const double at : {0.0, 0.5})
      for (int i = 0; i < 8; ++i)
        text += std::to_string(at + (i & 1)) + " " + std::to_string(0.9 * at + (i >> 1 & 1)) + " " +
                std::to_string(0.8 * at + (i >> 2)) + "\n";
    for (const int first : {0, 8})
      for (const auto& face :
           {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
        text += "4";
        for (const int v : face) text += " " + std::to_string(first + v);
        text += "\n";
      }
    return file("cubes.off", text);
  }
};

TEST_F(SurfaceOptions, WhatInspectAdvisesIsTrue) {
  if (!has_cgal) GTEST_SKIP() << "built without CGAL";
  for (const std::string& mesh : {house(), two_cubes()}) {
    const Outcome refused = run("inspect --json " + mesh);
    EXPECT_EQ(refused.exit_code, 5);
    const auto json = nlohmann::json::parse(refused.out);
    ASSERT_TRUE(json.contains("advice")) << refused.out;
    const std::string options = json["advice"]["options"];
    EXPECT_THAT(options, StartsWith(mesh == path("cubes.off") ? "--unite" : "--wrap "));
    EXPECT_THAT(run("inspect " + mesh).out, HasSubstr("can be used with  " + options));
    EXPECT_THAT(run("build " + mesh + " -o " + path("out.data")).err,
                HasSubstr("It can be used with " + options));
    const Outcome used = run("inspect --json " + options + " --write " + path("out.ply") + " " + mesh);
    EXPECT_EQ(used.exit_code, 0) << used.err;
    const auto closed = nlohmann::json::parse(used.out);
    EXPECT_EQ(closed["boundary_loops"], 0);
    EXPECT_EQ(closed["pieces"], 1);
    EXPECT_EQ(closed["genus"], 0);
    EXPECT_EQ(closed["as_read"]["faces"], json["as_read"]["faces"]);
    EXPECT_THAT(closed["repairs"].dump(),
                HasSubstr(options == "--unite" ? "united 2 overlapping" : "wrapped, size"));
    const auto again = nlohmann::json::parse(run("inspect --json " + path("out.ply")).out);
    EXPECT_EQ(again["faces"], closed["faces"]);
    EXPECT_EQ(again["usable"], true);
  }
}

// A ball with two neighbouring vertices that changed places is built all the same, with a warning, and without one once
// untangled.
TEST_F(SurfaceOptions, APieceThatCrossesItselfIsUntangled) {
  if (!has_cgal) GTEST_SKIP() << "built without CGAL";
  TriangleMesh ball = shapes::make_sphere(1.0, 8);
  std::swap(ball.points[ball.triangles[0][0]], ball.points[ball.triangles[0][1]]);
  mesh::write_mesh(path("folded.off"), ball);
  const auto json = nlohmann::json::parse(run("inspect --json " + path("folded.off")).out);
  EXPECT_EQ(json["usable"], true);
  EXPECT_EQ(json["warnings"][0]["problem"], "self_intersection");
  ASSERT_TRUE(json.contains("advice"));
  EXPECT_EQ(json["advice"]["options"], "--untangle");
  EXPECT_THAT(run("inspect " + path("folded.off")).out, HasSubstr("mended with       --untangle"));
  const std::string build = "build " + path("folded.off") + " --atoms 300 --quality draft -o " +
                            path("out.data") + " --report " + path("out.json");
  EXPECT_THAT(run(build).err, HasSubstr("--untangle"));
  const Outcome built = run(build + " --untangle");
  ASSERT_EQ(built.exit_code, 0) << built.err;
  EXPECT_THAT(built.err, testing::Not(HasSubstr("intersect; ")));
  const auto report = nlohmann::json::parse(contents("out.json"));
  EXPECT_THAT(report["input"]["repairs"].dump(), HasSubstr("untangled 1 piece of"));
  EXPECT_EQ(report["molecule"]["genus"], 0);

  // More than a small fault.
  mesh::write_mesh(path("spindle.off"), mesh::triangulate(test::torus(96, 64, 0.2, 0.3)).mesh);
  const Outcome refused = run("inspect --untangle " + path("spindle.off"));
  EXPECT_EQ(refused.exit_code, 5);
  EXPECT_THAT(refused.err, HasSubstr("spindle.off: --untangle: "));
  EXPECT_THAT(refused.err, HasSubstr("no small fault"));
}

TEST_F(SurfaceOptions, AWrappedMeshBecomesAMolecule) {
  if (!has_cgal) GTEST_SKIP() << "built without CGAL";
  const std::string options = " --atoms 400 --quality draft --wrap 0.2 --report " + path("out.json");
  const Outcome built = run("build " + two_cubes() + options + " -o " + path("out.data"));
  ASSERT_EQ(built.exit_code, 0) << built.err;
  const auto report = nlohmann::json::parse(contents("out.json"));
  EXPECT_EQ(report["input"]["pieces"], 1);
  EXPECT_THAT(report["input"]["repairs"].dump(), HasSubstr("wrapped, size 0.2, offset 0.00667"));
  EXPECT_NEAR(report["molecule"]["atoms"].get<int>(), 400, 20);
  EXPECT_EQ(report["molecule"]["genus"], 0);
}

TEST_F(SurfaceOptions, WithoutCgalTheySayHowToGetIt) {
  if (has_cgal) GTEST_SKIP() << "built with CGAL";
  for (const std::string option : {"--wrap 0.2", "--unite", "--untangle"}) {
    const Outcome refused = run("inspect " + two_cubes() + " " + option);
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err, HasSubstr("libcgal-dev"));
  }
}

TEST_F(SurfaceOptions, AreRefusedWhereTheyMakeNoSense) {
  const std::string mesh = octahedron();
  for (const std::string size : {"0", "-1", "x", "1,", "1,2,3", "nan", "inf", "1e400", "1,0", "\"\""})
    EXPECT_EQ(run("inspect " + mesh + " --wrap=" + size).exit_code, 2) << size;
  EXPECT_EQ(run("inspect " + mesh + " --wrap 1 --unite").exit_code, 2);
  EXPECT_EQ(run("inspect " + mesh + " --wrap 1 --close-holes 1").exit_code, 2);
  EXPECT_EQ(run("inspect " + mesh + " --wrap 1 --untangle").exit_code, 2);
  for (const std::string option : {"--unite", "--untangle"})
    EXPECT_EQ(run("build " + mesh + " -o " + path("out.data") + " --no-repair " + option).exit_code, 2);
  const Outcome cell = run("inspect " + mesh + " --cell 4,4,4 --wrap 1");
  EXPECT_EQ(cell.exit_code, 2);
  EXPECT_THAT(cell.err, HasSubstr("--periodic none"));
  EXPECT_EQ(run("inspect " + mesh + " --write " + path("out.xyz")).exit_code, 2);
  EXPECT_FALSE(exists("out.data"));
}

TEST_F(SurfaceOptions, HolesAreClosedAndTheMeshWritten) {
  const std::string open = file("open.off",
                                "OFF\n6 7 0\n1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\n"
                                "3 0 2 4\n3 2 1 4\n3 1 3 4\n3 3 0 4\n3 2 0 5\n3 1 2 5\n3 3 1 5\n");
  const auto json = nlohmann::json::parse(
      run("inspect --json --close-holes 1 --write " + path("closed.stl") + " " + open).out);
  EXPECT_EQ(json["boundary_loops"], 0);
  EXPECT_EQ(nlohmann::json::parse(run("inspect --json " + path("closed.stl")).out)["faces"], 8);
}

// What cannot be used is not written.
TEST_F(SurfaceOptions, NothingIsWrittenOfAMeshThatCannotBeUsed) {
  EXPECT_EQ(run("inspect " + house() + " --write " + path("out.ply")).exit_code, 5);
  EXPECT_FALSE(exists("out.ply"));
}

}  // namespace
}  // namespace nanocarbon::cli
