// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>

#include "nanocarbon/core/cell.h"
#include "nanocarbon/mesh/triangle_mesh.h"
#include "nanocarbon/shapes/implicit_surface.h"

namespace nanocarbon::shapes {

//! \brief A shape written as a formula of x, y and z, such as cos(x)+cos(y)+cos(z).
//! \details As muParser reads it: + - * / ^, comparisons, ?:, sin cos tan asin acos atan atan2 sinh cosh tanh exp ln
//! log10 log2 sqrt cbrt abs rint sign min max, and pi. Not to be called by several threads at once.
//! \throw UserError (usage) for a formula that cannot be read, saying what and where; also from the shape, where
//! the formula has no finite value
ImplicitShape shape_of_formula(const std::string& formula);

//! The surface where a formula has a given value.
struct FormulaSurface {
  std::string formula;
  Cell cell;               //!< around the origin; in directions that are not periodic a box
  double level = 0.0;      //!< value of the formula on the surface
  double thickness = 0.0;  //!< mesh units: the closed shell around the surface; 0: the surface itself
  //! About the edges of the triangles; a 25th of the cell's shortest edge, or what the surface needs.
  std::optional<double> edge = {};
};
//! \brief As a mesh in its cell; where no direction is periodic, in free space, closed off at the box.
//! \throw UserError (usage) for what cannot be made: a formula that does not repeat itself in the cell (saying
//! where), or has one sign everywhere; periodic in all directions, edges with which parts of the surface run into
//! each other
TriangleMesh make_formula_surface(const FormulaSurface& surface);

}  // namespace nanocarbon::shapes
