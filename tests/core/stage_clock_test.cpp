// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/core/stage_clock.h"

#include <gtest/gtest.h>

namespace nanocarbon {
namespace {

void wait(double seconds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (std::chrono::steady_clock::now() < end) {
  }
}

TEST(StageClock, InnerStagesAreNotCountedForOuterOnes) {
  StageClock clock;
  const auto begin = std::chrono::steady_clock::now();
  {
    const auto outer = StageClock::stage(&clock, "outer");
    wait(0.02);
    {
      const auto inner = StageClock::stage(&clock, "inner");
      wait(0.03);
    }
    wait(0.02);
  }
  const double whole = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  ASSERT_EQ(clock.times().size(), 2u);
  EXPECT_EQ(clock.times()[0].name, "outer");
  EXPECT_EQ(clock.times()[1].name, "inner");
  EXPECT_GE(clock.times()[0].wall, 0.04);
  EXPECT_GE(clock.times()[1].wall, 0.03);
  EXPECT_LE(clock.times()[0].wall + clock.times()[1].wall, whole);
  for (const StageClock::Time& time : clock.times()) EXPECT_GT(time.cpu, 0);
}

TEST(StageClock, TheSameNameAddsUp) {
  StageClock clock;
  for (int k = 0; k < 3; ++k) {
    const auto stage = StageClock::stage(&clock, "again");
    wait(0.01);
  }
  wait(0.01);
  ASSERT_EQ(clock.times().size(), 1u);
  EXPECT_GE(clock.times()[0].wall, 0.03);
}

TEST(StageClock, NoClockMeasuresNothing) {
  const Running running;
  const auto stage = running.stage("nothing");
  EXPECT_EQ(running.threads(), 1u);
}

}  // namespace
}  // namespace nanocarbon
