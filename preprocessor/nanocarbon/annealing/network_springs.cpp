// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/network_springs.h"

namespace nanocarbon::annealing {

namespace {

double add_springs_of(std::size_t begin, std::size_t end, const FixedBondGraph& graph,
                      std::span<const Vec3> positions, std::span<Vec3> gradient,
                      const SpringOptions& options) {
  double energy = 0;
  for (std::size_t a = begin; a < end; ++a) {
    const auto& neighbours = graph.neighbours[a];
    for (unsigned s = 0; s < 3; ++s) {
      const AtomIndex n = neighbours[s], m = neighbours[(s + 1) % 3];
      if (n == no_atom) continue;
      if (n > a)
        energy += add_harmonic_pair(positions[a], graph.space.beside(positions[n], positions[a]),
                                    bond_rest_length, options.bond, gradient[a], gradient[n]);
      if (m != no_atom)
        energy += add_harmonic_pair(positions[n], graph.space.beside(positions[m], positions[n]),
                                    second_neighbour_rest_length, options.second_neighbour, gradient[n],
                                    gradient[m]);
    }
  }
  return energy;
}

}  // namespace

double add_springs(const FixedBondGraph& graph, std::span<const Vec3> positions, std::span<Vec3> gradient,
                   const SpringOptions& options) {
  return add_springs_of(0, graph.inner_count(), graph, positions, gradient, options);
}

double add_springs(const FixedBondGraph& graph, const AtomChunks& chunks, std::span<const Vec3> positions,
                   std::span<Vec3> gradient, ThreadTeam* team) {
  return chunks.sum(team, [&](std::size_t chunk) {
    return add_springs_of(chunks.begin(chunk), chunks.end(chunk), graph, positions, gradient, {});
  });
}

}  // namespace nanocarbon::annealing
