// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "nanocarbon/topology/bond_graph.h"

namespace nanocarbon {

//! Atoms as one MPI rank of LAMMPS holds them: its own first, then copies of others' ("ghosts") near by.
struct RankAtoms {
  const double* positions;  //!< three for each atom, Angstrom
  const int* types;         //!< LAMMPS's atom types, from 1
  int owned;
  int all;
  std::span<const std::int64_t> ids;  //!< of each atom when the watch began; 0: not watched
  std::span<const Element> element_of_type;
};

//! \brief The bonds of an owned atom to atoms of higher ID (or to images of itself).
//! \details So each bond is kept once in the whole run, with the atom of the lower ID, and moves with it
//! between ranks. More than an atom of any sane structure can have are dropped.
struct Partners {
  static constexpr int most = 12;
  std::int32_t count = 0;
  std::array<std::int64_t, most> ids = {};

  void add(std::int64_t id) {
    if (count < most) ids[count++] = id;
  }
};

//! A pair that is bonded or could be before the next reneighbouring; the owned atom has the lower ID.
struct CandidateBond {
  int owned;
  int other;             //!< owned or ghost
  double squared_reach;  //!< nearer than this the pair is bonded; by hysteresis, depends on `before`
  bool before;           //!< bonded at the last look that was adopted
  bool now;              //!< bonded at the latest look
};

struct CandidateBonds {
  std::vector<CandidateBond> pairs;
  std::vector<topology::BondedIds> parted;  //!< bonded before, but no longer in reach: broken
};

//! \brief Finds the pairs to look at until the next reneighbouring. `now` starts as `before`.
//! \param skin how much nearer two atoms may come before that, Angstrom
//! \pre ghosts reach as far as the longest bond's breaking distance and the skin
CandidateBonds find_candidates(const RankAtoms& atoms, std::span<const Partners> partners,
                               const topology::BondDistances& distances, double skin);

//! What differs from the bonds before: how many, and a sum of hashes that tells sets of changes apart. Both
//! add up over ranks to the same in any decomposition.
struct LocalChanges {
  std::uint64_t count = 0;
  std::uint64_t hash = 0;
};

//! Sets `now` from the distances, with hysteresis against `before`. Costs one distance a pair.
LocalChanges look(CandidateBonds& candidates, const RankAtoms& atoms);

//! Makes `now` what was before, in the candidates and in the partners of the owned atoms.
void adopt(CandidateBonds& candidates, const RankAtoms& atoms, const topology::BondDistances& distances,
           std::span<Partners> partners);

}  // namespace nanocarbon
