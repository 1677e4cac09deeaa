// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <span>

#include "nanocarbon/annealing/fixed_bond_graph.h"
#include "nanocarbon/potential/rebo2/kernels/sp2_kernel.h"

namespace nanocarbon::annealing {

//! \brief Fixed-bond REBO2 of atoms with three bonds by the vector loops of the native potential.
//! \details The loops know the pair terms as polynomials on a range of bond lengths, here wide enough for
//! bonds that are being made. They do not evaluate what has an atom outside it.
class FixedBondLoops {
 public:
  FixedBondLoops() = default;
  // A copy's modifiers would point into the original's.
  FixedBondLoops(const FixedBondLoops&) = delete;
  FixedBondLoops& operator=(const FixedBondLoops&) = delete;
  FixedBondLoops(FixedBondLoops&&) = default;
  FixedBondLoops& operator=(FixedBondLoops&&) = default;

  //! Lays the bonds out for the loops.
  //! \param graph is not kept
  void set_graph(const FixedBondGraph& graph);

  //! Energy (eV) of the complete inner atoms, gradient (eV/Angstrom) added to; nothing, and nothing added,
  //! where a bond or an angle is outside the loops' range.
  std::optional<double> evaluate(std::span<const Vec3> positions, std::span<Vec3> gradient);

 private:
  std::vector<std::uint32_t> atoms_, neighbours_, reverses_, slots_, outside_;  // see Sp2Data
  std::vector<std::uint32_t> place_;                                            // of each atom, scratch
  std::vector<rebo2::Sp2Modifiers> special_;   // of blocks with padding or bonds without a dihedral
  std::vector<std::size_t> special_of_block_;  // one more than the index; 0 for none
  std::vector<const rebo2::Sp2Modifiers*> modifiers_;
  std::vector<double> geometry_, tensors_, forces_;
  std::size_t blocks_ = 0;

  // In a cell, bonds that lead to another image lead to a copy of the atom there: the loops know no cell. Which
  // do is found at the first positions and kept, so that it cannot change while atoms move.
  struct Copy {
    AtomIndex of;
    Vec3 shift;
  };
  Space space_;
  bool copies_known_ = false;
  std::vector<Copy> copies_;
  std::vector<Vec3> with_copies_;  // positions

  void lay_out_bonds(const FixedBondGraph& graph);
  void find_copies(std::span<const Vec3> positions);
  void set_modifiers(const FixedBondGraph& graph, std::size_t fast);
};

}  // namespace nanocarbon::annealing
