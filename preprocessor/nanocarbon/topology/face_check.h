// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "nanocarbon/topology/face_tracing.h"
#include "nanocarbon/topology/not_a_surface.h"

namespace nanocarbon::topology {

//! \brief Whether faces can be those of a surface; where not, atoms are too far out of place for their sides
//! to be told.
//! \details The sense in which three bonds go round an atom is read off their directions. Where noise has
//! turned it over, the atom's three faces run into one, which comes back on the other side of its bonds, and
//! the genus is one too high. So a bond is suspect that a face goes along both ways at the same place in
//! space (images are other places), unless nothing else holds its two parts together. Both times the same way
//! is a Moebius band. A chain of atoms from one hole to another, as in molten carbon, is such a case too: it
//! has no sides. Suspect as well is a short face that could be a ring or a boundary, turning by about half a turn.
//! Linear.
std::optional<NotASurface> find_doubtful_face(const EmbeddedGraph& graph, const RotationSystem& rotation,
                                              const Faces& faces, int max_ring);

}  // namespace nanocarbon::topology
