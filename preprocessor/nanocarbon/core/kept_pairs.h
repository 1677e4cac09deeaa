// SPDX-License-Identifier: GPL-2.0-or-later
// Pairs of atoms near each other, kept while atoms move.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "nanocarbon/core/rigid_blocks.h"
#include "nanocarbon/core/thread_team.h"
#include "nanocarbon/core/vec3.h"

namespace nanocarbon {

//! \brief All pairs of atoms closer than a distance, and some that are not, in free space.
//! \details Atoms are in blocks, and pairs are listed anew only between blocks that have come closer by a margin since
//! they were listed, beyond what moves as a whole: in a large molecule something always moves somewhere, and the rest
//! is left alone.
class KeptPairs {
 public:
  //! \param reach what pairs come closer than, Angstrom
  //! \param margin how much farther apart unlisted pairs are when they are looked for, Angstrom
  KeptPairs(double reach, double margin) : reach_(reach), margin_(margin) {}

  //! Whether a pair that is near is to be listed; must always answer the same. Called by several threads.
  using Wanted = std::function<bool(std::uint32_t, std::uint32_t)>;

  //! Lists what has come near.
  //! \return whether anything was listed anew
  bool update(std::span<const Vec3> positions, const Wanted& wanted, ThreadTeam* team = nullptr);

  //! Atoms listed as near each atom, sorted, in compressed rows: each pair in both.
  void rows(std::vector<std::size_t>& offsets, std::vector<std::uint32_t>& near) const;

 private:
  struct Box {
    Vec3 low, high;
  };
  struct BlockPair {
    std::uint32_t first, second;  // blocks
    double used;                  // of the margin
    std::vector<std::pair<std::uint32_t, std::uint32_t>> atoms;
  };
  void divide(std::span<const Vec3> positions);
  void measure_boxes(std::span<const Vec3> positions, ThreadTeam* team);
  bool boxes_have_moved() const;
  void find_block_pairs(ThreadTeam* team);
  void list(BlockPair& pair, std::span<const Vec3> positions, const Wanted& wanted) const;

  double reach_, margin_;
  std::vector<Vec3> checked_;  // positions that `used` is of
  double left_ = 0;            // of the margin there, of the pair that has the least
  RigidBlocks blocks_;
  std::vector<Box> boxes_, paired_boxes_;  // of blocks; of blocks when these were paired
  std::vector<BlockPair> pairs_;           // sorted; a block with itself included
};

}  // namespace nanocarbon
