// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>

#include "nanocarbon/core/vec3.h"

namespace nanocarbon::shapes {

//! A shape as a function: below zero inside, zero on its surface, above zero outside; about a distance near
//! the surface.
using ImplicitShape = std::function<double(const Vec3&)>;

//! The same, which sets its gradient as well.
using ImplicitSlope = std::function<double(const Vec3& point, Vec3& gradient)>;

//! Distance to a segment's axis less the radius: a capsule.
double capsule_distance(const Vec3& point, const Vec3& from, const Vec3& to, double radius);

//! Distance to a torus around the axis through `centre` along z.
double torus_distance(const Vec3& point, const Vec3& centre, double major, double minor);

//! \brief The union of two shapes with their crease rounded off.
//! \details Polynomial smooth minimum: differs from the lesser one only where they are closer than `blend`.
double smooth_union(double a, double b, double blend);

//! Gradient by central differences over 2 * step.
Vec3 gradient(const ImplicitShape& shape, const Vec3& point, double step);

}  // namespace nanocarbon::shapes
