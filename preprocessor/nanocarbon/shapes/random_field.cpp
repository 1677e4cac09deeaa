// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/shapes/random_field.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "nanocarbon/core/random_stream.h"

namespace nanocarbon::shapes {
namespace {

constexpr double pi = std::numbers::pi;

// Of wave lengths: how far apart saddles are looked for from, how far from there they may be, how near to each other
// two are one, and how wide bumps are.
constexpr double between_starts = 0.125, farthest = 0.2, same_place = 0.02, bump_width = 0.2;
constexpr int newton_steps = 20, most_rounds = 40;

// What a bump is far from its centre is left out: below rounding.
constexpr double least_exponent = -40;

}  // namespace

RandomField::RandomField(double size, double waves, std::uint64_t seed)
    : size_(size), wave_length_(size / waves) {
  constexpr std::size_t enough = 60;  // waves: of more the field is not more Gaussian to the eye, but dearer
  std::vector<Vec3> shell;
  const int most = static_cast<int>(std::ceil(waves)) + 1;
  for (int i = -most; i <= most; ++i)
    for (int j = -most; j <= most; ++j)
      for (int k = 0; k <= most; ++k) {
        const bool first_of_two = k > 0 || j > 0 || (j == 0 && i > 0);
        const Vec3 n(i, j, k);
        if (!first_of_two || std::abs(n.norm() - waves) > 0.5) continue;
        shell.push_back(n);
      }
  RandomStream random(seed, 0);
  double squares = 0.0;
  while (!shell.empty() && waves_.size() < enough) {
    std::swap(shell[random.below(shell.size())], shell.back());
    // The square root of an exponential and a phase: a Gaussian complex amplitude.
    const double amplitude = std::sqrt(-std::log(std::max(random.uniform(), 1e-300)));
    waves_.push_back({2.0 * pi / size * shell.back(), amplitude, 2.0 * pi * random.uniform()});
    squares += 0.5 * amplitude * amplitude;
    shell.pop_back();
  }
  for (Wave& wave : waves_) wave.amplitude /= std::sqrt(squares);
}

double RandomField::operator()(const Vec3& at) const {
  double sum = 0.0;
  for (const Wave& wave : waves_) sum += wave.amplitude * std::cos(wave.vector.dot(at) + wave.phase);
  if (bumps_.empty()) return sum;
  const Vec3 angle = 2.0 * pi / size_ * at, c = angle.array().cos(), s = angle.array().sin();
  for (const Bump& bump : bumps_) {
    const double exponent = bump.narrow * (bump.cosine.dot(c) + bump.sine.dot(s) - 3.0);
    if (exponent > least_exponent) sum += bump.height * std::exp(exponent);
  }
  return sum;
}

RandomField::Jet RandomField::jet(const Vec3& at) const {
  Jet jet;
  for (const Wave& wave : waves_) {
    const double angle = wave.vector.dot(at) + wave.phase, c = wave.amplitude * std::cos(angle);
    jet.value += c;
    jet.gradient -= wave.amplitude * std::sin(angle) * wave.vector;
    jet.hessian -= c * wave.vector * wave.vector.transpose();
  }
  const double turn = 2.0 * pi / size_;
  const Vec3 angle = turn * at, here_c = angle.array().cos(), here_s = angle.array().sin();
  for (const Bump& bump : bumps_) {
    // Of the angles from the bump's centre.
    const Vec3 c = bump.cosine.cwiseProduct(here_c) + bump.sine.cwiseProduct(here_s);
    const Vec3 s = bump.cosine.cwiseProduct(here_s) - bump.sine.cwiseProduct(here_c);
    const double exponent = bump.narrow * (c.sum() - 3.0);
    if (exponent <= least_exponent) continue;
    const double value = bump.height * std::exp(exponent);
    const Vec3 slope = -bump.narrow * turn * s;
    jet.value += value;
    jet.gradient += value * slope;
    jet.hessian += value * (slope * slope.transpose());
    jet.hessian.diagonal() -= value * bump.narrow * turn * turn * c;
  }
  return jet;
}

void RandomField::add_bump(const Vec3& centre, double height, double width) {
  const double turn = 2.0 * pi / size_;
  const Vec3 angle = turn * centre;
  bumps_.push_back({angle.array().cos(), angle.array().sin(), height, 1.0 / (turn * turn * width * width)});
}

namespace {

// The point without a gradient that Newton's steps lead to, if it is near.
std::optional<Vec3> critical_point(const RandomField& field, const Vec3& start) {
  const double length = field.wave_length();
  Vec3 at = start;
  for (int k = 0; k < newton_steps; ++k) {
    const RandomField::Jet jet = field.jet(at);
    Vec3 step = -Eigen::FullPivLU<Mat3>(jet.hessian).solve(jet.gradient);
    if (!step.allFinite()) return {};
    const double size = step.norm();
    if (size > 0.1 * length) step *= 0.1 * length / size;
    at += step;
    if ((at - start).norm() > farthest * length) return {};
    if (size < 1e-9 * length) return at;
  }
  return {};
}

// By how much the value must go away from the level at a saddle so that what is on its side of the level is as thick as
// twice a radius there.
double lack_at(const RandomField& field, const Vec3& saddle, double level, double radius) {
  const RandomField::Jet jet = field.jet(saddle);
  const double above = jet.value - level, side = above < 0 ? -1 : 1;
  const Eigen::Vector3d curvatures = Eigen::SelfAdjointEigenSolver<Mat3>(side * jet.hessian).eigenvalues();
  if (curvatures[0] >= 0 || curvatures[2] <= 0) return 0;  // not a saddle
  return side * std::max(0.0, -0.5 * curvatures[0] * radius * radius - side * above);
}

// The saddles that lack something, each once.
std::vector<Vec3> thin_places(const RandomField& field, double level, double radius) {
  const double length = field.wave_length();
  const int steps = static_cast<int>(std::ceil(field.size() / (between_starts * length)));
  // Beyond this no saddle is thin, however curved: the field's waves all have the same length.
  const double wave_number = 2.0 * pi / length, near = 1.5 * wave_number * wave_number * radius * radius;
  std::vector<Vec3> places;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j)
      for (int k = 0; k < steps; ++k) {
        const Vec3 start = field.size() / steps * Vec3(i, j, k);
        // A start's value may differ from the saddle's by what the field changes on the way.
        if (std::abs(field(start) - level) > near + 0.5) continue;
        const std::optional<Vec3> found = critical_point(field, start);
        if (!found || lack_at(field, *found, level, radius) == 0) continue;
        const bool known = std::any_of(places.begin(), places.end(), [&](const Vec3& p) {
          Vec3 apart = (p - *found) / field.size();
          apart -= Vec3(apart.array().round());
          return apart.norm() * field.size() < same_place * length;
        });
        if (!known) places.push_back(*found);
      }
  return places;
}

}  // namespace

std::size_t thicken_necks(RandomField& field, double level, double thickness) {
  const double radius = 0.5 * thickness, width = bump_width * field.wave_length();
  if (!(radius > 0)) return 0;
  std::size_t changed = 0;
  for (int round = 0; round < most_rounds; ++round) {
    std::size_t now = 0;
    for (const Vec3& place : thin_places(field, level, radius)) {
      // Of those near each other the first bump may do for all.
      const double lack = lack_at(field, place, level, radius);
      if (lack == 0) continue;
      field.add_bump(place, 1.05 * lack * std::exp(0.5 * radius * radius / (width * width)), width);
      ++now;
    }
    if (round == 0) changed = now;
    if (now == 0) break;
  }
  return changed;
}

}  // namespace nanocarbon::shapes
