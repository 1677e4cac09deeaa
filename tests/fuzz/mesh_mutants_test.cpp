// SPDX-License-Identifier: GPL-2.0-or-later
// Thousands of damaged mesh files, always the same ones: each must be refused as the user's error or come out
// as promised, without a crash, a hang, or an allocation that the file's size does not justify.
#include <gmock/gmock.h>

#include <random>

#include "fuzz/allocation_watch.h"
#include "fuzz/check_mesh.h"
#include "fuzz/seeds.h"

namespace nanocarbon {
namespace {

using Random = std::mt19937_64;

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
  const test::Seed seed = test::mesh_seeds()[GetParam()];
  EXPECT_EQ(test::broken_promise(seed.contents, seed.file), "");
  Random random(GetParam() + 1);
  // An isosurface has up to 64 nodes for each value, and takes as much longer.
  const bool field =
      seed.file.ends_with(".cube") || seed.file.ends_with(".mrc") || seed.file.ends_with(".vti");
  for (int mutant = 0; mutant < (field ? 200 : 1000); ++mutant) {
    std::string text = seed.contents;
    for (std::size_t i = 1 + below(random, 3); i > 0; --i) mutate(text, random);
    test::reset_largest_allocation();
    ASSERT_EQ(test::broken_promise(text, seed.file), "") << seed.file << " mutant " << mutant << ":\n"
                                                         << text;
    // What is read is a few times as large as the file; a promised count has no such bound. A mesh in a cell is split.
    const std::size_t split = text.find("Lattice") == text.npos && !field ? 0 : 20'000'000;
    ASSERT_LT(test::largest_allocation(), 200'000 + 100 * text.size() + split)
        << seed.file << " mutant " << mutant << ":\n"
        << text;
  }
}

TEST_P(MeshMutants, EveryTruncationIsRefusedOrComesOutAsPromised) {
  const test::Seed seed = test::mesh_seeds()[GetParam()];
  for (std::size_t size = 0; size < seed.contents.size(); size += 3)
    ASSERT_EQ(test::broken_promise(seed.contents.substr(0, size), seed.file), "")
        << seed.file << " cut to " << size;
}

INSTANTIATE_TEST_SUITE_P(EveryFormat, MeshMutants, testing::Range<std::size_t>(0, 48));

TEST(MeshMutantSeeds, AreAllUsed) { EXPECT_EQ(test::mesh_seeds().size(), 49u); }

// Bytes without any meaning, under every extension.
TEST(MeshNoise, IsRefused) {
  Random random(99);
  for (int i = 0; i < 500; ++i) {
    std::string text(below(random, 300), '\0');
    for (char& c : text) c = static_cast<char>(random());
    for (const std::string file : {"a.off", "a.obj", "a.ply", "a.stl", "a", "a.glb", "a.gltf", "a.3mf",
                                   "a.vtk", "a.vtp", "a.msh", "a.cube", "a.mrc"})
      ASSERT_EQ(test::broken_promise(text, file), "") << file << " " << i;
  }
}

}  // namespace
}  // namespace nanocarbon
