// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <span>

#include "nanocarbon/annealing/surface_tether.h"

namespace nanocarbon::annealing {

//! A motion x -> centre + scale * (turn * (x - centre)) + shift.
struct Similarity {
  Vec3 centre = Vec3::Zero();
  Vec3 shift = Vec3::Zero();
  Mat3 turn = Mat3::Identity();
  double scale = 1;

  Vec3 operator()(const Vec3& x) const { return centre + scale * (turn * (x - centre)) + shift; }
};

//! \brief The motion that brings atoms closest to a surface, in the sense of least squares of the heights
//! above the nearest tangent planes (Chen and Medioni 1992).
//! \details Motions that change no height (turns of a sphere) are left out. In a cell only shifts are motions.
//! \param with_scale let the atoms grow or shrink, too
//! \return a motion that leaves them no farther from the surface than they were, in the mean square
Similarity fit_to_surface(std::span<const Vec3> positions, const TetherSurface& surface, bool with_scale,
                          ThreadTeam* team = nullptr);

//! \brief Moves atoms back as a whole that have drifted while nothing held them, farther than a fit to a surface finds
//! back: to where the first of them lie closest to where they were (Umeyama 1991, without scale).
//! \details Only where they were farther than 1.5 times that and than 0.5 Angstrom, in the root mean square: what has hardly
//! drifted keeps its bits.
//! \param before of the first atoms, at least one; any that follow move with them
//! \param turn whether they may be turned, too; not in a cell
void bring_back(std::span<Vec3> positions, std::span<const Vec3> before, bool turn);

}  // namespace nanocarbon::annealing
