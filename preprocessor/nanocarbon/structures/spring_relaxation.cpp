// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/structures/spring_relaxation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include "nanocarbon/core/space.h"
#include "nanocarbon/minimisation/lbfgs.h"

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

double spring_energy(const std::vector<Spring>& springs, const Space& space, std::span<const Vec3> positions,
                     std::span<Vec3> gradient) {
  double energy = 0.0;
  for (const Spring& s : springs) {
    const Vec3 delta = space.displacement(positions[s.first], positions[s.second]);
    const double length = delta.norm(), stretch = length - s.rest;
    energy += 0.5 * s.stiffness * stretch * stretch;
    const Vec3 pull = s.stiffness * stretch / length * delta;
    gradient[s.second] += pull;
    gradient[s.first] -= pull;
  }
  return energy;
}

// Whether the last three iterations together lowered the energy by less than 1e-5 of it.
class Stalled {
 public:
  bool operator()(int iteration, double energy, std::span<const Vec3>) {
    double& before = last_three_[static_cast<std::size_t>(iteration) % 3];
    const bool stalled = before - energy < 1e-5 * energy;
    before = energy;
    return stalled;
  }

 private:
  std::array<double, 3> last_three_{std::numeric_limits<double>::infinity(),
                                    std::numeric_limits<double>::infinity(),
                                    std::numeric_limits<double>::infinity()};
};

}  // namespace

SpringResult relax_by_springs(Molecule& molecule, const SpringRelaxationOptions& options) {
  const std::vector<Spring> springs = springs_of(molecule, options);
  const Space space(molecule.cell);
  minimisation::LbfgsOptions lbfgs;
  lbfgs.max_iterations = options.iterations;
  lbfgs.force_tolerance = 1e-6;  // Angstrom: springs of bonds have stiffness 1
  lbfgs.max_step = std::numeric_limits<double>::infinity();
  lbfgs.stop = Stalled{};
  const auto minimum = minimisation::minimise_lbfgs(
      molecule.positions,
      [&](std::span<const Vec3> at, std::span<Vec3> gradient) {
        return spring_energy(springs, space, at, gradient);
      },
      lbfgs);

  SpringResult result{minimum.iterations, std::numeric_limits<double>::infinity(), 0.0};
  for (const Bond& bond : molecule.bonds) {
    const double length =
        space.displacement(molecule.positions[bond.first], molecule.positions[bond.second]).norm();
    result.shortest_bond = std::min(result.shortest_bond, length);
    result.longest_bond = std::max(result.longest_bond, length);
  }
  return result;
}

}  // namespace nanocarbon::structures
