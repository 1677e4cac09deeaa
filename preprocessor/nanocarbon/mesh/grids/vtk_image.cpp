// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/grids/vtk_image.h"

#include <fmt/format.h>

#include <algorithm>

#include "nanocarbon/core/error.h"
#include "nanocarbon/core/text_numbers.h"

namespace nanocarbon::mesh {

ScalarField field_of(const VtkImage& image, const std::string& array, const std::string& file) {
  const std::string& name = array.empty() ? image.active : array;
  auto found = std::find_if(image.arrays.begin(), image.arrays.end(),
                            [&](const VtkArray& a) { return a.name == name; });
  if (found == image.arrays.end() && array.empty() && image.arrays.size() == 1) found = image.arrays.begin();
  if (found == image.arrays.end()) {
    std::string names;
    for (const VtkArray& a : image.arrays) names += (names.empty() ? "" : ", ") + shown(a.name);
    if (names.empty())
      throw UserError(
          Failure::malformed,
          fmt::format("{}: the image has no array with one number at each place; give a field", file));
    throw UserError(Failure::usage,
                    fmt::format("{}: name one of the file's arrays with --field: {}", file, names));
  }
  ScalarField field;
  field.name = found->name;
  field.counts = image.points;
  field.origin = image.origin;
  field.steps = image.steps;
  if (found->of_cells) {
    for (std::size_t& count : field.counts) count -= std::min<std::size_t>(count, 1);
    field.origin += 0.5 * image.steps * Vec3::Ones();
    // Cells fill their box: it is the period, where there is one.
    field.cell = field.counts;
  }
  const std::size_t size = require_grid(field, file);
  if (found->values.size() != size)
    throw UserError(
        Failure::malformed,
        fmt::format("{}: the array '{}' has {} values, but its grid {}; repair the file or export it again",
                    file, shown(found->name), found->values.size(), size));
  field.values.assign(found->values.begin(), found->values.end());
  require_finite(field, file);
  return field;
}

}  // namespace nanocarbon::mesh
