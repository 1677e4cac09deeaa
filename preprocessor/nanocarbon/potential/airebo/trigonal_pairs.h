// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "nanocarbon/potential/airebo/bond_watch.h"
#include "nanocarbon/potential/airebo/model.h"
#include "nanocarbon/potential/airebo/sp2_order_bound.h"
#include "nanocarbon/potential/near_pairs.h"

namespace nanocarbon::airebo {

//! \brief Close pairs of carbons with three whole bonds each: those of sheets that face each other.
//! \details b* is nearly always too low there for S_b to switch, which loops over several pairs find out.
class TrigonalPairs {
 public:
  //! \param model kept by reference
  explicit TrigonalPairs(const AireboModel& model);

  void clear(std::size_t atoms);
  //! \return whether both atoms are such carbons; otherwise the pair is not taken
  bool add(std::uint32_t i, std::uint32_t j, const potential::AtomsView& atoms,
           const potential::NearPairs& whole_bonds);

  //! \brief Adds what S_b takes off them, see add_trigonal_term().
  //! \param left pairs in reach one of whose atoms has other bonds now are appended
  //! \return eV
  double evaluate(const potential::AtomsView& atoms, const BondWatch& watch, double* forces,
                  std::vector<std::array<std::uint32_t, 2>>& left);

  //! Sets a flag for the second atom of each pair.
  void mark_second_atoms(std::vector<char>& flags) const {
    for (const Pair& pair : pairs_) flags[pair.j] = 1;
  }
  std::size_t memory() const;

 private:
  static constexpr std::uint32_t unknown = ~0u, other = ~0u - 1;  // instead of a number in carbons_
  struct Pair {
    std::uint32_t i, j;                // atoms
    std::uint32_t carbon_i, carbon_j;  // places in carbons_
  };
  std::uint32_t carbon_of(std::uint32_t atom, const potential::AtomsView& atoms,
                          const potential::NearPairs& whole_bonds);
  void place(TrigonalCarbon& carbon, const potential::AtomsView& atoms) const;

  const AireboModel& model_;
  bool plain_;
  Sp2OrderBound bound_;
  std::vector<std::uint32_t> numbers_;  // of atoms in carbons_
  std::vector<TrigonalCarbon> carbons_;
  std::vector<Pair> pairs_;
  std::vector<std::uint32_t> high_;
  std::uint64_t step_ = 0;
};

}  // namespace nanocarbon::airebo
