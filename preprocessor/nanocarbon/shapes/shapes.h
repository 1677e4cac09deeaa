// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::shapes {

// Smooth shapes as triangle meshes, 2-manifold and wound counter-clockwise seen from outside. All lengths are
// in mesh units; `edge` is about the length of the mesh's edges. Each throws UserError (usage) for lengths
// that make no shape (not above zero, a torus that meets itself, an edge too long to show the shape) or more
// than 20 million triangles.

//! A sphere: an icosahedron's faces cut into subdivisions^2 triangles each and blown up. Closed.
TriangleMesh make_sphere(double radius, int subdivisions);

//! Spheres about one centre, closed surfaces without contact: the meshes of an onion.
struct NestedSpheres {
  double radius = 1.0;  //!< of the innermost, mesh units
  double gap = 0.5;     //!< from each to the next, mesh units
  int count = 2;        //!< 1 to 100
  double edge = 0.2;    //!< mesh units
};
TriangleMesh make_nested_spheres(const NestedSpheres& shape);

//! The upper half of a sphere, its boundary in the plane z = 0.
TriangleMesh make_hemisphere(double radius, double edge);

//! A cylinder along z with hemispheres at both ends. Closed.
//! \param length of the cylinder, without the ends
TriangleMesh make_capsule(double radius, double length, double edge);

//! A cylinder along z with two boundaries.
TriangleMesh make_cylinder(double radius, double length, double edge);

//! A torus around z, closed.
//! \param major radius of the circle in its middle
//! \param minor radius of the tube
TriangleMesh make_torus(double major, double minor, double edge);

//! A tube along a helix around z.
struct HelixShape {
  double coil_radius = 1.0;  //!< of the helix, mesh units
  double tube_radius = 0.3;  //!< of the tube around it, mesh units
  double pitch = 1.0;        //!< rise in one turn, mesh units
  double turns = 3.0;
  bool open = false;  //!< two boundaries instead of round ends
  double edge = 0.1;  //!< mesh units
};
TriangleMesh make_helix(const HelixShape& shape);

}  // namespace nanocarbon::shapes
