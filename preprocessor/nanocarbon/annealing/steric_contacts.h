// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "nanocarbon/annealing/fixed_bond_rebo2.h"
#include "nanocarbon/core/approach_watch.h"
#include "nanocarbon/core/kept_pairs.h"

namespace nanocarbon::annealing {

//! By this much farther apart pairs are listed, Angstrom.
inline constexpr double steric_margin = 0.8;

//! Bonds apart up to which two atoms never repel: the angles and rings of the network hold those apart.
inline constexpr unsigned steric_excluded_bonds = 3;

//! Harmonic repulsion of one pair: (k / 2)(reach - r)^2 below the reach in Angstrom, k = 8 eV/Angstrom^2. Adds the
//! gradient at `a` to it and returns the energy in eV; the gradient at b is its opposite.
double steric_pair(const Vec3& a, const Vec3& b, double reach, Vec3& gradient_at_a);

//! \brief Keeps atoms apart that are not bonded: sheets that nearly touch, thin parts, folds.
//! \details The fixed-bond energy does not know unbonded atoms. Pairs are taken from a cell list with a
//! margin and renewed once two atoms near each other may have come closer by it: parts that move as a whole
//! do not count. In large molecules they are renewed where that is so, and not elsewhere.
class StericContacts {
 public:
  using Neighbours = std::vector<std::array<AtomIndex, 3>>;

  //! Lists the pairs of atoms more than steric_excluded_bonds apart that are within the graph's reach and the
  //! margin.
  void renew(std::span<const Vec3> positions, const FixedBondGraph& graph, ThreadTeam* team = nullptr);

  //! Energy in eV, gradient added to; renews the pairs first where atoms have moved too far.
  double evaluate(std::span<const Vec3> positions, const FixedBondGraph& graph, std::span<Vec3> gradient,
                  ThreadTeam* team = nullptr);

  //! Atoms listed as near the given one, in both directions.
  std::span<const AtomIndex> near(AtomIndex atom) const {
    if (atom + 1 >= offsets_.size()) return {};
    return {near_.data() + offsets_[atom], near_.data() + offsets_[atom + 1]};
  }

 private:
  void start(double reach);
  void renew_where_nearer(std::span<const Vec3> positions, const FixedBondGraph& graph, ThreadTeam* team);

  std::vector<std::size_t> offsets_;
  std::vector<AtomIndex> near_;
  double reach_ = 0;  // what these are of, Angstrom
  ApproachWatch watch_{default_steric_reach, steric_margin};
  // In place of the watch, of large molecules in free space.
  KeptPairs pairs_{default_steric_reach, steric_margin};
};

}  // namespace nanocarbon::annealing
