// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::building {

//! \brief How much of its surface's Gaussian curvature a molecule has: about 1 where it has the form, 0 where it could be
//! rolled out flat.
//! \details A closed molecule has all of it by its topology; an open one may lose disclinations through its boundary and
//! unbend. Gaussian curvature is the angles that the triangles around inner vertices lack of full turns; that of the surface
//! is counted at the molecule's nearest vertices. Domes and saddles, where the surface's, smoothed over 5 Angstrom, is
//! above and below zero, count both: it is the sum over the molecule of what it has there of the right sign, over that of
//! the surface.
//! \param triangulation of the molecule: its vertices are the centres of rings
//! \param surface Angstrom, where it fits the molecule
//! \return nothing where the surface has less than a pentagon's, pi/3, in all
std::optional<double> gaussian_curvature_kept(const TriangleMesh& triangulation, const TriangleMesh& surface);

}  // namespace nanocarbon::building
