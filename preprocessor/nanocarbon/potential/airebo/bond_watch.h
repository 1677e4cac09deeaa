// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "nanocarbon/potential/airebo/parameters.h"
#include "nanocarbon/potential/near_pairs.h"

namespace nanocarbon::airebo {

//! \brief Finds the atoms for which a fixed list of whole bonds is no longer right.
//! \details An atom is disturbed if one of its bonds is fractional, has gone, or is new. Fractional bonds between two
//! hydrogens whose only other bond is to the same atom, as in every CH2 group, do not count: for every path along such
//! a bond there is a shorter one of weight 1.
class BondWatch {
 public:
  //! \brief Prepares for the near pairs of some atoms.
  //! \param whole_bonds the list, by find_whole_bonds()
  //! \param watched the atoms that matter; one flag for each atom
  //! \param margin the most by which two atoms approach each other before this is called again, Angstrom
  void prepare(const potential::AtomsView& atoms, const potential::NearPairs& near,
               const potential::NearPairs& whole_bonds, const std::vector<char>& watched,
               const AireboParameters& parameters, double margin);

  //! The disturbed atoms among those that matter, and their partners.
  const std::vector<std::uint32_t>& find(const double* positions);
  bool is_disturbed(std::uint32_t atom) const { return flags_[atom] != 0; }

 private:
  struct Pair {
    std::uint32_t i;
    std::uint32_t j;
    double squared_limit;  // Angstrom^2
  };
  void flag(const Pair& pair);

  std::vector<Pair> whole_;     // bonds, which must be shorter
  std::vector<Pair> separate_;  // near pairs, which must not be
  std::vector<char> flags_;
  std::vector<std::uint32_t> disturbed_;
};

}  // namespace nanocarbon::airebo
