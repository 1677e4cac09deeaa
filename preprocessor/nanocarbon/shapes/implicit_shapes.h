// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::shapes {

// Shapes made from implicit surfaces. All lengths in mesh units; UserError (usage) as in shapes.h.

//! Two tori side by side in one plane, grown together: a closed surface of genus 2.
//! \param major radius of each torus's middle circle
//! \param minor radius of the tube
TriangleMesh make_genus_two(double major, double minor, double edge);

//! Where tubes meet.
struct JunctionShape {
  enum class Kind { y, t, x } kind = Kind::y;  //!< three arms at 120 degrees, three as a T, four as a cross
  double tube_radius = 1.0;
  double arm_length = 4.0;  //!< from the middle of the junction to the end of each arm
  double blend = 1.0;       //!< over which the crease between arms is rounded off
  bool open = true;         //!< boundaries at the ends of the arms; otherwise hemispheres
  double edge = 0.3;
};
TriangleMesh make_junction(const JunctionShape& shape);

//! A component of a triply periodic minimal surface, cut out by a cube; or the closed shell around it.
struct MinimalSurfacePiece {
  enum class Kind { gyroid, schwarz_p, schwarz_d } kind = Kind::gyroid;
  double period = 1.0;     //!< of the surface
  double cells = 1.0;      //!< edge of the cube, in periods
  double thickness = 0.0;  //!< of the shell around the surface; 0: the surface itself, with boundaries
  double edge = 0.05;
};
TriangleMesh make_minimal_surface_piece(const MinimalSurfacePiece& component);

}  // namespace nanocarbon::shapes
