// SPDX-License-Identifier: GPL-2.0-or-later
// Which atoms of a frame are which of the frame before, where the file has no IDs.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::analysis {

//! The IDs of a frame's atoms, and what is doubtful about them.
struct AtomMatching {
  std::vector<std::int64_t> ids;  //!< of each atom, in the frame's order; all different
  std::string doubt;              //!< what a user should know; empty where the atoms are in the same order
};

//! \brief Finds a frame's atoms in the frame before.
//! \details Atoms are in the same order where both frames have the same elements, unless their places explain the frame
//! much better: nearly all atoms have one of their element within 1 Angstrom that is nearest either way, and they move by
//! less than half of what they would in the order of the file, the motion of the whole left out. What is left then is
//! paired by distance as far as there are pairs. Where neither can be, the order in the file is all that there is, which
//! `doubt` says.
//! \param before_ids of the atoms of the frame before
//! \param next_id the first ID that no frame has had so far: of atoms that are new
AtomMatching match_atoms(const Molecule& now, const Molecule& before,
                         std::span<const std::int64_t> before_ids, std::int64_t next_id);

}  // namespace nanocarbon::analysis
