// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/minimisation/multilevel/galerkin.h"

#include <gtest/gtest.h>

#include <Eigen/Core>

#include "nanocarbon/minimisation/multilevel/sheet_springs.h"
#include "nanocarbon/structures/fullerene.h"

namespace nanocarbon::multilevel {
namespace {

Eigen::MatrixXd dense(const NodeGraph& pattern, const RowOf& row_of) {
  const auto size = static_cast<Eigen::Index>(3 * pattern.size());
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(size, size);
  std::vector<Block> row;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    row_of(i, row);
    for (std::size_t k = 0; k < row.size(); ++k) {
      const Block& b = row[k];
      Mat3 full;
      full << b[0], b[1], b[2], b[1], b[3], b[4], b[2], b[4], b[5];
      result.block<3, 3>(static_cast<Eigen::Index>(3 * i), 3 * Eigen::Index{pattern.of(i)[k]}) = full;
    }
  }
  return result;
}

TEST(GalerkinProduct, IsTheProductOfTheFullMatrices) {
  const Molecule molecule = structures::fullerene(3, 3);
  SheetSprings springs(bonded_atoms(molecule.size(), molecule.bonds), {});
  springs.set(Space(), molecule.positions, {});
  const Coarsening coarsening = coarsen(springs.bonds(), 4);
  const Interpolation p = quadratic_interpolation(Space(), molecule.positions, coarsening);
  const GalerkinProduct product(springs.pattern(), p, coarsening.chosen.size());
  const RowOf fine = [&](std::size_t i, std::vector<Block>& row) { springs.row(i, row); };
  const std::vector<Block> blocks = product.blocks(springs.pattern(), fine, p);
  const NodeGraph& pattern = product.pattern();
  const RowOf coarse = [&](std::size_t i, std::vector<Block>& row) {
    row.assign(blocks.begin() + pattern.offsets[i], blocks.begin() + pattern.offsets[i + 1]);
  };

  const auto columns = static_cast<Eigen::Index>(3 * coarsening.chosen.size());
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(3 * molecule.size()), columns);
  for (std::size_t i = 0; i < molecule.size(); ++i)
    for (std::uint32_t e = p.coarse.offsets[i]; e < p.coarse.offsets[i + 1]; ++e)
      full.block<3, 3>(static_cast<Eigen::Index>(3 * i), 3 * Eigen::Index{p.coarse.nodes[e]}) =
          p.weights[e] * Mat3::Identity();
  const Eigen::MatrixXd expected = full.transpose() * dense(springs.pattern(), fine) * full;
  EXPECT_LT((dense(pattern, coarse) - expected).cwiseAbs().maxCoeff(), 1e-10);
}

}  // namespace
}  // namespace nanocarbon::multilevel
