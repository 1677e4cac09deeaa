// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "nanocarbon/potential/rebo2/general_evaluation.h"
#include "nanocarbon/potential/rebo2/kernels/sp2_kernel.h"
#include "nanocarbon/potential/rebo2/lane_evaluation.h"
#include "nanocarbon/potential/rebo2/sp2_blocks.h"
#include "nanocarbon/potential/rebo2/sp2_constants.h"
#include "nanocarbon/potential/rebo2/torsion_energy.h"

namespace nanocarbon::rebo2 {

//! \brief The bond-order energy, atom by atom with the fast loops where they apply and the general terms elsewhere.
//! \details Both evaluate the same function, so there is no jump when an atom changes from one to the other. The
//! angles of an atom in the fast case are evaluated by the loops whatever its neighbours are. So are the dihedrals of
//! a bond between two such atoms, unless a coordination that N_conj depends on is fractional; if it is whole but not
//! three, only the bond's constants differ. AIREBO's torsion energy of a bond is evaluated with its dihedrals.
//!
//! If more than a few atoms were outside the fast case when the lists were made, everything is left to
//! LaneEvaluation. For bonds between own atoms and copies it evaluates half of all terms, while the fast loops
//! evaluate those of the own atom: processes that share a system must make this choice together (choose()).
class MixedEvaluation {
 public:
  //! \param torsion adds AIREBO's torsion energy
  MixedEvaluation(const Rebo2Parameters& parameters, const Sp2Kernel& kernel,
                  const std::optional<TorsionBarriers>& torsion = {});

  //! To be called whenever the atoms, their elements or the near pairs have changed.
  void near_changed() { lists_are_good_ = false; }

  //! \brief Arguments and result as for evaluate_general(), with the torsion energy if there is one.
  //! \details Virials of single atoms are shared out term by term, so they come from the general terms alone;
  //! so do energies of single atoms with a torsion energy.
  EnergyParts evaluate(const potential::AtomsView& atoms, const potential::NearPairs& near, double* forces,
                       const potential::AtomShares& shares, bool general_only = false);

  //! Number of own atoms outside the fast case, by the present near pairs.
  std::size_t outside_fast_case(const potential::AtomsView& atoms, const potential::NearPairs& near) const;
  //! Whether the lane loops are faster for everything if this many of the own atoms are outside.
  static bool lanes_pay(std::size_t outside, std::size_t own);
  //! Sets whether the lane loops evaluate everything; otherwise evaluate() decides this by its own atoms.
  void choose(bool lanes) {
    if (chosen_ != lanes) lists_are_good_ = false;
    chosen_ = lanes;
  }

  //! Whether the lane loops did everything in the last evaluation.
  bool uses_lanes() const { return use_lanes_; }
  //! Number of own atoms that the last evaluation left to the general terms.
  std::size_t general_atoms() const { return general_own_; }
  //! Bytes held by the arrays that grow with the atoms.
  std::size_t memory() const;

 private:
  using Bond = std::pair<std::uint32_t, std::uint32_t>;

  bool is_fast(std::uint32_t atom) const {
    return blocks_.place[atom] != Sp2Blocks::nowhere && !general_flag_[atom];
  }
  void make_blocks(const potential::AtomsView& atoms, const potential::NearPairs& near);
  Sp2Modifiers* modifiers_of(std::uint32_t place);
  void reset_modifiers();
  void flag_general(std::uint32_t atom);
  //! Atoms that are no candidates, and candidates with a fourth neighbour.
  void find_crowded_atoms(const potential::AtomsView& atoms, const potential::NearPairs& near);
  void switch_off(std::uint32_t atom);
  void switch_off_bond(std::uint32_t fast, std::uint32_t general);
  void switch_off_crowded_atoms();
  //! Of what the first pass has found out about these blocks.
  void switch_off_outside(std::size_t begin_block, std::size_t end_block);
  //! Constants of bonds between fast atoms whose N_conj depends on an atom with four neighbours.
  void modify_crowded_bonds(const potential::AtomsView& atoms);
  EnergyParts evaluate_mixed(const potential::AtomsView& atoms, const potential::NearPairs& near,
                             double* forces, const potential::AtomShares& shares);
  EnergyParts run_fast_loops(const Sp2Data& data);
  void find_general_bonds(const potential::AtomsView& atoms, const potential::NearPairs& near);
  void set_bond_constants(std::uint32_t at, int s, const Sp2BondConstants& constants);
  EnergyParts add_general_terms(const potential::AtomsView& atoms, const potential::NearPairs& near,
                                double* forces, const potential::AtomShares& shares);

  Rebo2Parameters parameters_;
  Sp2Constants constants_;
  Sp2BondConstants bond_constants_;
  std::optional<TorsionBarriers> torsion_;
  Sp2Loops loops_;
  double watch_squared_;

  bool fast_applies_;
  bool lanes_apply_;

  LaneEvaluation lanes_;
  std::optional<bool> chosen_;
  bool use_lanes_ = false;
  bool lists_are_good_ = false;
  Sp2Blocks blocks_;
  std::vector<double> geometry_;
  std::vector<double> tensors_;
  std::vector<double> edge_energies_;
  std::vector<std::uint32_t> outside_;

  Sp2Modifiers plain_;
  std::vector<Sp2Modifiers> modifier_pool_;
  std::vector<const Sp2Modifiers*> modifiers_;
  std::vector<std::uint32_t> modified_blocks_;

  std::vector<char> general_flag_;      // of every atom
  std::vector<std::uint32_t> general_;  // flagged atoms, own ones and copies
  std::vector<Bond> bonds_;             // whose own terms are general, an own atom first
  std::vector<Bond> crowded_bonds_;
  std::vector<Bond> fractional_bonds_;  // of these, those with a fractional coordination
  std::size_t general_own_ = 0;
  GeneralWorkspace workspace_;
};

}  // namespace nanocarbon::rebo2
