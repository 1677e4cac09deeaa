// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/size_advice.h"

#include <gmock/gmock.h>

#include <vector>

#include "remeshing/shapes.h"

namespace nanocarbon::building {
namespace {

using testing::HasSubstr;

//! A search on a surface on which molecules hold from a number of atoms on. Notes what is tried.
SizeSearch search(const TriangleMesh& surface, std::size_t from, std::vector<std::size_t>& tried) {
  return {surface, 1.42, 1, [from, &tried](std::size_t atoms) {
            tried.push_back(atoms);
            return atoms >= from;
          }};
}

TEST(SizeAdvice, NamesTheFirstSizeOfWhichAMoleculeHolds) {
  const TriangleMesh sphere = test::sphere(1, 3);
  std::vector<std::size_t> tried;
  const SizeFound found = next_size(search(sphere, 500, tried), 300, nullptr, 10'000);
  ASSERT_TRUE(found.atoms);
  EXPECT_TRUE(found.tried);
  EXPECT_GE(*found.atoms, 500u);
  EXPECT_EQ(tried.back(), *found.atoms);
  EXPECT_LE(*found.atoms, 1.25 * 500 * 1.1);
  EXPECT_THAT(advice(found), HasSubstr("for which a draft holds"));
}

// The check of features comes first: what it refuses is not tried.
TEST(SizeAdvice, LeavesNoFeatureTooSmall) {
  const TriangleMesh torus = test::torus(20, 1.5, 160, 20);
  std::vector<std::size_t> tried;
  const SizeFound found = next_size(search(torus, 0, tried), 450, nullptr, 10'000);
  ASSERT_TRUE(found.atoms);
  EXPECT_EQ(tried, std::vector<std::size_t>{*found.atoms});
  EXPECT_GT(*found.atoms, 600u);
}

TEST(SizeAdvice, SaysWhatWasOnlyChecked) {
  std::vector<std::size_t> tried;
  const TriangleMesh sphere = test::sphere(1, 3);
  const SizeFound found = next_size(search(sphere, 0, tried), 9000, nullptr, 100'000);
  ASSERT_TRUE(found.atoms);
  EXPECT_FALSE(found.tried);
  EXPECT_TRUE(tried.empty());
  EXPECT_THAT(advice(found), HasSubstr("leaves no feature too small is --atoms 9000"));
  EXPECT_THAT(advice(found), HasSubstr("no draft was made"));
}

TEST(SizeAdvice, NamesNoneWhereNoneHolds) {
  std::vector<std::size_t> tried;
  const TriangleMesh sphere = test::sphere(1, 3);
  const SizeFound found = next_size(search(sphere, 1'000'000, tried), 300, nullptr, 3000);
  EXPECT_FALSE(found.atoms);
  EXPECT_EQ(found.largest_failed, tried.back());
  EXPECT_THAT(advice(found), HasSubstr(std::to_string(tried.back()) + " atoms do not hold"));
  EXPECT_THAT(advice(found), testing::Not(HasSubstr("--atoms")));
}

// A wedge that comes to nothing is too thin at any size. That none was found is no word about the number asked for.
TEST(SizeAdvice, SaysHowFarItLookedWhereFeaturesAreAlwaysTooSmall) {
  const TriangleMesh wedge{
      {{0, 0, 0}, {0, 40, 0}, {12, 0, 0.3}, {12, 40, 0.3}, {12, 0, -0.3}, {12, 40, -0.3}},
      {{0, 3, 1}, {0, 2, 3}, {0, 1, 5}, {0, 5, 4}, {2, 4, 5}, {2, 5, 3}, {0, 4, 2}, {1, 3, 5}}};
  std::vector<std::size_t> tried;
  const SizeFound found = next_size(search(wedge, 0, tried), 400, nullptr, 10'000);
  ASSERT_FALSE(found.atoms);
  EXPECT_TRUE(tried.empty());
  EXPECT_GE(found.refused_to, 3e5);
  EXPECT_THAT(advice(found), HasSubstr("no number of atoms up to 300000 was found"));
  EXPECT_THAT(advice(found), testing::Not(HasSubstr(" 400 ")));
}

}  // namespace
}  // namespace nanocarbon::building
