// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "nanocarbon/potential/airebo/parameters.h"
#include "nanocarbon/potential/near_pairs.h"

namespace nanocarbon::airebo {

//! \brief Finds the atoms that a static picture of whole bonds is wrong about.
//! \details An atom is disturbed if one of its bonds is fractional, is gone, or is new. Not counted are
//! fractional bonds between two hydrogens whose one and only bond is to the same atom, as in every CH2 group:
//! every path along such a bond has a shorter one of weight 1 beside it.
class BondWatch {
 public:
  //! \brief Prepares for the near pairs of some atoms.
  //! \param whole_bonds the picture, by find_whole_bonds()
  //! \param watched the atoms that matter; one flag for each atom
  //! \param margin two atoms come nearer to each other by at most this, until this is called again, Angstrom
  void prepare(const potential::AtomsView& atoms, const potential::NearPairs& near,
               const potential::NearPairs& whole_bonds, const std::vector<char>& watched,
               const AireboParameters& parameters, double margin);

  //! The disturbed ones of the atoms that matter, and their partners.
  const std::vector<std::uint32_t>& find(const double* positions);
  bool is_disturbed(std::uint32_t atom) const { return flags_[atom] != 0; }

 private:
  struct Pair {
    std::uint32_t i;
    std::uint32_t j;
    double squared_limit;  // Angstrom^2
  };
  void flag(const Pair& pair);

  std::vector<Pair> whole_;     // bonds, which shall be shorter
  std::vector<Pair> separate_;  // near pairs, which shall not be
  std::vector<char> flags_;
  std::vector<std::uint32_t> disturbed_;
};

}  // namespace nanocarbon::airebo
