// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "nanocarbon/potential/near_pairs.h"
#include "nanocarbon/potential/rebo2/kernels/sp2_kernel.h"
#include "nanocarbon/potential/rebo2/parameters.h"

namespace nanocarbon::rebo2 {

//! \brief Which atoms the fast loops may evaluate, and their bonds in the loops' layout; valid until the near pairs
//! change.
//! \details A carbon whose three nearest atoms are carbons, none of them bonded to each other, is a
//! candidate. Whether it is in the fast case is determined at each evaluation: the loops report bonds that are too
//! long or too short and angles that are too straight, and every other near pair of a candidate is watched.
struct Sp2Blocks {
  static constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();

  //! Blocks that one call of the first pass takes; the second pass follows as soon as it can.
  static constexpr std::size_t window = 32;

  std::size_t own_blocks = 0;             //!< blocks of own atoms come first
  std::size_t blocks = 0;                 //!< then those of the copies that own atoms may be bonded to
  std::vector<std::uint32_t> atoms;       //!< [block][lane]; padding repeats an atom
  std::vector<std::uint32_t> neighbours;  //!< [block][s][lane]
  std::vector<std::uint32_t>
      reverses;                      //!< [block][s][lane]; zero_record() where the neighbour is no candidate
  std::vector<std::uint32_t> real;   //!< [block] a bit for each lane that is not padding
  std::vector<std::uint32_t> place;  //!< of an atom: block * sp2_block + lane, or nowhere
  std::vector<std::uint32_t> slots;  //!< [block]; own blocks take turns, see Sp2Data
  std::size_t slot_count = 0;
  std::vector<std::uint32_t>
      needs;  //!< [own block] the second pass of it and those before needs this many first ones

  std::vector<std::array<std::uint32_t, 2>> watched;  //!< near pairs of candidates that are not bonds
  std::vector<std::uint32_t> others;   //!< atoms that are not candidates: own ones and copies next to them
  std::vector<std::uint32_t> crowded;  //!< copies further out that may have four bonds or more

  std::uint32_t zero_record() const { return static_cast<std::uint32_t>(3 * sp2_block * slot_count); }
  std::uint32_t neighbour(std::uint32_t at, int s) const { return neighbours[index(at, s)]; }
  //! Where an array [block][s][lane] has bond s of the candidate at a place.
  static std::size_t index(std::uint32_t at, int s) {
    return (at / sp2_block * 3 + s) * sp2_block + at % sp2_block;
  }
};

Sp2Blocks make_sp2_blocks(const potential::AtomsView& atoms, const potential::NearPairs& near,
                          const Rebo2Parameters& parameters);

}  // namespace nanocarbon::rebo2
