// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <span>

#include "nanocarbon/annealing/atom_chunks.h"
#include "nanocarbon/potential/rebo2/kernels/sp2_kernel.h"

namespace nanocarbon::annealing {

//! \brief Fixed-bond REBO2 of atoms with three bonds by the vector loops of the native potential.
//! \details The loops know the pair terms as polynomials on a range of bond lengths, here wide enough for
//! bonds that are being made. Atoms with a bond or an angle outside it are left to others.
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
  const AtomChunks& chunks() const { return chunks_; }

  //! The first pass: bonds and angles at these positions.
  void measure(std::span<const Vec3> positions, ThreadTeam* team);
  //! Complete inner atoms that the first pass found outside the range; sorted.
  std::vector<AtomIndex> outside() const;
  //! Adds complete atoms of a chunk with a longer bond, or with two neighbours closer to each other, than this to
  //! the strained ones; some that just do not have them too. As of the first pass.
  void find_strained(double long_bond, double close_neighbours, std::size_t chunk,
                     std::vector<AtomIndex>& strained) const;

  //! The second pass: energy (eV) of the complete inner atoms, gradient (eV/Angstrom) added to.
  //! \param left_out sorted: of these atoms nothing is added, and of bonds to them no dihedral term
  double add(std::span<const AtomIndex> left_out, const FixedBondGraph& graph, std::span<Vec3> gradient,
             ThreadTeam* team);

 private:
  AtomChunks chunks_;
  std::vector<std::uint32_t> atoms_, neighbours_, reverses_, slots_, outside_;  // see Sp2Data
  std::vector<std::uint32_t> place_;                                            // of each atom
  std::vector<std::size_t> first_block_;                                        // of each chunk, and one more
  std::vector<rebo2::Sp2Modifiers> special_;   // of blocks with padding or bonds without a dihedral
  std::vector<std::size_t> special_of_block_;  // one more than the index; 0 for none
  std::vector<const rebo2::Sp2Modifiers*> modifiers_;
  std::vector<double> geometry_, tensors_, forces_;
  const Vec3* places_ = nullptr;  // of the first pass

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

  std::size_t blocks() const { return slots_.size(); }
  rebo2::Sp2Data data();
  void lay_out_atoms(const FixedBondGraph& graph);
  void lay_out_bonds(const FixedBondGraph& graph);
  void find_copies(std::span<const Vec3> positions);
  void set_modifiers(const FixedBondGraph& graph);
};

}  // namespace nanocarbon::annealing
