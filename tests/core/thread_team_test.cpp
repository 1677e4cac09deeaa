// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/core/thread_team.h"

#include <gtest/gtest.h>

namespace nanocarbon {
namespace {

TEST(ThreadTeam, EveryTaskRunsOnceInEveryRound) {
  for (const unsigned threads : {1u, 2u, 5u}) {
    ThreadTeam team(threads);
    ASSERT_EQ(team.size(), threads);
    for (int round = 0; round < 50; ++round) {
      std::vector<int> runs(37, 0);
      std::atomic<bool> known = true;
      team.run(runs.size(), [&](std::size_t index, unsigned thread) {
        ++runs[index];
        if (thread >= threads) known = false;
      });
      EXPECT_TRUE(known);
      EXPECT_EQ(runs, std::vector<int>(37, 1));
    }
  }
}

TEST(ThreadTeam, NoTasksAreNoWork) {
  ThreadTeam team(2);
  team.run(0, [](std::size_t, unsigned) { FAIL(); });
}

}  // namespace
}  // namespace nanocarbon
