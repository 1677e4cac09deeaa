// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/structures/spring_relaxation.h"

#include <LBFGS.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "nanocarbon/core/space.h"

namespace nanocarbon::structures {
namespace {

struct Spring {
  AtomIndex first, second;
  double rest;       // Angstrom
  double stiffness;  // relative
};

std::vector<Spring> springs_of(const Molecule& molecule, const SpringRelaxationOptions& options) {
  std::vector<Spring> springs;
  for (const Bond& bond : molecule.bonds) springs.push_back({bond.first, bond.second, options.bond, 1.0});
  for (std::size_t r = 0; r < molecule.rings.size(); ++r) {
    const auto ring = molecule.rings[r];
    const auto size = static_cast<double>(ring.size());
    const double rest = 2.0 * options.bond * std::cos(std::numbers::pi / size);
    if (ring.size() < 5) continue;  // across a square there is no second neighbour to hold apart
    for (std::size_t i = 0; i < ring.size(); ++i)
      springs.push_back({ring[i], ring[(i + 2) % ring.size()], rest, options.ring_stiffness});
  }
  return springs;
}

double spring_energy(const std::vector<Spring>& springs, const Space& space, const Eigen::VectorXd& x,
                     Eigen::VectorXd& gradient) {
  double energy = 0.0;
  gradient.setZero();
  for (const Spring& s : springs) {
    const Vec3 delta = space.displacement(x.segment<3>(3 * s.first), x.segment<3>(3 * s.second));
    const double length = delta.norm(), stretch = length - s.rest;
    energy += 0.5 * s.stiffness * stretch * stretch;
    const Vec3 pull = s.stiffness * stretch / length * delta;
    gradient.segment<3>(3 * s.second) += pull;
    gradient.segment<3>(3 * s.first) -= pull;
  }
  return energy;
}

}  // namespace

SpringResult relax_by_springs(Molecule& molecule, const SpringRelaxationOptions& options) {
  const std::vector<Spring> springs = springs_of(molecule, options);
  const Space space(molecule.cell);
  const auto n = static_cast<Eigen::Index>(molecule.size());
  Eigen::VectorXd x(3 * n);
  for (Eigen::Index i = 0; i < n; ++i) x.segment<3>(3 * i) = molecule.positions[static_cast<std::size_t>(i)];

  LBFGSpp::LBFGSParam<double> param;
  param.max_iterations = options.iterations;
  param.epsilon = 0.0;
  param.epsilon_rel = 1e-7;
  param.past = 3;
  param.delta = 1e-5;
  LBFGSpp::LBFGSSolver<double> solver(param);
  double energy = 0.0;
  int iterations = 0;
  auto objective = [&](const Eigen::VectorXd& at, Eigen::VectorXd& gradient) {
    return spring_energy(springs, space, at, gradient);
  };
  try {
    iterations = solver.minimize(objective, x, energy);
  } catch (const std::runtime_error&) {
    // The line search found nothing better than x: as good as it gets.
  } catch (const std::logic_error&) {
    // Rounding turned the search direction uphill, which happens only close to the minimum.
  }
  for (Eigen::Index i = 0; i < n; ++i) molecule.positions[static_cast<std::size_t>(i)] = x.segment<3>(3 * i);

  SpringResult result{iterations, std::numeric_limits<double>::infinity(), 0.0};
  for (const Bond& bond : molecule.bonds) {
    const double length =
        space.displacement(molecule.positions[bond.first], molecule.positions[bond.second]).norm();
    result.shortest_bond = std::min(result.shortest_bond, length);
    result.longest_bond = std::max(result.longest_bond, length);
  }
  return result;
}

}  // namespace nanocarbon::structures
