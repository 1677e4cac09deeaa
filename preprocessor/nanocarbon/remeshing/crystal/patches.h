// SPDX-License-Identifier: GPL-2.0-or-later
// Parts of a tiling that are worked on by themselves.
#pragma once

#include <span>
#include <vector>

#include "nanocarbon/remeshing/crystal/tiling.h"

namespace nanocarbon::crystal {

//! A part of a tiling: its two outermost rows of vertices are held.
struct Patch {
  Tiling tiling;
  std::vector<std::uint32_t> triangles;  //!< of the whole that it stands for
};

//! \brief Cuts out copies of what surrounds some vertices. Surroundings that touch are one patch.
//! \param whole compact
//! \param reach edges from a vertex to where its patch ends; at least 3
std::vector<Patch> surroundings(const Tiling& whole, std::span<const VertexIndex> around, int reach);

//! Puts patches in the place of what they were cut from.
//! \param whole as it was then; compact on return
void replace(Tiling& whole, std::span<const Patch> patches);

}  // namespace nanocarbon::crystal
