// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <span>
#include <vector>

#include "nanocarbon/mesh/polygon_soup.h"

namespace nanocarbon::mesh {

//! \brief Cuts a polygon into triangles by cutting ears off its projection along its Newell normal.
//! \details Best shaped ear first (Eberly, Triangulation by Ear Clipping, for what is an ear); O(n (r + log
//! n)) for n corners of which r are not convex. A polygon that crosses itself in projection still gives n -
//! 2 triangles.
//! \param corners three or more
//! \param triangles are appended, wound as the polygon is
void cut_ears(std::span<const Vec3> points, std::span<const VertexIndex> corners,
              std::vector<Triangle>& triangles);

}  // namespace nanocarbon::mesh
