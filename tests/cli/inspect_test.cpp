// SPDX-License-Identifier: GPL-2.0-or-later
// `nanocarbon inspect` as a user runs it.
#include <gmock/gmock.h>

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "support/program_test.h"

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

}  // namespace
}  // namespace nanocarbon::cli
