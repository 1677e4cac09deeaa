// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/thesis/edge_energy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace nanocarbon::thesis {
namespace {

//! E(t) - E(0) along a line: c[0] t + c[1] t^2 + c[2] t^3 + c[3] t^4.
using LineEnergy = std::array<double, 4>;

double value(const LineEnergy& c, double t) { return t * (c[0] + t * (c[1] + t * (c[2] + t * c[3]))); }

LineEnergy line_energy(const EdgeEnergy& energy, const std::vector<Vec3>& direction) {
  const double m2 = energy.m * energy.m;
  LineEnergy c{};
  for (const EdgeTerm& term : energy.terms) {
    const Vec3 d = energy.points[term.a] - energy.points[term.b];
    const Vec3 u = term.b < energy.moving ? Vec3(direction[term.a] - direction[term.b]) : direction[term.a];
    const double q0 = d.squaredNorm() - m2, q1 = 2.0 * d.dot(u), q2 = u.squaredNorm();
    c[0] += term.weight * 2.0 * q0 * q1;
    c[1] += term.weight * (q1 * q1 + 2.0 * q0 * q2);
    c[2] += term.weight * 2.0 * q1 * q2;
    c[3] += term.weight * q2 * q2;
  }
  return c;
}

//! The t where the energy along the line is least, from the real roots of its derivative.
double least_on_line(const LineEnergy& c) {
  if (!(c[3] > 0.0)) return 0.0;
  // t^3 + a t^2 + b t + d = 0, depressed by t = s - a/3.
  const double a = 0.75 * c[2] / c[3], b = 0.5 * c[1] / c[3], d = 0.25 * c[0] / c[3];
  const double p = b - a * a / 3.0, q = a * (2.0 * a * a / 27.0 - b / 3.0) + d;
  const double discriminant = q * q / 4.0 + p * p * p / 27.0;
  std::array<double, 3> roots{};
  std::size_t count = 1;
  if (discriminant >= 0.0) {
    const double r = std::sqrt(discriminant);
    roots[0] = std::cbrt(-q / 2.0 + r) + std::cbrt(-q / 2.0 - r);
  } else {
    const double radius = 2.0 * std::sqrt(-p / 3.0);
    const double angle = std::acos(std::clamp(3.0 * q / (p * radius), -1.0, 1.0)) / 3.0;
    for (count = 0; count < 3; ++count)
      roots[count] = radius * std::cos(angle - 2.0 * std::numbers::pi * static_cast<double>(count) / 3.0);
  }
  double best = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    double t = roots[k] - a / 3.0;
    // One Newton step mends the cancellation in the closed form.
    const double slope = 2.0 * c[1] + t * (6.0 * c[2] + t * 12.0 * c[3]);
    if (slope != 0.0) {
      const double mended = t - (c[0] + t * (2.0 * c[1] + t * (3.0 * c[2] + t * 4.0 * c[3]))) / slope;
      if (value(c, mended) < value(c, t)) t = mended;
    }
    if (value(c, t) < value(c, best)) best = t;
  }
  return best;
}

double dot(const std::vector<Vec3>& x, const std::vector<Vec3>& y) {
  double sum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += x[i].dot(y[i]);
  return sum;
}

}  // namespace

double edge_energy(const EdgeEnergy& energy) {
  const double m2 = energy.m * energy.m;
  double sum = 0.0;
  for (const EdgeTerm& term : energy.terms) {
    const double q = (energy.points[term.a] - energy.points[term.b]).squaredNorm() - m2;
    sum += term.weight * q * q;
  }
  return sum;
}

void edge_energy_gradient(const EdgeEnergy& energy, std::vector<Vec3>& gradient) {
  const double m2 = energy.m * energy.m;
  gradient.assign(energy.moving, Vec3::Zero());
  for (const EdgeTerm& term : energy.terms) {
    const Vec3 d = energy.points[term.a] - energy.points[term.b];
    const Vec3 g = 4.0 * term.weight * (d.squaredNorm() - m2) * d;
    gradient[term.a] += g;
    if (term.b < energy.moving) gradient[term.b] -= g;
  }
  for (std::size_t i = 0; i < energy.normals.size(); ++i)
    gradient[i] -= gradient[i].dot(energy.normals[i]) * energy.normals[i];
}

MinimiserResult minimise(EdgeEnergy& energy, const MinimiserOptions& options, MinimiserWorkspace& workspace) {
  auto& [gradient, previous, direction] = workspace;
  MinimiserResult result;
  result.energy_before = result.energy_after = edge_energy(energy);
  edge_energy_gradient(energy, gradient);
  direction.resize(gradient.size());
  for (std::size_t i = 0; i < gradient.size(); ++i) direction[i] = -gradient[i];
  double gradient_norm = dot(gradient, gradient);
  while (result.iterations < options.max_iterations && gradient_norm > 0.0) {
    const LineEnergy line = line_energy(energy, direction);
    const double t = least_on_line(line);
    const double decrease = -value(line, t);
    if (!(decrease > 0.0)) break;
    for (std::size_t i = 0; i < energy.moving; ++i) energy.points[i] += t * direction[i];
    ++result.iterations;
    result.energy_after -= decrease;
    if (decrease <= options.relative_decrease * (result.energy_after + decrease)) break;

    previous.swap(gradient);
    edge_energy_gradient(energy, gradient);
    const double norm = dot(gradient, gradient);
    // Polak and Ribiere's factor, started afresh where it would be negative.
    const double factor = std::max(0.0, (norm - dot(gradient, previous)) / gradient_norm);
    gradient_norm = norm;
    for (std::size_t i = 0; i < gradient.size(); ++i) direction[i] = factor * direction[i] - gradient[i];
  }
  return result;
}

}  // namespace nanocarbon::thesis
