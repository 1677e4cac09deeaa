// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>

#include "nanocarbon/remeshing/crystal/tiling.h"

namespace nanocarbon::crystal {

//! What a valence repair did.
struct ValenceRepair {
  std::size_t flips = 0;
  std::size_t left = 0;  //!< inner vertices whose valence is still outside 5 to 7
};

//! \brief Brings valences into 5 to 7 by sequences of up to three flips around each vertex that is outside.
//! \details A sequence is taken when it lowers a penalty that counts a valence of 4 or 8 as eight of 5 or 7.
//! Flips may distort triangles; even edges afterwards.
ValenceRepair repair_valences(Tiling& tiling);

}  // namespace nanocarbon::crystal
