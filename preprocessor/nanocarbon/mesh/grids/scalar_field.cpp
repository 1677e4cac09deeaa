// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/grids/scalar_field.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <cmath>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/parsing/text_scanner.h"

namespace nanocarbon::mesh {

std::size_t require_grid(const ScalarField& field, const std::string& file) {
  const auto& n = field.counts;
  const auto fail = [&](const std::string& what) {
    throw UserError(Failure::malformed, fmt::format("{}: {}; give a field in three dimensions", file, what));
  };
  double size = 1;
  for (const std::size_t count : n) size *= static_cast<double>(count);
  if (n[0] < 2 || n[1] < 2 || n[2] < 2)
    fail(fmt::format("the field of {} x {} x {} values has no extent in all directions", n[0], n[1], n[2]));
  if (size > 2e9) fail(fmt::format("the field of {} x {} x {} values is too large", n[0], n[1], n[2]));
  const Mat3& m = field.steps;
  const double lengths = m.col(0).norm() * m.col(1).norm() * m.col(2).norm();
  if (!m.allFinite() || !field.origin.allFinite() || !(std::abs(m.determinant()) > 1e-6 * lengths))
    fail("the steps of the field's grid span no volume");
  for (int d = 0; d < 3; ++d)
    if (coordinate_fault(m.col(d).norm() * static_cast<double>(n[static_cast<std::size_t>(d)])))
      fail("the field is larger than 1e50");
  return n[0] * n[1] * n[2];
}

void require_finite(const ScalarField& field, const std::string& file) {
  for (std::size_t i = 0; i < field.values.size(); ++i)
    if (!std::isfinite(field.values[i]))
      throw UserError(
          Failure::malformed,
          fmt::format("{}: the field's value {} of {} is not finite; repair the file or export it again",
                      file, i + 1, field.values.size()));
}

std::vector<float> last_index_fastest(const std::vector<float>& values, const std::array<std::size_t, 3>& n) {
  std::vector<float> result(values.size());
  std::size_t from = 0;
  for (std::size_t i = 0; i < n[0]; ++i)
    for (std::size_t j = 0; j < n[1]; ++j)
      for (std::size_t k = 0; k < n[2]; ++k) result[i + n[0] * (j + n[1] * k)] = values[from++];
  return result;
}

}  // namespace nanocarbon::mesh
