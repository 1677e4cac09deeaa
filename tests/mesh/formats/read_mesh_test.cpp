// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/formats/read_mesh.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <clocale>
#include <locale>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/formats/load_surface.h"
#include "nanocarbon/mesh/parsing/base64.h"
#include "support/refusal.h"
#include "support/temporary_folder.h"

namespace nanocarbon::mesh {
namespace {

using testing::HasSubstr;

class ReadMesh : public testing::Test {
 protected:
  std::filesystem::path file(const std::string& name, const std::string& contents) const {
    return folder.file(name, contents);
  }
  std::string unreadable(const std::filesystem::path& path) const {
    return test::refusal(Failure::unreadable, [&] { read_mesh(path); });
  }
  std::string malformed(const std::filesystem::path& path) const {
    return test::refusal(Failure::malformed, [&] { read_mesh(path); });
  }

  test::TemporaryFolder folder;
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
  EXPECT_THAT(unreadable(folder / "no/folder.off"), HasSubstr("folder.off"));
  EXPECT_THAT(unreadable(folder.path()), HasSubstr("it is a directory"));
  EXPECT_THAT(unreadable("/dev/null"), HasSubstr("not a regular file"));
}

TEST_F(ReadMesh, AForbiddenFileIsSaidSo) {
  if (geteuid() == 0) GTEST_SKIP() << "nothing is forbidden to root";
  const std::filesystem::path path = file("a.off", off);
  std::filesystem::permissions(path, std::filesystem::perms::none);
  EXPECT_THAT(unreadable(path), HasSubstr("Permission denied"));
}

TEST_F(ReadMesh, WhatIsNoMeshIsSaidSo) {
  EXPECT_THAT(malformed(file("a.off", "")), HasSubstr("a.off: the file is empty"));
  EXPECT_THAT(malformed(file("a.txt", "hello\n")), HasSubstr("none of the formats that are read"));
  EXPECT_THAT(malformed(file("a.off", "hello\n")), HasSubstr("a.off:1: "));
  EXPECT_THAT(malformed(file("a.ply", "hello\n")), HasSubstr("a.ply:1: a PLY file must begin with 'ply'"));
  EXPECT_THAT(malformed(file("a.obj", "hello\n")), HasSubstr("no vertices"));
  EXPECT_THAT(malformed(file("a.obj", std::string("\x1f\x8b\x08\0", 4))), HasSubstr("compressed with gzip"));
  EXPECT_THAT(malformed(file("a.obj", std::string("\xFF\xFEv\0 \0", 6))),
              HasSubstr("UTF-16; save it as UTF-8"));
  EXPECT_THAT(malformed(file("a.obj", std::string("v\0 \0001\0 \0", 8))), HasSubstr("UTF-16"));
  EXPECT_THAT(malformed(file("a.off", std::string("\0O\0F\0F\0\n", 8))), HasSubstr("UTF-16"));
  EXPECT_THAT(malformed(file("a.stl", "PK\x03\x04")), HasSubstr("ZIP archive, but no 3MF file"));
  for (const char* name : {"a.off", "a.obj", "a.ply", "a.stl"}) {
    EXPECT_THAT(malformed(file(name, "version https://git-lfs.github.com/spec/v1\noid sha256:4d\nsize 9\n")),
                HasSubstr("git lfs pull"));
    EXPECT_THAT(malformed(file(name, "\n<!DOCTYPE html>\n<html></html>\n")), HasSubstr("web page"));
  }
}

// gzip of `off`, and the same in two members one after the other.
TEST_F(ReadMesh, FilesPackedByGzipAreRead) {
  const std::string whole = *from_base64("H4sIAAAAAAACA/N3c+MyVjBUMOAy0DNVMADShmDSACxmrACijbgAKgY2ZCYAAAA=");
  EXPECT_EQ(read_mesh(file("a.off.gz", whole)).points[0].x(), 0.5);
  EXPECT_EQ(read_mesh(file("a.off", whole)).points[0].x(), 0.5);
  const std::string halves = *from_base64("H4sIAAAAAAACA/N3c+MyVjBUMOAy0AMAfhBhNQwAAAA=") +
                             *from_base64("H4sIAAAAAAACAzNVMFAw4DIEkwYKQJrLWAFEG3EBANj9HHYaAAAA");
  EXPECT_EQ(read_mesh(file("a", halves)).faces(), 1u);
  EXPECT_THAT(malformed(file("a.off.gz", whole.substr(0, whole.size() - 9))),
              HasSubstr("damaged, cut short"));
}

// A locale with a decimal comma, as German and French have it, whichever are installed.
struct DecimalComma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
};

TEST_F(ReadMesh, TheLocaleDoesNotMatter) {
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new DecimalComma));
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8"})
    if (std::setlocale(LC_NUMERIC, name)) break;
  const double x = read_mesh(file("a.off", off)).points[0].x();
  std::setlocale(LC_NUMERIC, "C");
  std::locale::global(before);
  EXPECT_EQ(x, 0.5);
}

// Whatever is refused of the cell in a file's comment, the message says which file has it.
TEST_F(ReadMesh, RefusalsOfACellNameTheFile) {
  const std::string square = "4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";
  for (const std::string vectors :
       {"1 0 0 9 1 0 0 0 1", "0 1 0 1 0 0 0 0 1", "1 0 0 0 1 0 0 0 0", "0.01 0 0 0 2 0 0 0 2"}) {
    const auto path = file("cell.off", "OFF\n# Lattice=\"" + vectors + "\"\n" + square);
    try {
      load_surface(path);
      ADD_FAILURE() << vectors;
    } catch (const UserError& error) {
      EXPECT_THAT(error.what(), HasSubstr(path.string())) << vectors;
    }
  }
}

}  // namespace
}  // namespace nanocarbon::mesh
