// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <span>
#include <vector>

#include "nanocarbon/annealing/boundary_curve.h"
#include "nanocarbon/core/thread_team.h"
#include "nanocarbon/mesh/nearest_point.h"
#include "nanocarbon/mesh/triangle_tree.h"

namespace nanocarbon::annealing {

//! \brief The surface as the molecule sees it: scaled to Angstrom, with tangent planes.
//! \details Distances to the plane are free along the surface, so a tether to it holds the shape but lets
//! atoms slide.
class TetherSurface {
 public:
  //! \param surface any units; kept by copy
  //! \param scale Angstrom per unit of the surface
  TetherSurface(const TriangleMesh& surface, double scale);

  //! The plane through the nearest point of the surface, with the normal interpolated between vertices.
  TangentPlane plane_at(const Vec3& position) const;
  //! The same on the part of the surface that faces the given way, wherever there is one: the other side of a
  //! thin part may be nearer.
  TangentPlane plane_at(const Vec3& position, const Vec3& facing) const;

  const TriangleMesh& mesh() const { return scaled_; }  //!< Angstrom
  const Space& space() const { return scaled_.space; }
  const BoundaryCurve& boundary() const { return boundary_; }
  double distance(const Vec3& position) const;  //!< to the surface, Angstrom
  Vec3 nearest(const Vec3& position) const;     //!< point of the surface, Angstrom

 private:
  TangentPlane plane_at(const Vec3& foot, std::uint32_t triangle) const;

  TriangleMesh scaled_;
  mesh::NearestPoint nearest_;
  mesh::TriangleTree tree_;
  std::vector<Vec3> vertex_normals_;
  BoundaryCurve boundary_;
};

//! Planes for all positions.
//! \param former the planes of the same positions a little earlier, whose side of the surface is kept; empty
//! for none
std::vector<TangentPlane> tangent_planes(const TetherSurface& surface, std::span<const Vec3> positions,
                                         std::span<const TangentPlane> former = {},
                                         ThreadTeam* team = nullptr);

//! Mean height of all atoms above their planes, Angstrom.
double mean_height(std::span<const TangentPlane> planes, std::span<const Vec3> positions,
                   ThreadTeam* team = nullptr);

//! \brief Adds (stiffness / 2)(h - mean h)^2 over all atoms, h the height above the atom's plane.
//! \details The mean is free where the surface's size may follow the number of atoms: curved sheets of carbon
//! rest at a slightly different size than flat ones, and holding them to the surface itself would favour more
//! or fewer atoms.
//! \param free_mean otherwise the mean is zero: the surface's size is prescribed
//! \param stiffness eV/Angstrom^2
//! \return eV
double add_tether(std::span<const TangentPlane> planes, double stiffness, std::span<const Vec3> positions,
                  std::span<Vec3> gradient, bool free_mean = true, ThreadTeam* team = nullptr);

}  // namespace nanocarbon::annealing
