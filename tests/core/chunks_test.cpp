// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/core/chunks.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nanocarbon {
namespace {

TEST(Chunks, EveryEntryIsVisitedOnce) {
  for (const unsigned threads : {1u, 2u, 5u})
    for (const std::size_t count : {std::size_t{0}, std::size_t{1}, chunk_size, 3 * chunk_size + 7}) {
      ThreadTeam team(threads);
      std::vector<int> visits(count, 0);
      for_chunks(&team, count, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) ++visits[i];
      });
      EXPECT_EQ(visits, std::vector<int>(count, 1));
    }
}

TEST(Chunks, SumsAreTheSameToTheLastBitForAnyNumberOfThreads) {
  const std::size_t count = 10 * chunk_size + 3;
  const auto sum_of = [](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i) sum += std::sin(static_cast<double>(i * i));
    return sum;
  };
  const double alone = sum_chunks(nullptr, count, sum_of);
  EXPECT_NEAR(alone, sum_of(0, count), 1e-9);
  for (const unsigned threads : {2u, 3u, 8u}) {
    ThreadTeam team(threads);
    EXPECT_EQ(sum_chunks(&team, count, sum_of), alone);
  }
}

TEST(Chunks, TheLargestIsFoundWhereverItIs) {
  const std::size_t count = 3 * chunk_size;
  ThreadTeam team(2);
  for (const std::size_t at : {std::size_t{0}, chunk_size + 5, count - 1})
    EXPECT_EQ(largest_in_chunks(
                  &team, count,
                  [&](std::size_t begin, std::size_t end) { return begin <= at && at < end ? 7.0 : 1.0; }),
              7.0);
}

}  // namespace
}  // namespace nanocarbon
