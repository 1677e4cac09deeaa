// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/core/held_signals.h"

#include <csignal>

namespace nanocarbon {
namespace {

// A handler can leave word nowhere else.
volatile std::sig_atomic_t caught = 0;

void note(int signal) { caught = signal; }

}  // namespace

HeldSignals::HeldSignals() {
  caught = 0;
  struct sigaction noting {};
  noting.sa_handler = note;
  noting.sa_flags = SA_RESTART;
  for (std::size_t i = 0; i < held.size(); ++i) {
    sigaction(held[i], nullptr, &before_[i]);
    if (before_[i].sa_handler != SIG_IGN) sigaction(held[i], &noting, nullptr);
  }
}

HeldSignals::~HeldSignals() {
  for (std::size_t i = 0; i < held.size(); ++i) sigaction(held[i], &before_[i], nullptr);
  if (caught != 0) raise(caught);
}

}  // namespace nanocarbon
