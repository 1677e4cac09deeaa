// SPDX-License-Identifier: GPL-2.0-or-later
// The meshes that ship with the project are what the generator that ships with it makes.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "nanocarbon/mesh/formats/load_surface.h"
#include "support/temporary_folder.h"

namespace nanocarbon::shapes {
namespace {

namespace fs = std::filesystem;

const fs::path examples = NANOCARBON_EXAMPLES;

TEST(ExampleMeshes, AreWhatTheGeneratorMakes) {
  const test::TemporaryFolder temporary;
  const fs::path& folder = temporary.path();
  const std::string command = "NANOCARBON='" NANOCARBON_PROGRAM "' '" +
                              (examples / "meshes/make.sh").string() + "' '" + folder.string() + "' > '" +
                              (folder / "log").string() + "'";
  ASSERT_EQ(std::system(command.c_str()), 0);
  std::size_t compared = 0;
  for (const auto& entry : fs::directory_iterator(examples / "meshes")) {
    if (entry.path().extension() != ".off") continue;
    SCOPED_TRACE(entry.path().filename());
    EXPECT_LT(entry.file_size(), 300'000u);
    ASSERT_TRUE(fs::exists(folder / entry.path().filename()));
    const TriangleMesh shipped = mesh::load_surface(entry.path()).mesh;
    const TriangleMesh made = mesh::load_surface(folder / entry.path().filename()).mesh;
    EXPECT_EQ(shipped.triangles, made.triangles);
    ASSERT_EQ(shipped.points.size(), made.points.size());
    // Another compiler or mathematics library may differ in the last digits.
    for (std::size_t i = 0; i < made.points.size(); ++i)
      ASSERT_LT((shipped.points[i] - made.points[i]).norm(), 1e-9) << "vertex " << i;
    ++compared;
  }
  EXPECT_GE(compared, 5u);
}

TEST(ExampleMeshes, LoadWithoutRepairs) {
  for (const auto& entry : fs::directory_iterator(examples / "meshes")) {
    if (entry.path().extension() != ".off") continue;
    SCOPED_TRACE(entry.path().filename());
    EXPECT_TRUE(mesh::load_surface(entry.path()).repairs.empty());
  }
}

}  // namespace
}  // namespace nanocarbon::shapes
