// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/core/space.h"
#include "nanocarbon/minimisation/multilevel/node_graph.h"
#include "nanocarbon/minimisation/multilevel/symmetric_block.h"

namespace nanocarbon::multilevel {

//! \brief Stiffness of the springs that stand for a sheet of carbon, eV/Angstrom^2.
//! \details REBO2's Hessian of graphene is fitted best by 39, 4 and 10; stiffer springs within the sheet cost
//! few iterations, and are safer far from the minimum, where bonds are long or short.
struct SheetStiffness {
  double bond = 60;
  double second_neighbour = 6;
  double height = 10.4;  //!< of an atom above the mean of its three neighbours: bending
};

//! What holds each atom to a plane: the normal times the square root of the stiffness, (eV/Angstrom^2)^(1/2).
using Holds = std::vector<Vec3>;

//! \brief The Hessian of relaxed springs in a sheet at some positions: positive semidefinite for any.
//! \details Rigid motions cost next to nothing, bending and stretching about what they cost in carbon. Atoms that
//! are part of no sheet are held to their neighbours softly in all directions. Where there are several
//! components, which no spring ties to each other, all atoms are held to their places, as softly as sheets that face
//! each other are held apart.
class SheetSprings {
 public:
  SheetSprings() = default;
  SheetSprings(NodeGraph bonds, const SheetStiffness& stiffness);

  const NodeGraph& bonds() const { return bonds_; }
  //! Atoms coupled with each atom: itself, its neighbours and theirs; sorted.
  const NodeGraph& pattern() const { return pattern_; }

  //! \param holds one for each atom, or empty
  void set(const Space& space, std::span<const Vec3> positions, const Holds& holds);
  //! The blocks of a row, in the pattern's order.
  void row(std::size_t atom, std::vector<Block>& blocks) const;

 private:
  NodeGraph bonds_, pattern_;
  SheetStiffness stiffness_;
  Space space_;
  std::vector<Vec3> positions_, normals_;  // normals of atoms with three neighbours, zero for others
  std::vector<bool> loose_;                // nothing bends about these
  Holds holds_;
  double anchor_ = 0;  // eV/Angstrom^2, of each atom to its place
};

}  // namespace nanocarbon::multilevel
