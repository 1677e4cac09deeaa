// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/core/stage_clock.h"

#include <algorithm>
#include <ctime>

namespace nanocarbon {

namespace {

double processor_seconds() {
  timespec now = {};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

StageClock::Stage StageClock::stage(StageClock* clock, std::string_view name) {
  if (!clock) return {nullptr, none};
  const auto found = std::find_if(clock->times_.begin(), clock->times_.end(),
                                  [&](const Time& time) { return time.name == name; });
  const auto index = static_cast<std::size_t>(found - clock->times_.begin());
  if (found == clock->times_.end()) clock->times_.push_back({std::string(name)});
  const std::size_t former = clock->now_;
  clock->go_on_with(index);
  return {clock, former};
}

void StageClock::go_on_with(std::size_t stage) {
  const auto wall = std::chrono::steady_clock::now();
  const double cpu = processor_seconds();
  if (now_ != none) {
    times_[now_].wall += std::chrono::duration<double>(wall - wall_).count();
    times_[now_].cpu += cpu - cpu_;
  }
  now_ = stage;
  wall_ = wall;
  cpu_ = cpu;
}

}  // namespace nanocarbon
