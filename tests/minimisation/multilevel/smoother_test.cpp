// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/minimisation/multilevel/smoother.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nanocarbon::multilevel {
namespace {

// A chain of springs with an anchor at each node, long enough for several chunks.
class ChainOfSprings : public testing::Test {
 protected:
  static constexpr std::uint32_t size = 5000;
  ChainOfSprings() : smoother(pattern) { smoother.set(pattern, row_of); }
  static NodeGraph make_pattern() {
    NodeGraph result;
    for (std::uint32_t i = 0; i < size; ++i) {
      for (std::uint32_t j = i > 0 ? i - 1 : 0; j <= std::min(i + 1, size - 1); ++j)
        result.nodes.push_back(j);
      result.offsets.push_back(static_cast<std::uint32_t>(result.nodes.size()));
    }
    return result;
  }
  const NodeGraph pattern = make_pattern();
  const RowOf row_of = [this](std::size_t i, std::vector<Block>& row) {
    row.clear();
    for (const std::uint32_t j : pattern.of(i)) {
      Block block = multiple_of_identity(j == i ? 3.0 : -1.0);
      add(block, j == i ? 1.0 : -0.3, dyad(Vec3(1, 2, -1), 0.2));
      row.push_back(block);
    }
  };
  Displacements residual_of(const Displacements& b, const Displacements& x) const {
    Displacements r = b;
    std::vector<Block> row;
    for (std::size_t i = 0; i < size; ++i) {
      row_of(i, row);
      for (std::size_t k = 0; k < row.size(); ++k) {
        const std::size_t j = pattern.of(i)[k];
        const Block& m = row[k];
        const std::size_t at[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
        for (std::size_t d = 0; d < 3; ++d)
          for (std::size_t e = 0; e < 3; ++e) r[3 * i + d] -= static_cast<float>(m[at[d][e]]) * x[3 * j + e];
      }
    }
    return r;
  }
  Smoother smoother;
};

TEST_F(ChainOfSprings, TheResidualOfTheFirstSweepIsWhatItLeaves) {
  Displacements b(3 * size), x(3 * size), residual(3 * size);
  for (std::size_t k = 0; k < b.size(); ++k) b[k] = std::sin(0.37f * static_cast<float>(k));
  smoother.sweep_from_zero(b, x, residual);
  const Displacements expected = residual_of(b, x);
  for (std::size_t k = 0; k < b.size(); ++k) ASSERT_NEAR(residual[k], expected[k], 1e-5);
}

TEST_F(ChainOfSprings, SweepsComeToTheSolution) {
  Displacements b(3 * size), x(3 * size), residual(3 * size);
  for (std::size_t k = 0; k < b.size(); ++k) b[k] = std::cos(0.11f * static_cast<float>(k));
  smoother.sweep_from_zero(b, x, residual);
  for (int sweep = 0; sweep < 60; ++sweep) smoother.sweep_back(b, x);
  for (const float r : residual_of(b, x)) ASSERT_NEAR(r, 0, 1e-4);
}

}  // namespace
}  // namespace nanocarbon::multilevel
