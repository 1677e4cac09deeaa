// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <compare>
#include <cstdint>

namespace nanocarbon {

using AtomIndex = std::uint32_t;

//! A bond between two atoms, first < second; in a periodic cell also the image of the second that is bonded
//! (first <= second there, and an atom may be bonded to its own image).
struct Bond {
  AtomIndex first;
  AtomIndex second;
  std::array<std::int32_t, 3> image = {0, 0, 0};
  friend auto operator<=>(const Bond&, const Bond&) = default;
};

}  // namespace nanocarbon
