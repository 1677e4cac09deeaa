// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/minimisation/lbfgs.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <deque>

#include "nanocarbon/minimisation/multilevel/sheet_preconditioner.h"

namespace nanocarbon::minimisation {

namespace {

using Vector = Eigen::VectorXd;  // x, y, z of all atoms

Eigen::Map<const Vector> flat(std::span<const Vec3> vectors) {
  return {vectors.data()->data(), static_cast<Eigen::Index>(3 * vectors.size())};
}

Eigen::Map<Vector> flat(std::vector<Vec3>& vectors) {
  return {vectors.data()->data(), static_cast<Eigen::Index>(3 * vectors.size())};
}

struct Pair {
  Vector step;
  Vector change;                 // of the gradient over the step
  double inverse_curvature = 0;  // 1 / (step . change)
};

// Initial inverse Hessian before there is any pair: carbon bonds have about 40 eV/Angstrom^2.
constexpr double first_scale = 0.02;

// Descent direction from the newest pairs. \param step scratch
void set_direction(std::vector<Vec3>& way, std::vector<Vec3>& step, const std::vector<Vec3>& slope,
                   const std::deque<Pair>& pairs, const multilevel::SheetPreconditioner* preconditioner) {
  Eigen::Map<Vector> direction = flat(way);
  direction = flat(std::span<const Vec3>(slope));
  std::vector<double> alpha(pairs.size());
  for (std::size_t k = pairs.size(); k-- > 0;) {
    alpha[k] = pairs[k].inverse_curvature * pairs[k].step.dot(direction);
    direction -= alpha[k] * pairs[k].change;
  }
  if (preconditioner) {
    preconditioner->apply(way, step);
    direction = -flat(step);
  } else {
    double scale = first_scale;
    if (!pairs.empty()) scale = 1 / (pairs.back().inverse_curvature * pairs.back().change.squaredNorm());
    direction *= -scale;
  }
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const double beta = pairs[k].inverse_curvature * pairs[k].change.dot(direction);
    direction -= (alpha[k] + beta) * pairs[k].step;
  }
}

}  // namespace

double largest_norm(std::span<const Vec3> vectors) {
  double largest = 0;
  for (const Vec3& v : vectors) largest = std::max(largest, v.squaredNorm());
  return std::sqrt(largest);
}

LbfgsResult minimise_lbfgs(std::vector<Vec3>& positions, const EnergyFunction& energy,
                           const LbfgsOptions& options) {
  constexpr int max_halvings = 12;
  const std::size_t n = positions.size();
  std::vector<Vec3> gradient(n, Vec3::Zero()), next_gradient(n), next(n), direction(n);
  std::deque<Pair> pairs;
  LbfgsResult result;
  result.energy = energy(positions, gradient);
  for (;;) {
    result.max_force = largest_norm(gradient);
    result.converged = result.max_force < options.force_tolerance;
    if (result.converged || result.iterations >= options.max_iterations) break;
    if (options.preconditioner) options.preconditioner->renew_if_strained(positions);
    set_direction(direction, next, gradient, pairs, options.preconditioner);
    const double slope = flat(direction).dot(flat(gradient));
    if (!(slope < 0)) {
      if (pairs.empty()) break;
      pairs.clear();
      continue;
    }
    const double longest =
        options.preconditioner ? options.preconditioner->strain(direction) : largest_norm(direction);
    const double limit = options.preconditioner ? options.max_strain : options.max_step;
    double factor = longest > limit ? limit / longest : 1;
    const double rounding = 1e-14 * (std::abs(result.energy) + static_cast<double>(n));
    double next_energy = 0;
    bool accepted = false;
    for (int halving = 0; halving < max_halvings && !accepted; ++halving) {
      flat(next) = flat(positions) + factor * flat(direction);
      std::fill(next_gradient.begin(), next_gradient.end(), Vec3::Zero());
      next_energy = energy(next, next_gradient);
      accepted = next_energy <= result.energy + 1e-4 * factor * slope + rounding;
      if (!accepted) factor *= 0.4;
    }
    if (!accepted) {
      if (pairs.empty()) break;
      pairs.clear();
      continue;
    }
    Pair pair;
    if (static_cast<int>(pairs.size()) == options.memory) {
      pair = std::move(pairs.front());
      pairs.pop_front();
    }
    pair.step = flat(next) - flat(positions);
    pair.change = flat(next_gradient) - flat(gradient);
    const double curvature = pair.step.dot(pair.change);
    if (curvature > 1e-10 * pair.change.squaredNorm()) {
      pair.inverse_curvature = 1 / curvature;
      pairs.push_back(std::move(pair));
    }
    positions.swap(next);
    gradient.swap(next_gradient);
    result.energy = next_energy;
    ++result.iterations;
    if (options.stop && options.stop(result.iterations, result.energy, positions)) {
      result.max_force = largest_norm(gradient);
      result.converged = result.max_force < options.force_tolerance;
      break;
    }
  }
  return result;
}

}  // namespace nanocarbon::minimisation
