// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/geometry_check.h"

#include <algorithm>
#include <limits>

#include "nanocarbon/core/neighbours_within.h"

namespace nanocarbon::annealing {

GeometryCheck check_geometry(std::span<const Vec3> positions, const FixedBondGraph& graph, ThreadTeam* team) {
  GeometryCheck check;
  check.shortest_bond = std::numeric_limits<double>::infinity();
  const NeighbourList close = neighbours_within(positions, graph.space.cell(), unbonded_search_radius, team);
  for (AtomIndex a = 0; a < positions.size(); ++a) {
    const auto& bonded = graph.neighbours[a];
    for (const AtomIndex n : bonded) {
      if (n == no_atom) continue;
      const double length = graph.space.displacement(positions[a], positions[n]).norm();
      check.shortest_bond = std::min(check.shortest_bond, length);
      check.longest_bond = std::max(check.longest_bond, length);
    }
    for (const Neighbour& n : close.of(a))
      if (std::find(bonded.begin(), bonded.end(), n.atom) == bonded.end())
        check.closest_unbonded = std::min(check.closest_unbonded,
                                          graph.space.displacement(positions[a], positions[n.atom]).norm());
  }
  return check;
}

}  // namespace nanocarbon::annealing
