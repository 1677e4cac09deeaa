// SPDX-License-Identifier: GPL-2.0-or-later
// Tells whether a list of near pairs is still complete after atoms have moved.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "nanocarbon/core/rigid_blocks.h"
#include "nanocarbon/core/thread_team.h"
#include "nanocarbon/core/vec3.h"

namespace nanocarbon {

//! \brief Watches whether two atoms that were farther apart than a distance may have come closer than it by more
//! than a margin.
//! \details Parts that move and turn as a whole do not count, however far: for the atoms of each cube of space the
//! rigid motion is found that fits theirs best (Kabsch 1976), and compared between cubes that touch. As long as no
//! atom has moved by half of what was left of the margin when that was last done it is not done again. Never says
//! no where it should say yes.
class ApproachWatch {
 public:
  //! \param reach what pairs come closer than, Angstrom; at most 6
  //! \param margin how much farther apart unlisted pairs are at the reference, Angstrom
  ApproachWatch(double reach, double margin) : reach_(reach), margin_(margin) {}

  //! Takes positions as the reference.
  void set(std::span<const Vec3> positions);
  //! Number of atoms of the reference.
  std::size_t atoms() const { return reference_.size(); }

  //! \param whole_parts whether parts may move as a whole; in a cell they may not, for atoms at its faces are near
  //! images of others
  bool may_be_closer(std::span<const Vec3> positions, bool whole_parts, ThreadTeam* team = nullptr);

 private:
  double largest_approach(std::span<const Vec3> positions, ThreadTeam* team);

  double reach_, margin_;
  std::vector<Vec3> reference_, checked_;
  double left_ = 0;     // of the margin when the positions were checked
  RigidBlocks blocks_;  // of the reference
  std::vector<std::pair<std::uint32_t, std::uint32_t>> adjacent_;  // blocks that touch
};

}  // namespace nanocarbon
