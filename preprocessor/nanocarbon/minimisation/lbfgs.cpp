// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/minimisation/lbfgs.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <deque>

#include "nanocarbon/core/chunks.h"
#include "nanocarbon/minimisation/multilevel/sheet_preconditioner.h"

namespace nanocarbon::minimisation {

namespace {

using Vector = Eigen::VectorXd;  // x, y, z of all atoms

// Some atoms of a long vector.
Eigen::Map<const Vector> part(const std::vector<Vec3>& vectors, std::size_t begin, std::size_t end) {
  return {vectors[begin].data(), static_cast<Eigen::Index>(3 * (end - begin))};
}

Eigen::Map<Vector> part(std::vector<Vec3>& vectors, std::size_t begin, std::size_t end) {
  return {vectors[begin].data(), static_cast<Eigen::Index>(3 * (end - begin))};
}

struct Pair {
  std::vector<Vec3> step;
  std::vector<Vec3> change;      // of the gradient over the step
  double inverse_curvature = 0;  // 1 / (step . change)
};

double dot(const std::vector<Vec3>& a, const std::vector<Vec3>& b, ThreadTeam* team) {
  return sum_chunks(team, a.size(), [&](std::size_t begin, std::size_t end) {
    return part(a, begin, end).dot(part(b, begin, end));
  });
}

// Initial inverse Hessian before there is any pair: carbon bonds have about 40 eV/Angstrom^2.
constexpr double first_scale = 0.02;

// Descent direction from the newest pairs. \param step scratch
void set_direction(std::vector<Vec3>& way, std::vector<Vec3>& step, const std::vector<Vec3>& slope,
                   const std::deque<Pair>& pairs, const multilevel::SheetPreconditioner* preconditioner,
                   ThreadTeam* team) {
  const std::size_t count = way.size();
  // Each change of the direction with the product that is wanted next: long vectors are read once.
  const auto change_then_dot = [&](auto&& change, const std::vector<Vec3>* other) {
    return sum_chunks(team, count, [&](std::size_t begin, std::size_t end) {
      change(begin, end);
      return other ? part(*other, begin, end).dot(part(way, begin, end)) : 0.0;
    });
  };
  std::vector<double> alpha(pairs.size());
  double product = change_then_dot(
      [&](std::size_t begin, std::size_t end) { part(way, begin, end) = part(slope, begin, end); },
      pairs.empty() ? nullptr : &pairs.back().step);
  for (std::size_t k = pairs.size(); k-- > 0;) {
    alpha[k] = pairs[k].inverse_curvature * product;
    product = change_then_dot(
        [&](std::size_t begin, std::size_t end) {
          part(way, begin, end) -= alpha[k] * part(pairs[k].change, begin, end);
        },
        k > 0 ? &pairs[k - 1].step : nullptr);
  }
  const std::vector<Vec3>* first = pairs.empty() ? nullptr : &pairs.front().change;
  if (preconditioner) {
    preconditioner->apply(way, step);
    product = change_then_dot(
        [&](std::size_t begin, std::size_t end) { part(way, begin, end) = -part(step, begin, end); }, first);
  } else {
    double scale = first_scale;
    if (!pairs.empty())
      scale = 1 / (pairs.back().inverse_curvature * dot(pairs.back().change, pairs.back().change, team));
    product =
        change_then_dot([&](std::size_t begin, std::size_t end) { part(way, begin, end) *= -scale; }, first);
  }
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const double factor = alpha[k] + pairs[k].inverse_curvature * product;
    product = change_then_dot(
        [&](std::size_t begin, std::size_t end) {
          part(way, begin, end) -= factor * part(pairs[k].step, begin, end);
        },
        k + 1 < pairs.size() ? &pairs[k + 1].change : nullptr);
  }
}

}  // namespace

double largest_norm(std::span<const Vec3> vectors, ThreadTeam* team) {
  return std::sqrt(largest_in_chunks(team, vectors.size(), [&](std::size_t begin, std::size_t end) {
    double largest = 0;
    for (std::size_t i = begin; i < end; ++i) largest = std::max(largest, vectors[i].squaredNorm());
    return largest;
  }));
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
    result.max_force = largest_norm(gradient, options.team);
    result.converged = result.max_force < options.force_tolerance;
    if (result.converged || result.iterations >= options.max_iterations) break;
    if (options.preconditioner) options.preconditioner->renew_if_strained(positions);
    set_direction(direction, next, gradient, pairs, options.preconditioner, options.team);
    const double slope = dot(direction, gradient, options.team);
    if (!(slope < 0)) {
      if (pairs.empty()) break;
      pairs.clear();
      continue;
    }
    const double longest = options.preconditioner ? options.preconditioner->strain(direction)
                                                  : largest_norm(direction, options.team);
    const double limit = options.preconditioner ? options.max_strain : options.max_step;
    double factor = longest > limit ? limit / longest : 1;
    const double rounding = 1e-14 * (std::abs(result.energy) + static_cast<double>(n));
    double next_energy = 0;
    bool accepted = false;
    for (int halving = 0; halving < max_halvings && !accepted; ++halving) {
      for_chunks(options.team, n, [&](std::size_t begin, std::size_t end) {
        part(next, begin, end) = part(positions, begin, end) + factor * part(direction, begin, end);
        part(next_gradient, begin, end).setZero();
      });
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
    pair.step.resize(n);
    pair.change.resize(n);
    for_chunks(options.team, n, [&](std::size_t begin, std::size_t end) {
      part(pair.step, begin, end) = part(next, begin, end) - part(positions, begin, end);
      part(pair.change, begin, end) = part(next_gradient, begin, end) - part(gradient, begin, end);
    });
    const double curvature = dot(pair.step, pair.change, options.team);
    if (curvature > 1e-10 * dot(pair.change, pair.change, options.team)) {
      pair.inverse_curvature = 1 / curvature;
      pairs.push_back(std::move(pair));
    }
    positions.swap(next);
    gradient.swap(next_gradient);
    result.energy = next_energy;
    ++result.iterations;
    if (options.stop && options.stop(result.iterations, result.energy, positions)) {
      result.max_force = largest_norm(gradient, options.team);
      result.converged = result.max_force < options.force_tolerance;
      break;
    }
  }
  return result;
}

}  // namespace nanocarbon::minimisation
