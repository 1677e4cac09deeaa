// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/core/approach_watch.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "nanocarbon/core/chunks.h"

namespace nanocarbon {

namespace {

constexpr double block_side = 12;  // Angstrom

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

}  // namespace

void ApproachWatch::set(std::span<const Vec3> positions) {
  reference_.assign(positions.begin(), positions.end());
  checked_ = reference_;
  left_ = margin_;
  blocks_.clear();
}

// Cubes of space that hold atoms of the reference, and which of them touch.
void ApproachWatch::divide() {
  using Cube = std::array<std::int64_t, 3>;
  std::vector<std::pair<Cube, std::uint32_t>> atoms;
  atoms.reserve(reference_.size());
  for (std::uint32_t a = 0; a < reference_.size(); ++a) {
    Cube cube;
    for (int d = 0; d < 3; ++d)
      cube[static_cast<std::size_t>(d)] =
          static_cast<std::int64_t>(std::floor(reference_[a][d] / block_side));
    atoms.emplace_back(cube, a);
  }
  std::sort(atoms.begin(), atoms.end());
  std::vector<Cube> cubes;
  atoms_.clear();
  for (const auto& [cube, a] : atoms) {
    const auto at = static_cast<std::uint32_t>(atoms_.size());
    if (cubes.empty() || cubes.back() != cube) {
      cubes.push_back(cube);
      blocks_.push_back({at, at, Vec3::Zero(), 0, Vec3::Zero(), Mat3::Identity(), 0, 0});
    }
    atoms_.push_back(a);
    blocks_.back().end = at + 1;
  }
  for (Block& block : blocks_) {
    for (std::uint32_t k = block.begin; k < block.end; ++k)
      block.centre += reference_[atoms_[k]] / (block.end - block.begin);
    for (std::uint32_t k = block.begin; k < block.end; ++k)
      block.radius = std::max(block.radius, (reference_[atoms_[k]] - block.centre).norm());
  }
  adjacent_.clear();
  for (std::uint32_t c = 0; c < cubes.size(); ++c)
    for (std::int64_t k = 0; k < 27; ++k) {
      const Cube other = {cubes[c][0] + k / 9 - 1, cubes[c][1] + k / 3 % 3 - 1, cubes[c][2] + k % 3 - 1};
      if (!(cubes[c] < other)) continue;
      const auto found = std::lower_bound(cubes.begin(), cubes.end(), other);
      if (found != cubes.end() && *found == other)
        adjacent_.emplace_back(c, static_cast<std::uint32_t>(found - cubes.begin()));
    }
}

void ApproachWatch::fit(Block& block, std::span<const Vec3> positions, const Vec3& mean_shift) const {
  block.now.setZero();
  for (std::uint32_t k = block.begin; k < block.end; ++k)
    block.now += positions[atoms_[k]] / (block.end - block.begin);
  Mat3 products = Mat3::Zero();
  for (std::uint32_t k = block.begin; k < block.end; ++k)
    products += (positions[atoms_[k]] - block.now) * (reference_[atoms_[k]] - block.centre).transpose();
  block.turn = best_turn(products);
  double spread2 = 0, apart2 = 0;
  for (std::uint32_t k = block.begin; k < block.end; ++k) {
    const Vec3 &was = reference_[atoms_[k]], &is = positions[atoms_[k]];
    spread2 = std::max(spread2, (is - block.now - block.turn * (was - block.centre)).squaredNorm());
    apart2 = std::max(apart2, (is - was - mean_shift).squaredNorm());
  }
  block.spread = std::sqrt(spread2);
  block.apart = std::sqrt(apart2);
}

// How much closer than at the reference two atoms near each other may be at most; infinite where atoms that were
// not may now be.
double ApproachWatch::largest_approach(std::span<const Vec3> positions, ThreadTeam* team) {
  if (blocks_.empty()) divide();
  Vec3 mean_shift = Vec3::Zero();
  for (std::size_t a = 0; a < positions.size(); ++a) mean_shift += positions[a] - reference_[a];
  mean_shift /= static_cast<double>(positions.size());
  constexpr std::size_t blocks_at_once = 64;
  for_each_index(team, (blocks_.size() + blocks_at_once - 1) / blocks_at_once, [&](std::size_t part) {
    for (std::size_t b = part * blocks_at_once; b < std::min(blocks_.size(), (part + 1) * blocks_at_once);
         ++b)
      fit(blocks_[b], positions, mean_shift);
  });
  double largest = 0, apart = 0;
  for (const Block& block : blocks_) {
    largest = std::max(largest, 2 * block.spread);
    apart = std::max(apart, block.apart);
  }
  // Atoms of blocks that do not touch were at least a block's side apart.
  if (!(2 * apart <= block_side - reach_ - margin_)) return std::numeric_limits<double>::infinity();
  for (const auto& [first, second] : adjacent_) {
    const Block &one = blocks_[first], &other = blocks_[second];
    // How far apart the two motions take an atom of either block, at most.
    const double turn = (one.turn - other.turn).norm() / std::sqrt(2.0);
    const auto at = [&](const Vec3& p) {
      return (one.now + one.turn * (p - one.centre) - other.now - other.turn * (p - other.centre)).norm();
    };
    const double between =
        std::min(at(one.centre) + turn * one.radius, at(other.centre) + turn * other.radius);
    largest = std::max(largest, between + one.spread + other.spread);
  }
  return largest;
}

bool ApproachWatch::may_be_closer(std::span<const Vec3> positions, bool whole_parts, ThreadTeam* team) {
  if (reference_.empty() || reference_.size() != positions.size()) return true;
  const double moved = largest_in_chunks(team, positions.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t a = begin; a < end; ++a)
      if (!((positions[a] - checked_[a]).squaredNorm() <= 0.25 * left_ * left_)) return 1.0;
    return 0.0;
  });
  if (moved == 0) return false;
  if (!whole_parts) return true;
  const double left = margin_ - largest_approach(positions, team);
  if (!(left >= 0)) return true;
  checked_.assign(positions.begin(), positions.end());
  left_ = left;
  return false;
}

}  // namespace nanocarbon
