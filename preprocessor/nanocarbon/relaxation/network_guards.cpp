#include "nanocarbon/relaxation/network_guards.h"

#include <algorithm>
#include <cmath>

namespace nanocarbon {

namespace {

constexpr double kStiffness = 20;  // eV/Angstrom^2

double add_wall(const Vec3& a, const Vec3& b, double wall, Vec3& at_a, Vec3& at_b) {
  const Vec3 d = b - a;
  const double r = std::max(d.norm(), 1e-6), beyond = r - wall;
  const Vec3 force = kStiffness * beyond / r * d;
  at_a -= force;
  at_b += force;
  return 0.5 * kStiffness * beyond * beyond;
}

}  // namespace

double add_guards(const FixedBondRebo2::Graph& graph, std::span<const Vec3> positions,
                  std::span<Vec3> gradient) {
  constexpr double long2 = longest_unguarded_bond * longest_unguarded_bond;
  constexpr double close2 = closest_unguarded_second_neighbours * closest_unguarded_second_neighbours;
  double energy = 0;
  const std::size_t atoms = std::min(graph.inner, graph.neighbours.size());
  for (AtomIndex a = 0; a < atoms; ++a) {
    const auto& neighbours = graph.neighbours[a];
    for (unsigned s = 0; s < 3; ++s) {
      const AtomIndex n = neighbours[s], m = neighbours[(s + 1) % 3];
      if (n == no_atom) continue;
      if (n > a && (positions[n] - positions[a]).squaredNorm() > long2)
        energy += add_wall(positions[a], positions[n], longest_unguarded_bond, gradient[a], gradient[n]);
      if (m != no_atom && (positions[n] - positions[m]).squaredNorm() < close2)
        energy += add_wall(positions[n], positions[m], closest_unguarded_second_neighbours, gradient[n],
                           gradient[m]);
    }
  }
  return energy;
}

}  // namespace nanocarbon
