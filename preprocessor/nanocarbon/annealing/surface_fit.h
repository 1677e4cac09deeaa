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

}  // namespace nanocarbon::annealing
