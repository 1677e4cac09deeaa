#pragma once

#include <cstddef>

#include "nanocarbon/mesh/triangle_mesh.h"
#include "nanocarbon/remeshing/thesis_options.h"

namespace nanocarbon {

//! \brief Angstrom for each mesh unit, so that the surface holds the given number of equilateral triangles,
//! an atom each, whose edge is the middle of the interval. \details The count that a remeshing ends with
//! differs by a few percent: edges differ, and triangles cut corners. \throw UserError (unsuitable) where the
//! surface has no area
double scale_for_atoms(const TriangleMesh& surface, std::size_t atoms, const ThesisOptions& options);

//! The surface with every point times `scale`.
TriangleMesh scaled(TriangleMesh surface, double scale);

}  // namespace nanocarbon
