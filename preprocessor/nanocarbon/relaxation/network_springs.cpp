#include "nanocarbon/relaxation/network_springs.h"

#include <algorithm>

namespace nanocarbon {

namespace {

double add_spring(const Vec3& a, const Vec3& b, double rest, double stiffness, Vec3& at_a, Vec3& at_b) {
  const Vec3 d = b - a;
  const double r = std::max(d.norm(), 1e-9), stretch = r - rest;
  const Vec3 force = stiffness * stretch / r * d;
  at_a -= force;
  at_b += force;
  return 0.5 * stiffness * stretch * stretch;
}

}  // namespace

double add_springs(const FixedBondRebo2::Graph& graph, std::span<const Vec3> positions,
                   std::span<Vec3> gradient, const SpringOptions& options) {
  double energy = 0;
  const std::size_t atoms = std::min(graph.inner, graph.neighbours.size());
  for (AtomIndex a = 0; a < atoms; ++a) {
    const auto& neighbours = graph.neighbours[a];
    for (unsigned s = 0; s < 3; ++s) {
      const AtomIndex n = neighbours[s], m = neighbours[(s + 1) % 3];
      if (n == no_atom) continue;
      if (n > a)
        energy +=
            add_spring(positions[a], positions[n], bond_rest_length, options.bond, gradient[a], gradient[n]);
      if (m != no_atom)
        energy += add_spring(positions[n], positions[m], second_neighbour_rest_length,
                             options.second_neighbour, gradient[n], gradient[m]);
    }
  }
  return energy;
}

}  // namespace nanocarbon
