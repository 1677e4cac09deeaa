// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "nanocarbon/core/vec3.h"

namespace nanocarbon::multilevel {

//! A symmetric matrix of 3 by 3: xx, xy, xz, yy, yz, zz. Springs between two nodes have such blocks, and so has
//! every weighted sum of them.
template <typename Number>
using SymmetricBlock = std::array<Number, 6>;

//! eV/Angstrom^2
using Block = SymmetricBlock<double>;

//! Gives the blocks of a row of a matrix, in its pattern's order.
using RowOf = std::function<void(std::size_t node, std::vector<Block>& blocks)>;

//! into += factor * block
inline void add(Block& into, double factor, const Block& block) {
  for (std::size_t k = 0; k < 6; ++k) into[k] += factor * block[k];
}

//! factor * direction * direction^T
inline Block dyad(const Vec3& direction, double factor) {
  const Vec3 d = factor * direction;
  return {d.x() * direction.x(), d.x() * direction.y(), d.x() * direction.z(),
          d.y() * direction.y(), d.y() * direction.z(), d.z() * direction.z()};
}

inline Block multiple_of_identity(double factor) { return {factor, 0, 0, factor, 0, factor}; }

//! \pre positive definite
inline Block inverse(const Block& b) {
  const double c0 = b[3] * b[5] - b[4] * b[4], c1 = b[2] * b[4] - b[1] * b[5], c2 = b[1] * b[4] - b[2] * b[3];
  const double scale = 1 / (b[0] * c0 + b[1] * c1 + b[2] * c2);
  return {scale * c0,
          scale * c1,
          scale * c2,
          scale * (b[0] * b[5] - b[2] * b[2]),
          scale * (b[1] * b[2] - b[0] * b[4]),
          scale * (b[0] * b[3] - b[1] * b[1])};
}

}  // namespace nanocarbon::multilevel
