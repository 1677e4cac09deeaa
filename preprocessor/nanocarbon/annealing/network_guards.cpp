// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/network_guards.h"

#include <algorithm>

#include "nanocarbon/annealing/network_springs.h"

namespace nanocarbon::annealing {

namespace {

constexpr double stiffness = 20;  // eV/Angstrom^2

}  // namespace

double add_guards_at(AtomIndex a, const FixedBondGraph& graph, std::span<const Vec3> positions,
                     std::span<Vec3> gradient) {
  constexpr double long2 = longest_unguarded_bond * longest_unguarded_bond;
  constexpr double close2 = closest_unguarded_second_neighbours * closest_unguarded_second_neighbours;
  double energy = 0;
  const Space& space = graph.space;
  const auto& neighbours = graph.neighbours[a];
  for (unsigned s = 0; s < 3; ++s) {
    const AtomIndex n = neighbours[s], m = neighbours[(s + 1) % 3];
    if (n == no_atom) continue;
    if (n > a && space.displacement(positions[a], positions[n]).squaredNorm() > long2)
      energy += add_harmonic_pair(positions[a], space.beside(positions[n], positions[a]),
                                  longest_unguarded_bond, stiffness, gradient[a], gradient[n]);
    if (m != no_atom && space.displacement(positions[m], positions[n]).squaredNorm() < close2)
      energy += add_harmonic_pair(positions[n], space.beside(positions[m], positions[n]),
                                  closest_unguarded_second_neighbours, stiffness, gradient[n], gradient[m]);
  }
  return energy;
}

double add_guards(const FixedBondGraph& graph, std::span<const Vec3> positions, std::span<Vec3> gradient) {
  double energy = 0;
  for (AtomIndex a = 0; a < graph.inner_count(); ++a) energy += add_guards_at(a, graph, positions, gradient);
  return energy;
}

}  // namespace nanocarbon::annealing
