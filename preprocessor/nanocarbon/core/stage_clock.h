// SPDX-License-Identifier: GPL-2.0-or-later
// Tells which stages of a computation take how much time.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "nanocarbon/core/thread_team.h"

namespace nanocarbon {

//! \brief Time by stage: wall-clock, and of the processors by all threads of the program.
//! \details Stages may be within each other: what an inner one takes is not counted for the outer one. One
//! thread measures; the same name again adds up.
class StageClock {
 public:
  struct Time {
    std::string name;
    double wall = 0;  //!< seconds
    double cpu = 0;   //!< seconds
  };

  //! A stage from here until it goes out of scope.
  class [[nodiscard]] Stage {
   public:
    Stage(StageClock* clock, std::size_t former) : clock_(clock), former_(former) {}
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;
    ~Stage() {
      if (clock_) clock_->go_on_with(former_);
    }

   private:
    StageClock* clock_;
    std::size_t former_;
  };

  //! \param clock may be null: then nothing is measured
  static Stage stage(StageClock* clock, std::string_view name);

  //! Of the stages that have ended, in the order in which they began first.
  const std::vector<Time>& times() const { return times_; }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  void go_on_with(std::size_t stage);

  std::vector<Time> times_;
  std::size_t now_ = none;
  std::chrono::steady_clock::time_point wall_;
  double cpu_ = 0;
};

//! How a computation runs; it changes nothing of the result.
struct Running {
  ThreadTeam* team = nullptr;   //!< may be null: one thread
  StageClock* clock = nullptr;  //!< may be null

  unsigned threads() const { return team ? team->size() : 1; }
  StageClock::Stage stage(std::string_view name) const { return StageClock::stage(clock, name); }
};

}  // namespace nanocarbon
