// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace nanocarbon::cli {

//! A progress bar on stderr, drawn only where stderr is a terminal and quiet was not asked for.
class ProgressBar {
 public:
  explicit ProgressBar(bool quiet);
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  ~ProgressBar();

  //! \param stage what is being done
  //! \param fraction 0 to 1
  void show(std::string_view stage, double fraction);

 private:
  bool drawn_ = false;
  bool active_;
  std::chrono::steady_clock::time_point last_{};
  std::string last_stage_;
};

}  // namespace nanocarbon::cli
