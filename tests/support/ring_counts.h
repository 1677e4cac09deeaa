// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>

#include "nanocarbon/topology/rings.h"

namespace nanocarbon::test {

//! How many rings have so many atoms.
inline std::size_t rings_of(const Rings& rings, std::size_t size) {
  std::size_t count = 0;
  for (std::size_t r = 0; r < rings.size(); ++r) count += rings[r].size() == size;
  return count;
}

}  // namespace nanocarbon::test
