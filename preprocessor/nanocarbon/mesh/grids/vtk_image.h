// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "nanocarbon/mesh/grids/scalar_field.h"

namespace nanocarbon::mesh {

//! One of the arrays of VTK's image data: a value at each point of the grid, or in each of its cells.
struct VtkArray {
  std::string name;
  std::vector<double> values;
  bool of_cells = false;
};

//! Image data with what is known of it.
struct VtkImage {
  std::array<std::size_t, 3> points = {};  //!< along each edge
  Vec3 origin = Vec3::Zero();
  Mat3 steps = Mat3::Identity();
  std::string active;  //!< the name of the scalars that the file itself points out; may be empty
  std::vector<VtkArray> arrays;
};

//! \brief The field of an image: the array that is asked for, else the active one, else the only one. Values of cells
//! are at their centres.
//! \throw UserError (usage) where there are several arrays, with their names, (malformed) where their size is wrong
ScalarField field_of(const VtkImage& image, const std::string& array, const std::string& file);

}  // namespace nanocarbon::mesh
