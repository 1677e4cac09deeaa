// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>

#include "nanocarbon/annealing/network_edit.h"

namespace nanocarbon::annealing {

//! A number that identifies a switch of a network.
//! \param identity of each atom, which it keeps when entries change
std::uint64_t switch_key(const NetworkEdit& edit, std::span<const std::uint32_t> identity);

//! \brief Remembers which bond switches were refused, and under which allowance.
//! \details A switch that costs too much today costs as much tomorrow while its surroundings stay: only a
//! draw above all former allowances is worth a relaxation. So n trials cost about log n, which is what makes
//! slow cooling cheap (rejection bookkeeping as in Bortz, Kalos and Lebowitz 1975, but by bounds). Forgotten
//! after a few blocks, since the whole relaxes meanwhile.
class RefusedSwitches {
 public:
  //! Whether a switch has been refused under this allowance (eV) or a higher one, and later than `since`.
  bool contains(std::uint64_t key, double allowance, std::uint64_t since) const;
  void add(std::uint64_t key, double allowance, std::uint64_t now);
  void next_block();

 private:
  struct Refusal {
    double allowance;   // eV
    std::uint64_t now;  // the caller's count of time
    int block;
  };
  std::unordered_map<std::uint64_t, Refusal> refusals_;
  int block_ = 0;
};

}  // namespace nanocarbon::annealing
