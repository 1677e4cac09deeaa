// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "nanocarbon/potential/near_pairs.h"
#include "nanocarbon/potential/rebo2/energy_parts.h"
#include "nanocarbon/potential/rebo2/kernels/lane_kernel.h"
#include "nanocarbon/potential/rebo2/parameters.h"

namespace nanocarbon::rebo2 {

//! \brief The bond-order energy of any carbon and hydrogen, by the lane loops: what evaluate_general() gives,
//! up to rounding.
//! \details Each step finds the bonds anew and sorts atoms by their numbers of bonds to carbon and to
//! hydrogen. Of bonds as a whole only those are evaluated whose F or T can be other than zero, and that have
//! dihedrals by their numbers of arms. Derivatives by coordination numbers are gathered by atom, so that
//! conjugation costs no sum over the neighbours' neighbours of each bond.
class LaneEvaluation {
 public:
  LaneEvaluation(const Rebo2Parameters& parameters, const LaneLoops& loops,
                 const std::optional<TorsionBarriers>& torsion);

  //! To be called whenever the atoms, their elements or the near pairs have changed.
  void near_changed(const potential::AtomsView& atoms, const potential::NearPairs& near);

  //! \brief Arguments and result as of evaluate_general().
  //! \param atom_energies of all atoms, added to, or nullptr
  //! \return nothing where an atom has more than lane_most_bonds bonds: then nothing was added
  std::optional<EnergyParts> evaluate(const potential::AtomsView& atoms, double* forces,
                                      double* atom_energies);

  //! Bytes held by the arrays that grow with the atoms.
  std::size_t memory() const;

 private:
  //! An atom whose bonds are known, and the derivatives by its coordination and by its conjugation sum.
  struct Node {
    std::uint32_t atom;
    std::uint32_t first;               // half-edge
    std::uint32_t carbons, hydrogens;  // how many bonds
    double conjugation_sum = 0.0;
    double by_coordination = 0.0;
    double by_conjugation_sum = 0.0;
    std::uint32_t end() const { return first + carbons + hydrogens; }
  };
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
  //! Bonds that are alike, in the layout of LaneBonds.
  struct BondBatch {
    LaneBonds bonds = {};
    std::vector<std::uint32_t> edges, arms, reverses;
    std::vector<double> numbers;
  };
  struct CentreBatch {
    LaneCentres centres = {};
    std::vector<std::uint32_t> first;
  };

  bool add_node(std::uint32_t atom);
  void measure_from(std::uint32_t node, std::uint32_t edge);
  bool find_bonds(const potential::AtomsView& atoms);
  void run_centres(std::uint32_t own, LaneEnergy& energy);
  bool select_bonds(std::uint32_t own);
  void find_conjugation(Node& node);
  void differentiate(const Node& node);
  void add_bond(std::uint32_t edge, const Node& i, const Node& j, bool dihedrals, double share);
  void run_bonds(LaneEnergy& energy);
  void gather_derivatives(const BondBatch& batch);
  void add_derivatives_by_weight();
  Node& node_of(std::uint32_t atom) { return nodes_[place_[atom]]; }
  LaneEdges edges();
  std::uint32_t reverse(const Node& of, std::uint32_t to) const;

  LaneConstants constants_;
  const LaneLoops& loops_;
  std::array<double, 3> squared_cutoffs_;
  double conjugation_begin_, conjugation_end_;
  //! By pair_index() and where N_ij and N_ji are: at a knot (even) or between two (odd).
  std::array<std::array<std::array<bool, 9>, 9>, 3> has_terms_;
  std::array<std::array<bool, 9>, 9> has_dihedrals_;

  potential::NearPairs near_;                  // each row has carbons first
  std::vector<std::uint32_t> near_hydrogens_;  // [atom] where its row's hydrogens begin
  const Element* elements_ = nullptr;

  std::vector<double> positions_, forces_;  // [atom][4]
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> place_;  // of an atom in nodes_
  std::size_t edge_count_ = 0;
  std::vector<std::uint32_t> from_, to_, pair_;
  std::vector<double> geometry_, weights_, gradient_, energies_;
  std::vector<double> coordination_;           // [atom] of nodes
  std::vector<std::int8_t> whole_place_;       // [atom] table_place() without a whole bond, or -1
  std::vector<Conjugation> conjugation_;       // [edge] of nodes that have it
  std::vector<char> is_conjugated_;            // [node]
  std::vector<std::uint32_t> differentiated_;  // nodes with derivatives by their coordination or sum
  std::vector<char> is_differentiated_;        // [node]
  std::vector<Selected> selected_;
  std::vector<CentreBatch> centre_batches_;
  std::vector<std::uint32_t> used_centres_;
  std::vector<BondBatch> bond_batches_;
  std::vector<std::uint32_t> used_bonds_;
};

}  // namespace nanocarbon::rebo2
