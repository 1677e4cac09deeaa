// SPDX-License-Identifier: GPL-2.0-or-later
// Triangulations without a defect: of tubes and sheets in a periodic cell, and of tori.
#pragma once

#include <cstddef>
#include <optional>

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::crystal {

//! \brief A triangulation all of whose vertices have valence 6, of a surface whose components are closed and of
//! genus one: what a tube or a sheet is in the cell that it goes on through.
//! \details Each component is mapped to a flat torus by harmonic one-forms (Gu and Yau 2003; one to one for
//! positive weights: Gortler, Gotsman and Thurston 2006). Of all triangular lattices on that torus, at any angle
//! and with about the number of faces, the one is taken that is strained the least, by graphene's elastic
//! constants, and carried back.
//! \param faces wanted in all; met within a few percent, as the lattice allows
//! \return vertices on the surface; nothing where a component is of another kind, or too narrow for a lattice
std::optional<TriangleMesh> hexagonal_triangulation(const TriangleMesh& surface, std::size_t faces);

}  // namespace nanocarbon::crystal
