// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nanocarbon/shapes/shapes.h"

namespace nanocarbon::test {

//! A round plate of the given radius and thickness, with a half-round rim.
inline TriangleMesh pill(double radius, double thickness) {
  TriangleMesh mesh = shapes::make_sphere(1, 24);
  const double rim = std::numbers::pi * thickness / 2, whole = 2 * radius + rim;
  for (Vec3& p : mesh.points) {
    const double along = std::acos(std::clamp(p.z(), -1.0, 1.0)) / std::numbers::pi * whole;
    const double turn = std::clamp((along - radius) / rim, 0.0, 1.0) * std::numbers::pi;
    const double flat = along < radius ? along : along > radius + rim ? whole - along : radius;
    const double out = flat + (flat == radius ? 0.5 * thickness * std::sin(turn) : 0);
    const double across = std::hypot(p.x(), p.y());
    const double share = across > 0 ? out / across : 0;
    p = Vec3(share * p.x(), share * p.y(), 0.5 * thickness * std::cos(turn));
  }
  return mesh;
}

}  // namespace nanocarbon::test
