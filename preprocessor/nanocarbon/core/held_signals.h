// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <signal.h>

#include <array>

namespace nanocarbon {

//! \brief While it lives, SIGINT, SIGTERM and SIGHUP wait; one that came is raised again at the end.
//! \details For the whole program, since any of its threads may be the one that gets a signal. Signals that
//! are ignored stay ignored (nohup). Not to be nested.
class HeldSignals {
 public:
  HeldSignals();
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;
  ~HeldSignals();

 private:
  static constexpr std::array<int, 3> held = {SIGINT, SIGTERM, SIGHUP};
  std::array<struct sigaction, held.size()> before_;
};

}  // namespace nanocarbon
