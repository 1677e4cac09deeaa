// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::shapes {

//! A closed curve as points, counter-clockwise seen from where the loft goes; a single point is a pole.
using Loop = std::vector<Vec3>;

//! \brief The surface through a row of loops, which may have different numbers of points.
//! \details Between two loops triangles are laid so that both are run through at the same rate; the first
//! points of all loops should lie above each other. Wound so that normals point away from the axis.
//! \param loops at least two; the first and the last may be poles, otherwise they are boundaries
//! \param closed joins the last loop to the first, which must not be poles
TriangleMesh loft(const std::vector<Loop>& loops, bool closed = false);

//! A circle of about equal steps of at most `edge` (at least `fewest` of them) around `centre`, in the plane
//! of x and y.
//! \param turn by which its first point is turned from x, in steps; half a step between neighbouring loops
//! gives good triangles
Loop circle(const Vec3& centre, const Vec3& x, const Vec3& y, double radius, double edge, double turn,
            int fewest = 5);

}  // namespace nanocarbon::shapes
