// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "nanocarbon/mesh/grids/field_request.h"
#include "nanocarbon/mesh/grids/scalar_field.h"
#include "nanocarbon/mesh/polygon_soup.h"

namespace nanocarbon::mesh {

//! \brief The surface where a field has the value that is asked for, with edges about as long as the grid's shortest
//! step.
//! \details Marching tetrahedra on the values themselves (shapes/polygonise_in_cell.h), then evened out along the field
//! between them, which is interpolated by cubic splines (Catmull and Rom). Where the field is periodic the surface
//! goes through the faces of its cell and is cut there; the cell is the result's.
//! \throw UserError (usage) naming the file where no level is given, or none of the field has it, with the values that
//! there are; where the field does not cover its cell in a direction that is to be periodic
PolygonSoup isosurface(const ScalarField& field, const FieldRequest& request, const std::string& file);

}  // namespace nanocarbon::mesh
