#pragma once

#include <span>

#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon {

//! \brief The rings of an sp2 structure that lies on a known surface: the faces met by always turning left.
//! \details Neighbours of an atom are ordered around its normal. The sign of the normals is carried along
//! each walk, so that surfaces without two sides (a cell of a minimal surface whose translations exchange
//! them) work too. Linear. \param normals one for each atom; outward where the surface has an outside \param
//! largest longer walks, and walks that run clockwise seen from outside, are borders and not rings \return
//! each ring once; counter-clockwise seen from the side of its first atom's normal
Rings trace_rings(const Molecule& molecule, std::span<const Vec3> normals, std::size_t largest);

}  // namespace nanocarbon
