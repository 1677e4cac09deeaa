// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/minimisation/multilevel/interpolation.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

namespace nanocarbon::multilevel {

namespace {

constexpr std::size_t most_nodes = 10;
// Added to the diagonal of the normal matrix, as a share of the sum of weights: leaves terms out that the nodes
// do not determine.
constexpr double linear_ridge = 1e-6, quadratic_ridge = 1e-3;
constexpr double largest_weight = 1.5;

constexpr int terms = 7;
using Terms = Eigen::Matrix<double, terms, 1>;
using NormalMatrix = Eigen::Matrix<double, terms, terms>;

struct Near {
  std::uint32_t node;
  Vec3 away;  // from the fine node, Angstrom
  double squared;
};

// The owner and coarse nodes at most two steps from it, nearest first.
void find_near(const Space& space, const Vec3& position, std::span<const Vec3> coarse, const NodeGraph& graph,
               std::uint32_t owner, std::vector<Near>& near) {
  near.clear();
  const auto add = [&](std::uint32_t node) {
    for (const Near& n : near)
      if (n.node == node) return;
    const Vec3 away = space.displacement(position, coarse[node]);
    near.push_back({node, away, away.squaredNorm()});
  };
  add(owner);
  for (const std::uint32_t first : graph.of(owner)) add(first);
  const std::size_t ring = near.size();
  for (std::size_t k = 1; k < ring; ++k)
    for (const std::uint32_t second : graph.of(near[k].node)) add(second);
  std::sort(near.begin(), near.end(), [](const Near& a, const Near& b) {
    return a.squared != b.squared ? a.squared < b.squared : a.node < b.node;
  });
}

// Weights of the nodes in the value at the origin of the polynomial that fits best.
void fit(std::span<const Near> near, double reach_squared, double ridge, std::vector<double>& weights) {
  Vec3 mean = Vec3::Zero();
  for (const Near& n : near) mean += n.away / static_cast<double>(near.size());
  Mat3 spread = Mat3::Zero();
  for (const Near& n : near) spread += (n.away - mean) * (n.away - mean).transpose();
  Eigen::SelfAdjointEigenSolver<Mat3> axes;
  axes.computeDirect(spread);
  const Mat3 frame = axes.eigenvectors().transpose() / std::sqrt(reach_squared);  // the least spread first

  NormalMatrix normal = NormalMatrix::Zero();
  std::array<Terms, most_nodes> rows;
  std::array<double, most_nodes> importance;
  double sum = 0;
  for (std::size_t k = 0; k < near.size(); ++k) {
    const double t = 1 - near[k].squared / reach_squared;
    importance[k] = t * t;
    const Vec3 at = frame * near[k].away;
    rows[k] << 1, at[0], at[1], at[2], at[1] * at[1], at[1] * at[2], at[2] * at[2];
    normal.noalias() += importance[k] * rows[k] * rows[k].transpose();
    sum += importance[k];
  }
  normal.diagonal().segment<3>(1).array() += linear_ridge * ridge * sum;
  normal.diagonal().tail<3>().array() += quadratic_ridge * ridge * sum;
  const Terms value = normal.llt().solve(Terms(Terms::Unit(0)));
  weights.resize(near.size());
  double total = 0;
  for (std::size_t k = 0; k < near.size(); ++k) total += weights[k] = importance[k] * rows[k].dot(value);
  for (double& w : weights) w /= total;
}

bool sane(std::span<const double> weights) {
  return std::all_of(weights.begin(), weights.end(),
                     [](double w) { return std::isfinite(w) && std::abs(w) < largest_weight; });
}

}  // namespace

Interpolation quadratic_interpolation(const Space& space, std::span<const Vec3> positions,
                                      const Coarsening& coarsening) {
  std::vector<Vec3> coarse;
  coarse.reserve(coarsening.chosen.size());
  for (const std::uint32_t node : coarsening.chosen) coarse.push_back(positions[node]);
  Interpolation result;
  std::vector<Near> near;
  std::vector<double> weights;
  std::vector<std::pair<std::uint32_t, double>> row;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    find_near(space, positions[i], coarse, coarsening.graph, coarsening.owner[i], near);
    // Weights come down to nothing at the first node that is left out.
    const double reach =
        near.size() > most_nodes ? near[most_nodes].squared : 1.5 * near.back().squared + 1e-6;
    if (near.size() > most_nodes) near.resize(most_nodes);
    double ridge = 1;
    for (fit(near, reach, ridge, weights); !sane(weights) && ridge < 1e8;) {
      ridge *= 100;
      fit(near, reach, ridge, weights);
    }
    if (!sane(weights)) weights.assign(near.size(), 1.0 / static_cast<double>(near.size()));
    row.clear();
    for (std::size_t k = 0; k < near.size(); ++k) row.emplace_back(near[k].node, weights[k]);
    std::sort(row.begin(), row.end());
    for (const auto& [node, weight] : row) {
      result.coarse.nodes.push_back(node);
      result.weights.push_back(weight);
    }
    result.coarse.offsets.push_back(static_cast<std::uint32_t>(result.coarse.nodes.size()));
  }
  return result;
}

}  // namespace nanocarbon::multilevel
