// SPDX-License-Identifier: GPL-2.0-or-later
#include "potential/airebo/plain_lj_sum.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace nanocarbon::airebo::test {

namespace {

using Image = std::array<std::int32_t, 3>;

struct Value {
  long double energy, slope;
};

//! V slw and its derivative by r, in long double.
Value pair_value(const LjParameters& parameters, std::size_t pair, long double r) {
  const LjPairParameters& p = parameters.pairs[pair];
  long double v, dv;
  if (parameters.form == LjForm::morse) {
    const long double x = p.morse_decay * (r - p.morse_equilibrium);
    v = p.morse_epsilon * (std::exp(-2 * x) - 2 * std::exp(-x));
    dv = p.morse_epsilon * p.morse_decay * 2 * (std::exp(-x) - std::exp(-2 * x));
  } else {
    v = 4 * p.epsilon * (std::pow(p.sigma / r, 12.0L) - std::pow(p.sigma / r, 6.0L));
    dv = 4 * p.epsilon * (6 * std::pow(p.sigma / r, 6.0L) - 12 * std::pow(p.sigma / r, 12.0L)) / r;
  }
  const long double low = parameters.switch_begin * static_cast<long double>(p.sigma);
  const long double high = parameters.switch_end * static_cast<long double>(p.sigma);
  if (r >= parameters.cutoff * static_cast<long double>(p.sigma) || r >= high) return {0, 0};
  if (r <= low) return {v, dv};
  const long double t = (r - low) / (high - low);
  const long double slw = 1 - t * t * (3 - 2 * t);
  return {v * slw, dv * slw - v * 6 * t * (1 - t) / (high - low)};
}

double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1.0p-53; }

Vec3 direction(std::mt19937_64& random) {
  for (;;) {
    const Vec3 v(2.0 * uniform(random) - 1.0, 2.0 * uniform(random) - 1.0, 2.0 * uniform(random) - 1.0);
    if (v.squaredNorm() > 0.01 && v.squaredNorm() <= 1.0) return v.normalized();
  }
}

}  // namespace

PlainSum plain_sum(const LjSystem& system, const LjParameters& parameters) {
  double reach = 0.0;
  for (std::size_t pair = 0; pair < 3; ++pair)
    reach = std::max(reach, parameters.switch_end * parameters.pairs[pair].sigma);
  // Images around the nearest one: half a cell each way, and what the reach needs.
  Image most = {0, 0, 0};
  Mat3 to_fractional = Mat3::Zero();
  if (system.cell) {
    const Vec3 heights = face_distances(*system.cell);
    for (int d = 0; d < 3; ++d)
      if (system.cell->periodic[d]) {
        most[d] = static_cast<int>(std::ceil(reach / heights[d] + 0.5));
        to_fractional.row(d) = system.cell->vectors.inverse().row(d);
      }
  }
  std::set<std::array<std::int64_t, 5>> excluded;  // none far away
  for (std::uint32_t i = 0; i < system.exclusions.atoms(); ++i)
    for (const Neighbour& n : system.exclusions.of(i)) {
      excluded.insert({i, n.atom, n.image[0], n.image[1], n.image[2]});
      excluded.insert({n.atom, i, -n.image[0], -n.image[1], -n.image[2]});
    }

  PlainSum sum;
  sum.forces.assign(system.size(), Vec3::Zero());
  sum.atom_energies.assign(system.size(), 0.0);
  sum.atom_virials.assign(system.size(), Mat3::Zero());
  for (std::uint32_t i = 0; i < system.size(); ++i)
    for (std::uint32_t j = 0; j < system.size(); ++j) {
      const Vec3 apart = to_fractional * (system.positions[i] - system.positions[j]);
      const std::array<int, 3> middle = {static_cast<int>(std::lround(apart[0])),
                                         static_cast<int>(std::lround(apart[1])),
                                         static_cast<int>(std::lround(apart[2]))};
      for (int a = middle[0] - most[0]; a <= middle[0] + most[0]; ++a)
        for (int b = middle[1] - most[1]; b <= middle[1] + most[1]; ++b)
          for (int c = middle[2] - most[2]; c <= middle[2] + most[2]; ++c) {
            Vec3 delta = system.positions[i] - system.positions[j];
            if (system.cell) delta -= image_shift(*system.cell, {a, b, c});
            const double r = delta.norm();
            if (r >= reach || (i == j && a == 0 && b == 0 && c == 0)) continue;
            if (r < 10.0 && excluded.count({i, j, a, b, c})) continue;
            const Value value =
                pair_value(parameters, LjParameters::index(system.elements[i], system.elements[j]), r);
            const Vec3 force = static_cast<double>(-value.slope / r) * delta;
            const Mat3 half_virial = 0.5 * delta * force.transpose();
            const double half = 0.5 * static_cast<double>(value.energy);
            sum.energy += half;
            sum.virial += half_virial;
            sum.forces[i] += force;
            sum.atom_energies[i] += half;
            sum.atom_virials[i] += half_virial;
            sum.largest_pair_force = std::max(sum.largest_pair_force, force.norm());
            sum.sum_of_magnitudes += std::abs(half);
          }
    }
  return sum;
}

LjParameters published_parameters(LjForm form) {
  LjParameters p;
  p.pairs[0] = {0.002843732471143, 3.4, 0.0028437, 1.8168084, 3.6891063};
  p.pairs[1] = {0.002064935027177, 3.025, 0.0020649, 1.53168632129, 3.3955};
  p.pairs[2] = {0.001499422575693, 2.65, 0.0014994, 1.74844310191, 2.9745};
  p.form = form;
  return p;
}

LjSystem random_system(std::size_t atoms, std::optional<Cell> cell, double share_of_hydrogen, unsigned seed) {
  std::mt19937_64 random(seed);
  LjSystem system;
  system.name = std::to_string(atoms) + " atoms, seed " + std::to_string(seed);
  system.cell = cell;
  const double side = std::cbrt(static_cast<double>(atoms) / 0.08);
  while (system.size() < atoms) {
    Vec3 f(uniform(random), uniform(random), uniform(random));
    // Not all of them in the cell.
    if (cell && random() % 4 == 0)
      for (int d = 0; d < 3; ++d)
        if (cell->periodic[d]) f[d] += static_cast<double>(random() % 5) - 2.0;
    const Vec3 p = cell ? Vec3(cell->origin + cell->vectors * f) : Vec3(side * f);
    system.positions.push_back(p);
    const NeighbourList close = neighbours_within(system.positions, system.cell_or_none(), 1.0);
    const auto mine = close.of(system.size() - 1);
    if (std::any_of(mine.begin(), mine.end(),
                    [&](const Neighbour& n) { return n.atom + 1 != system.size(); }))
      system.positions.pop_back();
    else
      system.elements.push_back(uniform(random) < share_of_hydrogen ? Element::hydrogen : Element::carbon);
  }
  system.exclusions = neighbours_within(system.positions, system.cell_or_none(), 2.5);
  return system;
}

LjSystem shaken(LjSystem system, double distance, unsigned seed) {
  std::mt19937_64 random(seed);
  for (Vec3& p : system.positions) p += distance * direction(random);
  return system;
}

}  // namespace nanocarbon::airebo::test
