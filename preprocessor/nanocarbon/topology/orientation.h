// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/topology/rotation_system.h"

namespace nanocarbon::topology {

//! \brief Decides which bonds are twisted and orients the components by them, outwards: `twisted`, `flipped`,
//! `one_sided`.
//! \details Two normals agree when their components perpendicular to the bond do: where it is twisted by less
//! than a right angle, which thermal motion and strong curvature leave alone. A union-find with parity joins
//! atoms over the least twisted bonds first. What is left are bonds that contradict it, and bonds within six
//! degrees of a right angle, which say nothing. Those that lie on a cycle of at most twelve bonds which
//! closes in space take the sign that the rest of the cycle implies: the neighbourhood of so short a cycle is
//! no Moebius band, so it is the bond that is bent out of shape. Contradictions on longer cycles make their
//! component one-sided; undecided bonds there are a problem, and not guessed.
//! \pre `normals`, `bare_cycle` and the skeleton are known
void orient(const EmbeddedGraph& graph, RotationSystem& rotation);

}  // namespace nanocarbon::topology
