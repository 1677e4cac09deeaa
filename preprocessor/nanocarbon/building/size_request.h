// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <variant>

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::building {

//! \name How large a molecule is asked for. Exactly one of these.
//! @{
struct AtomPerTriangle {};  //!< one atom per triangle of the surface, as in the thesis
struct AtomCount {
  std::size_t atoms;
};
struct LongestSide {
  double length;  //!< of the bounding box, or the longest periodic edge of the cell, Angstrom
};
struct UnitScale {
  double scale;  //!< Angstrom per mesh unit
};
//! @}
using SizeRequest = std::variant<AtomPerTriangle, AtomCount, LongestSide, UnitScale>;

//! Whether the size is prescribed and the number of atoms follows from it, rather than the other way round.
bool keeps_size(const SizeRequest& request);

//! A surface in Angstrom, and about how many atoms it will carry.
struct SizedSurface {
  TriangleMesh mesh;   //!< Angstrom
  double scale = 1.0;  //!< Angstrom per mesh unit
  std::size_t atoms = 0;
};

//! The dodecahedron C20 is the smallest closed cage of pentagons and hexagons.
inline constexpr std::size_t smallest_cage = 20;

//! Area per atom of a flat sheet of hexagons with the given bond length: 3 sqrt(3) / 4 times its square.
double area_per_atom(double bond_length);

//! \brief Scales a surface to the size asked for.
//! \param surface mesh units
//! \param bond_length mean bond that the atoms will have, Angstrom
//! \throw UserError (unsuitable) for a surface without area; (size) if it would have fewer than 20 atoms (the message
//! gives a size that works), or more than fit into this machine's memory
SizedSurface sized_surface(const TriangleMesh& surface, const SizeRequest& request, double bond_length);

//! \brief The same for surfaces with specks, components too small for the smallest cage: they are refused or, if asked for,
//! dropped before the rest is sized.
//! \param surface mesh units
//! \param dropped how many were left out
//! \throw UserError as sized_surface(); (size) with the number of specks
SizedSurface sized_without_specks(const TriangleMesh& surface, const SizeRequest& request, double bond_length,
                                  bool drop, std::size_t& dropped);

}  // namespace nanocarbon::building
