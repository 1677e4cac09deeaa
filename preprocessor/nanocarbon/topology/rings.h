// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "nanocarbon/topology/bonds.h"

namespace nanocarbon {

//! Rings (faces of the bond graph on its surface) as atom cycles, counter-clockwise seen from outside, in
//! compressed rows.
struct Rings {
  std::vector<std::uint32_t> offsets = {0};  //!< size rings + 1
  std::vector<AtomIndex> atoms;

  std::size_t size() const { return offsets.size() - 1; }
  std::span<const AtomIndex> operator[](std::size_t ring) const {
    return {atoms.data() + offsets[ring], atoms.data() + offsets[ring + 1]};
  }
};

}  // namespace nanocarbon
