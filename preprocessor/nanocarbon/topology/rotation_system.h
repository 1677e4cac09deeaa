// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "nanocarbon/topology/skeleton.h"

namespace nanocarbon::topology {

//! \brief A signed rotation system: which half-edge follows which around each atom, and over which bonds
//! sides swap.
//! \details Of the skeleton: carbon without hydrogen and without trees that hang on by one bond. There, atoms
//! have three or two bonds, or none (what is left of a component without cycles). The cyclic order of three
//! bonds is unique up to its sense, so geometry decides only whether the senses of two bonded atoms agree.
struct RotationSystem {
  Skeleton skeleton;                //!< nothing below counts where it has a problem
  std::vector<std::uint32_t> next;  //!< half-edge counter-clockwise around its atom, seen against the normal
  std::vector<std::uint32_t> previous;  //!< clockwise; both are none outside the skeleton
  std::vector<std::uint8_t>
      twisted;                //!< of each half-edge: the normals of its two atoms are on opposite sides
  std::vector<Vec3> normals;  //!< of each atom, unit vectors; zero outside the skeleton and in bare cycles
  std::vector<std::uint8_t>
      flipped;  //!< of each atom: its normal must be turned to agree with its component and point outwards
  std::vector<std::uint8_t> one_sided;   //!< of each component: no choice of normals agrees on all its bonds
  std::vector<std::uint8_t> bare_cycle;  //!< of each component: its skeleton is a cycle and nothing else
};

//! \brief The rotation system of an embedded bond graph.
//! \details The normal of an atom with three bonds is that of the triangle of their unit vectors. Atoms with
//! two bonds have theirs carried along from the nearest atoms with three, so that a flapping edge atom says
//! nothing wrong. Components that are a bare cycle have no sides to tell; all their bonds count as untwisted.
//! `twisted`, `flipped` and `one_sided` are left to orient() (orientation.h).
RotationSystem rotation_system(const EmbeddedGraph& graph);

}  // namespace nanocarbon::topology
