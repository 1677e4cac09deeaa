// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "nanocarbon/topology/rotation_system.h"

namespace nanocarbon::topology {

//! The faces of a rotation system in compressed rows of half-edges.
struct Faces {
  std::vector<std::uint32_t> offsets = {0};  //!< size faces + 1
  std::vector<AtomIndex> atoms;  //!< along the face; an atom stands here as often as the face passes it
  std::vector<std::uint32_t> half_edges;  //!< along the face: the one that leads on from each atom
  std::vector<double> turning;  //!< of each face: sum of its turns to the left, radians: 2 pi around a flat
                                //!< ring, 0 around a straight tube's end, -2 pi around a flat flake
  std::size_t size() const { return offsets.size() - 1; }
};

//! \brief Traces the faces: along a half-edge, then always the next one on the left.
//! \details Over a twisted bond left and right swap. Each bond is passed twice in all, each face is found
//! once, also where the surface has only one side. Faces of an oriented component lie to the left seen
//! against its normals (turned where `flipped`). Rows start at the lowest atom.
//! \pre rotation.skeleton.problem is empty
Faces trace_faces(const EmbeddedGraph& graph, const RotationSystem& rotation);

}  // namespace nanocarbon::topology
