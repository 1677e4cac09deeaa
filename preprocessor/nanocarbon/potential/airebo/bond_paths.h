// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "nanocarbon/potential/rebo2/half_edges.h"

namespace nanocarbon::airebo {

//! A path from one atom to another along bonds.
struct BondPath {
  std::uint32_t to;
  int length;                          //!< bonds, 1 to 3
  double weight;                       //!< the product of theirs
  std::array<std::uint32_t, 3> bonds;  //!< numbers of half-edges; the first ones are set
};

//! \brief For one atom, the best path to each atom that up to three bonds lead to.
//! \details C_ij = 1 - the weight of the best path from i to j (Stuart et al. 2000, equation 13), so no path
//! means C_ij = 1. Of equally good paths the first found counts, in LAMMPS's order: the bond itself, then, one
//! neighbour after the other, the paths through it, those of two bonds before those of three.
class BondPaths {
 public:
  //! \brief Finds them.
  //! \pre the bonds of the atom, of its neighbours and of theirs have been found
  void find(rebo2::HalfEdges& edges, std::uint32_t from);

  //! \return nullptr where there is none
  const BondPath* to(std::uint32_t atom) const {
    return atom < place_.size() && place_[atom] != nowhere ? &paths_[place_[atom]] : nullptr;
  }
  const std::vector<BondPath>& all() const { return paths_; }

 private:
  static constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();
  void offer(const BondPath& path);

  std::vector<BondPath> paths_;
  std::vector<std::uint32_t> place_;  // of an atom in paths_
};

}  // namespace nanocarbon::airebo
