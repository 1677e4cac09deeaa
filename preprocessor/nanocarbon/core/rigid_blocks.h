// SPDX-License-Identifier: GPL-2.0-or-later
// How the parts of a structure move as a whole.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "nanocarbon/core/thread_team.h"
#include "nanocarbon/core/vec3.h"

namespace nanocarbon {

//! Atoms that were in one cube of space.
struct RigidBlock {
  std::uint32_t begin = 0, end = 0;  //!< in the order of RigidBlocks
  Vec3 centre = Vec3::Zero();        //!< of the atoms where they were
  double radius = 0;                 //!< of the atoms about the centre
  Vec3 now = Vec3::Zero();           //!< where the centre has gone
  Mat3 turn = Mat3::Identity();
  double spread = 0;  //!< how far an atom is from where the rigid motion takes it, at most
};

//! Side of the cubes, Angstrom.
inline constexpr double block_side = 12;

//! \brief Atoms in blocks, and for each block the rigid motion that fits its atoms best (Kabsch 1976).
class RigidBlocks {
 public:
  //! Divides atoms by the cubes of space that they are in.
  //! \return pairs of blocks whose cubes touch, each once, by number
  std::vector<std::pair<std::uint32_t, std::uint32_t>> divide(std::span<const Vec3> positions);

  bool empty() const { return blocks_.empty(); }
  const std::vector<RigidBlock>& all() const { return blocks_; }
  std::span<const std::uint32_t> atoms(std::size_t block) const {
    return {atoms_.data() + blocks_[block].begin, atoms_.data() + blocks_[block].end};
  }

  //! Takes positions as those where the atoms were.
  void set_from(std::span<const Vec3> was, ThreadTeam* team = nullptr);
  //! Fits the motions from there.
  //! \pre positions `was` have been set
  void fit(std::span<const Vec3> was, std::span<const Vec3> is, ThreadTeam* team = nullptr);

 private:
  std::vector<std::uint32_t> atoms_;  // by block
  std::vector<RigidBlock> blocks_;
};

//! How much closer the motions of two blocks bring an atom of one and an atom of the other, at most, Angstrom.
double approach(const RigidBlock& one, const RigidBlock& other);

}  // namespace nanocarbon
