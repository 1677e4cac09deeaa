// SPDX-License-Identifier: GPL-2.0-or-later
#include "progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace nanocarbon::cli {

ProgressBar::ProgressBar(bool quiet) : active_(!quiet && isatty(STDERR_FILENO)) {}

ProgressBar::~ProgressBar() {
  if (drawn_) fmt::print(stderr, "\r\033[K");
}

void ProgressBar::show(std::string_view stage, double fraction) {
  if (!active_) return;
  const auto now = std::chrono::steady_clock::now();
  if (stage == last_stage_ && now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  last_stage_ = stage;
  constexpr int width = 30;
  const double shown = std::clamp(fraction, 0.0, 1.0);
  const int full = static_cast<int>(shown * width);
  fmt::print(stderr, "\r\033[K{:<24} [{:<{}}] {:3.0f}%", stage,
             std::string(static_cast<std::size_t>(full), '='), width, 100 * shown);
  std::fflush(stderr);
  drawn_ = true;
}

}  // namespace nanocarbon::cli
