// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "nanocarbon/potential/near_pairs.h"
#include "nanocarbon/potential/rebo2/kernels/lane_kernel.h"
#include "nanocarbon/potential/rebo2/parameters.h"

namespace nanocarbon::rebo2 {

//! An atom whose bonds are known, and the derivatives by its coordination and by its conjugation sum.
struct LaneNode {
  std::uint32_t atom;
  std::uint32_t first;               //!< half-edge
  std::uint32_t carbons, hydrogens;  //!< how many half-edges
  //! How many of these are bonds; those without weight that come last are not.
  std::uint32_t bonded_carbons = 0, bonded_hydrogens = 0;
  double conjugation_sum = 0.0;
  double by_coordination = 0.0;
  double by_conjugation_sum = 0.0;
  std::uint32_t end() const { return first + carbons + hydrogens; }
};

//! Even at a whole number, odd between two; the tables over coordination numbers end at 4.
inline int table_place(double n) {
  if (n >= 4.0) return 8;
  if (!(n > 0.0)) return 0;
  const int below = static_cast<int>(n);
  return 2 * below + (n != below);
}

//! \brief The bonds of atoms, as half-edges for the lane loops: of own atoms, of atoms bonded to them, and of others
//! as they are asked for.
//! \details Once found, bonds are remembered: half-edges a little longer than bonds are kept, too, with a weight of
//! zero, and stay good until two other atoms come within a bond's reach. A node whose bonds are all whole and not
//! near their switch is steady. The rest are restless: their coordination may change at each step.
class LaneNodes {
 public:
  //! The references must stay.
  LaneNodes(const Rebo2Parameters& parameters, const LaneConstants& constants, const LaneLoops& loops);

  //! To be called whenever the atoms, their elements or the near pairs have changed.
  void near_changed(const potential::AtomsView& atoms, const potential::NearPairs& near);

  //! To be called first at each step.
  void take_positions(const potential::AtomsView& atoms);
  //! \brief Whether the half-edges are good still, and steady nodes' bonds whole. If so they are measured.
  bool same_as_remembered();
  //! \brief The nodes of own atoms (node i is atom i) and of those bonded to them; all are measured.
  //! \param beyond whether to find half-edges beyond bonds, too, so that they may be remembered
  //! \return false where an atom has more than lane_most_bonds bonds
  bool find(std::uint32_t own, bool beyond);
  //! How many of the own atoms are restless.
  std::size_t restless(std::uint32_t own) const;
  //! A node that is not measured yet, unless it is there. Result as of find().
  bool add(std::uint32_t atom);
  //! Nodes from this one on, whose half-edges begin with this one. Finds which of them are steady.
  void measure_from(std::uint32_t node, std::uint32_t edge);
  //! To be called when no more nodes are added.
  void remember();

  std::vector<LaneNode>& nodes() { return nodes_; }
  LaneNode& of(std::uint32_t atom) { return nodes_[place_[atom]]; }
  std::uint32_t place(std::uint32_t atom) const { return place_[atom]; }
  std::size_t edge_count() const { return edge_count_; }
  std::uint32_t from(std::uint32_t edge) const { return from_[edge]; }
  std::uint32_t to(std::uint32_t edge) const { return to_[edge]; }
  std::uint32_t pair(std::uint32_t edge) const { return pair_[edge]; }
  double weight(std::uint32_t edge) const { return weights_[4 * std::size_t{edge}]; }
  double weight_slope(std::uint32_t edge) const { return weights_[4 * std::size_t{edge} + 1]; }
  double coordination(std::uint32_t atom) const { return coordination_[atom]; }
  //! table_place() of an atom's coordination without a bond, where all of its bonds are whole; else -1.
  int whole_place(std::uint32_t atom) const { return whole_place_[atom]; }
  //! Whether it is a half-edge beyond a bond's reach.
  bool is_beyond(std::uint32_t edge) const { return weight(edge) == 0.0 && weight_slope(edge) == 0.0; }
  bool is_hydrogen(std::uint32_t atom) const { return elements_[atom] == Element::hydrogen; }
  bool is_steady(std::uint32_t atom) const { return is_steady_[place_[atom]]; }
  //! The half-edge of a node to an atom that it is bonded to.
  std::uint32_t edge_to(const LaneNode& node, std::uint32_t atom) const {
    std::uint32_t e = node.first;
    while (to_[e] != atom) ++e;
    return e;
  }
  //! dE/d direction and dE/d length of half-edges, in fours.
  std::vector<double>& gradient() { return gradient_; }
  //! For the loops. \param energies of half-edges, or nullptr
  LaneEdges edges(double* energies);

  //! Bytes held.
  std::size_t memory() const;

 private:
  bool find_within(std::uint32_t own, const std::array<double, 3>& beyond);
  void sum_weights(LaneNode& node);

  //! Near each other without a half-edge.
  struct Apart {
    std::uint32_t first, second, pair;
  };

  const LaneConstants& constants_;
  const LaneLoops& loops_;
  std::array<double, 3> cutoffs_, squared_reach_, longest_steady_;

  potential::NearPairs near_;                  // each row has carbons first
  std::vector<std::uint32_t> near_hydrogens_;  // [atom] where its row's hydrogens begin
  const Element* elements_ = nullptr;

  std::vector<double> positions_;  // [atom][4]
  std::vector<LaneNode> nodes_;
  std::vector<std::uint32_t> place_;  // of an atom in nodes_
  std::size_t edge_count_ = 0;
  std::vector<std::uint32_t> from_, to_, pair_;
  std::vector<double> geometry_, weights_, gradient_;
  std::vector<double> coordination_;      // [atom] of nodes
  std::vector<std::int8_t> whole_place_;  // [atom]
  std::vector<char> is_steady_;           // [node]
  bool remembered_ = false;
  std::vector<std::array<std::uint32_t, 2>> steady_edges_;  // ranges
  std::vector<std::uint32_t> restless_;                     // nodes
  std::vector<Apart> apart_;
};

}  // namespace nanocarbon::rebo2
