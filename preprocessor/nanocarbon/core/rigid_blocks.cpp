// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/core/rigid_blocks.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "nanocarbon/core/chunks.h"

namespace nanocarbon {

namespace {

using Cube = std::array<std::int64_t, 3>;

// The rotation that takes one set of vectors nearest to another, from the sum of their products.
Mat3 best_turn(const Mat3& products) {
  const Eigen::JacobiSVD<Mat3> svd(products, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Mat3 turn = svd.matrixU() * svd.matrixV().transpose();
  if (turn.determinant() < 0) {
    Mat3 mirrored = svd.matrixU();
    mirrored.col(2) *= -1;
    turn = mirrored * svd.matrixV().transpose();
  }
  return turn;
}

template <typename Work>
void for_blocks(std::vector<RigidBlock>& blocks, ThreadTeam* team, const Work& work) {
  constexpr std::size_t at_once = 64;
  for_each_index(team, (blocks.size() + at_once - 1) / at_once, [&](std::size_t part) {
    for (std::size_t b = part * at_once; b < std::min(blocks.size(), (part + 1) * at_once); ++b)
      work(blocks[b]);
  });
}

}  // namespace

std::vector<std::pair<std::uint32_t, std::uint32_t>> RigidBlocks::divide(std::span<const Vec3> positions) {
  std::vector<std::pair<Cube, std::uint32_t>> placed;
  placed.reserve(positions.size());
  for (std::uint32_t a = 0; a < positions.size(); ++a) {
    Cube cube;
    for (int d = 0; d < 3; ++d)
      cube[static_cast<std::size_t>(d)] = static_cast<std::int64_t>(std::floor(positions[a][d] / block_side));
    placed.emplace_back(cube, a);
  }
  std::sort(placed.begin(), placed.end());
  std::vector<Cube> cubes;
  atoms_.clear();
  blocks_.clear();
  for (const auto& [cube, a] : placed) {
    const auto at = static_cast<std::uint32_t>(atoms_.size());
    if (cubes.empty() || cubes.back() != cube) {
      cubes.push_back(cube);
      blocks_.push_back({.begin = at, .end = at});
    }
    atoms_.push_back(a);
    blocks_.back().end = at + 1;
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> touching;
  for (std::uint32_t c = 0; c < cubes.size(); ++c)
    for (std::int64_t k = 0; k < 27; ++k) {
      const Cube other = {cubes[c][0] + k / 9 - 1, cubes[c][1] + k / 3 % 3 - 1, cubes[c][2] + k % 3 - 1};
      if (!(cubes[c] < other)) continue;
      const auto found = std::lower_bound(cubes.begin(), cubes.end(), other);
      if (found != cubes.end() && *found == other)
        touching.emplace_back(c, static_cast<std::uint32_t>(found - cubes.begin()));
    }
  return touching;
}

void RigidBlocks::set_from(std::span<const Vec3> was, ThreadTeam* team) {
  for_blocks(blocks_, team, [&](RigidBlock& block) {
    block.centre.setZero();
    for (std::uint32_t k = block.begin; k < block.end; ++k)
      block.centre += was[atoms_[k]] / (block.end - block.begin);
    double radius2 = 0;
    for (std::uint32_t k = block.begin; k < block.end; ++k)
      radius2 = std::max(radius2, (was[atoms_[k]] - block.centre).squaredNorm());
    block.radius = std::sqrt(radius2);
  });
}

void RigidBlocks::fit(std::span<const Vec3> was, std::span<const Vec3> is, ThreadTeam* team) {
  for_blocks(blocks_, team, [&](RigidBlock& block) {
    block.now.setZero();
    for (std::uint32_t k = block.begin; k < block.end; ++k)
      block.now += is[atoms_[k]] / (block.end - block.begin);
    Mat3 products = Mat3::Zero();
    for (std::uint32_t k = block.begin; k < block.end; ++k)
      products += (is[atoms_[k]] - block.now) * (was[atoms_[k]] - block.centre).transpose();
    block.turn = best_turn(products);
    double spread2 = 0;
    for (std::uint32_t k = block.begin; k < block.end; ++k)
      spread2 = std::max(
          spread2, (is[atoms_[k]] - block.now - block.turn * (was[atoms_[k]] - block.centre)).squaredNorm());
    block.spread = std::sqrt(spread2);
  });
}

double approach(const RigidBlock& one, const RigidBlock& other) {
  // How far apart the two motions take an atom of either block, at most.
  const double turn = (one.turn - other.turn).norm() / std::sqrt(2.0);
  const auto at = [&](const Vec3& p) {
    return (one.now + one.turn * (p - one.centre) - other.now - other.turn * (p - other.centre)).norm();
  };
  const double between = std::min(at(one.centre) + turn * one.radius, at(other.centre) + turn * other.radius);
  return between + one.spread + other.spread;
}

}  // namespace nanocarbon
