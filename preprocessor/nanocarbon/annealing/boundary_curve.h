// SPDX-License-Identifier: GPL-2.0-or-later
// The boundary of a surface as the molecule's boundary sees it, and what holds the latter to it.
#pragma once

#include <span>
#include <vector>

#include "nanocarbon/annealing/fixed_bond_graph.h"
#include "nanocarbon/mesh/nearest_point.h"

namespace nanocarbon::annealing {

//! A plane that an atom is held to; in a cell the image beside the atom.
struct TangentPlane {
  Vec3 point;   //!< Angstrom
  Vec3 normal;  //!< unit, outward; zero for none
};

//! Height of a position above a plane, Angstrom.
inline double height_above(const TangentPlane& plane, const Vec3& position) {
  return (position - plane.point).dot(plane.normal);
}

//! \brief The boundary loops of a surface, smoothed over three Angstrom, with the directions that lead away from the
//! surface.
class BoundaryCurve {
 public:
  //! \param surface Angstrom
  //! \param normals of its vertices, outward
  BoundaryCurve(const TriangleMesh& surface, std::span<const Vec3> normals);

  bool empty() const { return outward_.empty(); }
  //! The plane across the surface at the nearest point of the boundary, whose normal leads away from it.
  //! \pre not empty
  TangentPlane plane_at(const Vec3& position) const;

 private:
  std::vector<Vec3> outward_;                // of each piece
  std::vector<mesh::NearestPoint> nearest_;  // one, or none
};

//! Open atoms are held to the boundary by this, eV/Angstrom^2: a row of hexagons too many or too few, of 2.13
//! Angstrom, costs about as much as an open atom does.
inline constexpr double boundary_tether = 0.1;

//! How far the open atoms of a triangulation's dual lie inside its boundary, Angstrom: a third of a triangle's height.
inline constexpr double open_atom_depth = 0.71;

//! Planes across the surface for atoms within a few bonds of an open one, which may come to be open; normals of
//! others are zero.
std::vector<TangentPlane> boundary_planes(const BoundaryCurve& boundary, const FixedBondGraph& graph,
                                          std::span<const Vec3> positions);

//! Mean height of open atoms above their planes, Angstrom; minus open_atom_depth where there are none.
double mean_reach(std::span<const TangentPlane> planes, const FixedBondGraph& graph,
                  std::span<const Vec3> positions);

//! \brief Adds (boundary_tether / 2)(h - reach)^2 over all open inner atoms, h the height above the atom's plane.
//! \return eV; the gradient (eV/Angstrom) is added to
double add_boundary_tether(std::span<const TangentPlane> planes, const FixedBondGraph& graph, double reach,
                           std::span<const Vec3> positions, std::span<Vec3> gradient);

}  // namespace nanocarbon::annealing
