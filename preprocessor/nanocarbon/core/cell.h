// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>

#include "nanocarbon/core/vec3.h"

namespace nanocarbon {

//! A simulation cell: three edge vectors, any of them periodic. Right-handed and not degenerate.
struct Cell {
  Mat3 vectors = Mat3::Identity();  //!< columns are the edges a, b, c, Angstrom
  Vec3 origin = Vec3::Zero();       //!< the corner at fractional coordinates (0, 0, 0), Angstrom
  std::array<bool, 3> periodic = {true, true, true};
};

//! An orthogonal cell with edges of the given lengths (Angstrom) along x, y and z and its corner at the
//! origin.
Cell orthogonal_cell(const Vec3& lengths, std::array<bool, 3> periodic = {true, true, true});

//! Distances between opposite faces of the cell, Angstrom.
Vec3 face_distances(const Cell& cell);

//! Volume in cubic Angstrom.
double volume(const Cell& cell);

//! Displacement of the periodic image (i, j, k) from the cell itself: i a + j b + k c, Angstrom.
Vec3 image_shift(const Cell& cell, const std::array<int, 3>& image);

}  // namespace nanocarbon
