#include "nanocarbon/relaxation/lbfgs.h"

#include <algorithm>
#include <cmath>

namespace nanocarbon {

namespace {

struct Pair {
  std::vector<Vec3> step;
  std::vector<Vec3> change;  // of the gradient over the step
  double inverse_curvature;  // 1 / (step . change)
};

double dot(std::span<const Vec3> a, std::span<const Vec3> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
  return sum;
}

void add(std::vector<Vec3>& to, double factor, const std::vector<Vec3>& what) {
  for (std::size_t i = 0; i < to.size(); ++i) to[i] += factor * what[i];
}

// Initial inverse Hessian before there is any pair: carbon bonds have about 40 eV/Angstrom^2.
constexpr double kFirstScale = 0.02;

// Descent direction from the newest pairs.
void set_direction(std::vector<Vec3>& direction, const std::vector<Vec3>& gradient,
                   const std::deque<Pair>& pairs) {
  direction = gradient;
  std::vector<double> alpha(pairs.size());
  for (std::size_t k = pairs.size(); k-- > 0;) {
    alpha[k] = pairs[k].inverse_curvature * dot(pairs[k].step, direction);
    add(direction, -alpha[k], pairs[k].change);
  }
  double scale = kFirstScale;
  if (!pairs.empty()) {
    const Pair& newest = pairs.back();
    scale = 1 / (newest.inverse_curvature * dot(newest.change, newest.change));
  }
  for (Vec3& d : direction) d *= -scale;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const double beta = pairs[k].inverse_curvature * dot(pairs[k].change, direction);
    add(direction, -alpha[k] - beta, pairs[k].step);
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
    set_direction(direction, gradient, pairs);
    double slope = dot(direction, gradient);
    if (!(slope < 0)) {
      if (pairs.empty()) break;
      pairs.clear();
      continue;
    }
    const double longest = largest_norm(direction);
    double factor = longest > options.max_step ? options.max_step / longest : 1;
    const double rounding = 1e-14 * (std::abs(result.energy) + static_cast<double>(n));
    double next_energy = 0;
    bool accepted = false;
    for (int halving = 0; halving < max_halvings && !accepted; ++halving) {
      for (std::size_t i = 0; i < n; ++i) next[i] = positions[i] + factor * direction[i];
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
    Pair pair{std::vector<Vec3>(n), std::vector<Vec3>(n), 0};
    if (static_cast<int>(pairs.size()) == options.memory) {
      pair = std::move(pairs.front());
      pairs.pop_front();
    }
    for (std::size_t i = 0; i < n; ++i) {
      pair.step[i] = next[i] - positions[i];
      pair.change[i] = next_gradient[i] - gradient[i];
    }
    const double curvature = dot(pair.step, pair.change);
    if (curvature > 1e-10 * dot(pair.change, pair.change)) {
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

}  // namespace nanocarbon
