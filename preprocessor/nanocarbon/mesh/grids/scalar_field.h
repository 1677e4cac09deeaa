// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "nanocarbon/core/vec3.h"

namespace nanocarbon::mesh {

//! Values on a grid whose steps are all alike.
struct ScalarField {
  std::string name;                        //!< of the values, as the file has it; may be empty
  std::array<std::size_t, 3> counts = {};  //!< values along each of the grid's edges
  std::vector<float> values;               //!< the first edge's index runs fastest
  Vec3 origin = Vec3::Zero();              //!< place of the first value, mesh units
  Mat3 steps = Mat3::Identity();           //!< columns: from one value to the next
  std::array<std::size_t, 3> cell =
      {};            //!< steps along each edge of the cell that the file says it is of; 0: as many
                     //!< as there are values, or one less where the last are the first again
  std::string unit;  //!< of lengths, or empty
  std::vector<std::string> notes;

  float at(std::size_t i, std::size_t j, std::size_t k) const {
    return values[i + counts[0] * (j + counts[1] * k)];
  }
};

//! \brief Number of values of a grid, after they were found to fit.
//! \throw UserError (malformed) naming the file where an edge has fewer than two values, or there are more than
//! 2 billion, or the steps span no volume
std::size_t require_grid(const ScalarField& field, const std::string& file);

//! \throw UserError (malformed) where a value is not finite, saying which
void require_finite(const ScalarField& field, const std::string& file);

//! Values whose last index runs fastest, as they are in the file, in the order of ScalarField.
std::vector<float> last_index_fastest(const std::vector<float>& values,
                                      const std::array<std::size_t, 3>& counts);

}  // namespace nanocarbon::mesh
