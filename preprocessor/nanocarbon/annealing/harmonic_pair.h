// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <algorithm>

#include "nanocarbon/core/vec3.h"

namespace nanocarbon::annealing {

//! \brief Energy of a harmonic spring between two points, k/2 (r - rest)^2, in eV.
//! \param a,b,rest Angstrom; points on each other pull nowhere
//! \param stiffness k, eV/Angstrom^2
//! \param at_a,at_b gradients at the points, eV/Angstrom, that the spring's are added to
inline double add_harmonic_pair(const Vec3& a, const Vec3& b, double rest, double stiffness, Vec3& at_a,
                                Vec3& at_b) {
  const Vec3 d = b - a;
  const double r = std::max(d.norm(), 1e-9), stretch = r - rest;
  const Vec3 force = stiffness * stretch / r * d;
  at_a -= force;
  at_b += force;
  return 0.5 * stiffness * stretch * stretch;
}

}  // namespace nanocarbon::annealing
