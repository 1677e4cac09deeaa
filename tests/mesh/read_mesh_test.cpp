#include "nanocarbon/mesh/read_mesh.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <clocale>
#include <fstream>

#include "support/refusal.h"

namespace nanocarbon {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class ReadMesh : public testing::Test {
 protected:
  void SetUp() override {
    const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
    folder = fs::path(testing::TempDir()) / ("nanocarbon_read_mesh_" + test);
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }

  fs::path file(const std::string& name, const std::string& contents) const {
    std::ofstream(folder / name, std::ios::binary) << contents;
    return folder / name;
  }
  std::string unreadable(const fs::path& path) const {
    return test::refusal(Failure::unreadable, [&] { read_mesh(path); });
  }
  std::string malformed(const fs::path& path) const {
    return test::refusal(Failure::malformed, [&] { read_mesh(path); });
  }

  fs::path folder;
};

const std::string off = "OFF\n3 1 0\n0.5 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
const std::string obj = "v 0.5 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

TEST_F(ReadMesh, TheContentsDecideWhateverTheExtension) {
  for (const std::string name : {"a.off", "a.obj", "a.ply", "a.stl", "a.OFF", "a", "a.txt"}) {
    EXPECT_EQ(read_mesh(file(name, off)).faces(), 1u) << name;
    EXPECT_EQ(read_mesh(file(name, obj)).faces(), 1u) << name;
  }
}

TEST_F(ReadMesh, WhatCannotBeReadIsSaidSo) {
  EXPECT_THAT(unreadable(folder / "none.off"), HasSubstr("none.off: cannot be read: "));
  EXPECT_THAT(unreadable(folder / "no" / "folder.off"), HasSubstr("folder.off"));
  EXPECT_THAT(unreadable(folder), HasSubstr("it is a directory"));
  EXPECT_THAT(unreadable("/dev/null"), HasSubstr("no regular file"));
}

TEST_F(ReadMesh, AForbiddenFileIsSaidSo) {
  if (geteuid() == 0) GTEST_SKIP() << "nothing is forbidden to root";
  const fs::path path = file("a.off", off);
  fs::permissions(path, fs::perms::none);
  EXPECT_THAT(unreadable(path), HasSubstr("Permission denied"));
}

TEST_F(ReadMesh, WhatIsNoMeshIsSaidSo) {
  EXPECT_THAT(malformed(file("a.off", "")), HasSubstr("a.off: the file is empty"));
  EXPECT_THAT(malformed(file("a.txt", "hello\n")), HasSubstr("is no OFF, OBJ, PLY or STL file"));
  EXPECT_THAT(malformed(file("a.off", "hello\n")), HasSubstr("a.off:1: "));
  EXPECT_THAT(malformed(file("a.ply", "hello\n")), HasSubstr("a.ply:1: a PLY file begins with ply"));
  EXPECT_THAT(malformed(file("a.obj", "hello\n")), HasSubstr("no vertices"));
  EXPECT_THAT(malformed(file("a.obj", std::string("\x1f\x8b\x08\0", 4))), HasSubstr("compressed by gzip"));
  EXPECT_THAT(malformed(file("a.stl", "PK\x03\x04")), HasSubstr("ZIP archive"));
}

TEST_F(ReadMesh, TheLocaleDoesNotMatter) {
  bool found = false;
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE.utf8"})
    if (std::setlocale(LC_ALL, name)) {
      found = true;
      break;
    }
  EXPECT_EQ(read_mesh(file("a.off", off)).points[0].x(), 0.5);
  std::setlocale(LC_ALL, "C");
  if (!found) GTEST_SKIP() << "no locale with a decimal comma is installed here";
}

}  // namespace
}  // namespace nanocarbon
