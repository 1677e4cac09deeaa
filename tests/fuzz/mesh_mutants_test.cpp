// SPDX-License-Identifier: GPL-2.0-or-later
// Thousands of damaged mesh files, always the same ones: each must be refused as the user's error or come out
// as promised, without a crash, a hang, or an allocation that the file's size does not justify.
#include <gmock/gmock.h>

#include <random>

#include "fuzz/allocation_watch.h"
#include "fuzz/check_mesh.h"
#include "nanocarbon/mesh/formats/mesh_colours.h"
#include "nanocarbon/mesh/formats/write_mesh.h"
#include "nanocarbon/mesh/triangulate.h"
#include "support/small_meshes.h"
#include "support/temporary_folder.h"

namespace nanocarbon {
namespace {

using Random = std::mt19937_64;

struct Seed {
  std::string file;
  std::string contents;
};

// A small valid file of every format and variant.
std::vector<Seed> seeds() {
  const test::TemporaryFolder folder;
  const TriangleMesh cube = mesh::triangulate(test::cube(Vec3(0.25, -1, 3))).mesh;
  const mesh::MeshColours colours = mesh::colours_by_quality(cube, 0.5, 1.2);
  std::vector<Seed> result;
  for (const std::string name : {"a.off", "a.obj", "a.ply", "a.stl"})
    for (const bool text : {true, false})
      for (const bool coloured : {true, false}) {
        mesh::write_mesh(folder / name, cube, {text, coloured ? &colours : nullptr});
        result.push_back({name, test::contents_of(folder / name)});
      }
  result.push_back(
      {"b.off",
       "# quads\nSTCNOFF 8 6 12\n0 0 0 1 1 1 1 1 1 1 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n"
       "4 0 2 3 1\n4 4 5 7 6 255 0 0\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n"});
  result.push_back(
      {"b.obj",
       "mtllib a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvn 0 0 1\ng a\nf 1/1/1 3/1/1 2/1/1\n"
       "f -4//1 -3//1 -1//1\nf 1/1 4/1 \\\n3/1\nf 2 3 4 # last\n"});
  result.push_back(
      {"b.ply",
       "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
       "property uchar red\nelement face 2\nproperty list uchar int vertex_indices\n"
       "property float quality\nelement edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n"
       "0 0 0 1\n1 0 0 1\n1 1 0 1\n0 1 0 1\n3 0 1 2 0.5\n3 0 2 3 0.5\n0 1\n"});
  result.push_back(
      {"c.ply",
       "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
       "element tristrips 1\nproperty list int int64 vertex_indices\nend_header\n"
       "0 0 0 9\n2 0 0 9\n0 2 0 9\n0 0 2 9\n8 0 1 2 3\n-1 0 3 1\n"});
  // Cubes that share an edge and a square, a fin, and a face wrapped over lines.
  result.push_back(
      {"c.off",
       "OFF\n19 14 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n"
       "1 1 0\n2 1 0\n1 2 0\n2 2 0\n1 1 1\n2 1 1\n1 2 1\n2 2 1\n0.5 1 0\n9 9 9\n0 0 2\n"
       "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3\n7 5\n4 8 10 11 9\n4 12 13 15 14\n"
       "4 8 9 13 12\n4 10 14 15 11\n4 8 12 14 10\n4 9 11 15 13\n3 0 2 18\n3 2 0 18\n"});
  return result;
}

std::size_t below(Random& random, std::size_t limit) { return static_cast<std::size_t>(random() % limit); }

// Words that break readers: wrong counts, extremes, other syntax.
const std::vector<std::string> nasty = {"0",
                                        "-1",
                                        "1",
                                        "2",
                                        "3",
                                        "7",
                                        "8",
                                        "255",
                                        "65536",
                                        "4294967295",
                                        "4294967296",
                                        "9223372036854775807",
                                        "99999999999999999999",
                                        "1e400",
                                        "-1e400",
                                        "1e-400",
                                        "1e100",
                                        "nan",
                                        "inf",
                                        "0x1p3",
                                        "1.5",
                                        "",
                                        " ",
                                        "\n",
                                        "\r",
                                        "\t",
                                        "\\\n",
                                        "#",
                                        "/",
                                        "//",
                                        "f",
                                        "v",
                                        "OFF",
                                        "ply",
                                        "solid",
                                        "facet",
                                        "vertex",
                                        "list",
                                        "double",
                                        "char",
                                        "element",
                                        "property",
                                        "end_header",
                                        "endsolid",
                                        "f 1 2 3 4 5 6 7 8\n",
                                        "4 0 1 2 3\n"};

void mutate(std::string& text, Random& random) {
  if (text.empty()) return;
  const std::size_t at = below(random, text.size());
  switch (below(random, 9)) {
    case 0:  // one bit
      text[at] = static_cast<char>(text[at] ^ (1 << below(random, 8)));
      break;
    case 1:  // one byte
      text[at] = static_cast<char>(random());
      break;
    case 2:  // cut off
      text.resize(at);
      break;
    case 3:  // something put in
      text.insert(at, nasty[below(random, nasty.size())]);
      break;
    case 4:  // something taken out
      text.erase(at, 1 + below(random, 12));
      break;
    case 5:  // a stretch doubled
      text.insert(at, text.substr(at, 1 + below(random, 60)));
      break;
    case 6: {  // a word replaced
      const std::size_t begin = text.find_last_of(" \n", at) + 1;
      const std::size_t end = std::min(text.find_first_of(" \n", at), text.size());
      if (end > begin) text.replace(begin, end - begin, nasty[below(random, nasty.size())]);
      break;
    }
    case 7:  // extreme bytes, for binary counts and numbers
      for (std::size_t i = at; i < std::min(text.size(), at + 4); ++i)
        text[i] = random() % 2 ? '\xff' : '\x7f';
      break;
    case 8: {  // two lines exchanged
      const std::size_t a = text.find('\n', at), b = text.find('\n', below(random, text.size()));
      if (a != text.npos && b != text.npos && a < b)
        std::swap_ranges(&text[a], &text[a] + std::min<std::size_t>(b - a, text.size() - b), &text[b]);
      break;
    }
  }
}

class MeshMutants : public testing::TestWithParam<std::size_t> {};

TEST_P(MeshMutants, AreRefusedOrComeOutAsPromised) {
  const Seed seed = seeds()[GetParam()];
  EXPECT_EQ(test::broken_promise(seed.contents, seed.file), "");
  Random random(GetParam() + 1);
  for (int mutant = 0; mutant < 1000; ++mutant) {
    std::string text = seed.contents;
    for (std::size_t i = 1 + below(random, 3); i > 0; --i) mutate(text, random);
    test::reset_largest_allocation();
    ASSERT_EQ(test::broken_promise(text, seed.file), "") << seed.file << " mutant " << mutant << ":\n"
                                                         << text;
    // What is read is a few times as large as the file; a promised count has no such bound.
    ASSERT_LT(test::largest_allocation(), 200'000 + 100 * text.size())
        << seed.file << " mutant " << mutant << ":\n"
        << text;
  }
}

TEST_P(MeshMutants, EveryTruncationIsRefusedOrComesOutAsPromised) {
  const Seed seed = seeds()[GetParam()];
  for (std::size_t size = 0; size < seed.contents.size(); size += 3)
    ASSERT_EQ(test::broken_promise(seed.contents.substr(0, size), seed.file), "")
        << seed.file << " cut to " << size;
}

INSTANTIATE_TEST_SUITE_P(EveryFormat, MeshMutants, testing::Range<std::size_t>(0, 21));

TEST(MeshMutantSeeds, AreAllUsed) { EXPECT_EQ(seeds().size(), 21u); }

// Bytes without any meaning, under every extension.
TEST(MeshNoise, IsRefused) {
  Random random(99);
  for (int i = 0; i < 500; ++i) {
    std::string text(below(random, 300), '\0');
    for (char& c : text) c = static_cast<char>(random());
    for (const std::string file : {"a.off", "a.obj", "a.ply", "a.stl", "a"})
      ASSERT_EQ(test::broken_promise(text, file), "") << file << " " << i;
  }
}

}  // namespace
}  // namespace nanocarbon
