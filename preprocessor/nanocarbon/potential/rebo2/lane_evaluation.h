// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "nanocarbon/potential/near_pairs.h"
#include "nanocarbon/potential/rebo2/energy_parts.h"
#include "nanocarbon/potential/rebo2/lane_bond_batches.h"
#include "nanocarbon/potential/rebo2/lane_centre_batches.h"
#include "nanocarbon/potential/rebo2/lane_nodes.h"

namespace nanocarbon::rebo2 {

//! \brief The bond-order energy of any carbon and hydrogen, by the lane loops: what evaluate_general() gives,
//! up to rounding.
//! \details Atoms are sorted by their numbers of bonds to carbon and to hydrogen. Of bonds as a whole only those are evaluated whose F or T can be other than zero, and that have
//! dihedrals by their numbers of arms. Derivatives by coordination numbers are gathered by atom, so that
//! conjugation costs no sum over the neighbours' neighbours of each bond.
//!
//! What is found is kept from step to step while the half-edges stay good (LaneNodes). Bonds between steady nodes with
//! steady neighbours have the same coordination numbers then, whatever moves; the others are selected anew. Where
//! many nodes are restless, or half-edges have gone bad within a few steps, as in hot matter, nothing is
//! remembered until the near pairs change.
class LaneEvaluation {
 public:
  LaneEvaluation(const Rebo2Parameters& parameters, const LaneLoops& loops,
                 const std::optional<TorsionBarriers>& torsion);
  LaneEvaluation(const LaneEvaluation&) = delete;
  LaneEvaluation& operator=(const LaneEvaluation&) = delete;

  //! To be called whenever the atoms, their elements or the near pairs have changed.
  void near_changed(const potential::AtomsView& atoms, const potential::NearPairs& near) {
    nodes_.near_changed(atoms, near);
    remembers_ = false;
    bad_memories_ = 0;
  }

  //! \brief Arguments and result as of evaluate_general().
  //! \param atom_energies of all atoms, added to, or nullptr
  //! \return nothing where an atom has more than lane_most_bonds bonds: then nothing was added
  std::optional<EnergyParts> evaluate(const potential::AtomsView& atoms, double* forces,
                                      double* atom_energies);

  //! Evaluations that took the bonds remembered from an earlier one.
  std::size_t remembered_steps() const { return remembered_steps_; }
  //! Bytes held by the arrays that grow with the atoms.
  std::size_t memory() const;

 private:
  //! What conjugation needs to know of a half-edge.
  struct Conjugation {
    double unsaturation, slope;      // F of the far end's other bonds
    double by_coordination, by_sum;  // to be taken from what the near end has gathered
  };
  //! A bond that has terms as a whole.
  struct Selected {
    std::uint32_t edge;
    bool dihedrals;
  };

  bool arrange(std::uint32_t own);
  bool find_and_remember(std::uint32_t own);
  bool find_for_once(std::uint32_t own);
  void sort_centres(std::uint32_t own);
  void sort_restless_centres();
  bool find_terms(std::uint32_t own);
  bool find_neighbours_of_copies(std::uint32_t own);
  std::array<int, 2> places_in_tables(std::uint32_t edge) const;
  bool may_have_terms(std::uint32_t edge) const;
  void select_restless(std::uint32_t own);
  bool has_steady_neighbours(const LaneNode& node) const;
  void find_conjugation(LaneNode& node);
  void add_bond(const Selected& bond, std::uint32_t own, LaneBondBatches& to);
  void gather_derivatives(const LaneBondBatch& batch);
  void differentiate(LaneNode& node);
  void add_derivatives_by_weight();

  LaneConstants constants_;
  const LaneLoops& loops_;
  double conjugation_begin_, conjugation_end_;
  //! By pair_index() and where N_ij and N_ji are: at a knot (even) or between two (odd).
  std::array<std::array<std::array<bool, 9>, 9>, 3> has_terms_;
  std::array<std::array<bool, 9>, 9> has_dihedrals_;

  LaneNodes nodes_;
  std::size_t remembered_steps_ = 0;
  bool remembers_ = false;                     // half-edges
  int good_steps_ = 0;                         // since they were found
  int bad_memories_ = 0;                       // since the near pairs changed
  std::vector<double> forces_;                 // [atom][4]
  std::vector<double> energies_;               // [edge]
  std::vector<Conjugation> conjugation_;       // [edge] of nodes that have it
  std::vector<char> is_conjugated_;            // [node]
  std::vector<std::uint32_t> differentiated_;  // nodes with derivatives by their coordination or sum
  std::vector<char> is_differentiated_;        // [node]
  std::vector<Selected> selected_;
  std::vector<std::uint32_t> restless_bonds_;    // half-edges
  std::vector<std::uint32_t> restless_centres_;  // own atoms
  LaneCentreBatches steady_centre_batches_, restless_centre_batches_;
  LaneBondBatches steady_batches_, restless_batches_;
};

}  // namespace nanocarbon::rebo2
