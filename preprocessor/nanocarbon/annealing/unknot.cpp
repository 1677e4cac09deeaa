// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/unknot.h"

#include <algorithm>

#include "nanocarbon/core/neighbours_within.h"
#include "nanocarbon/topology/bond_shells.h"

namespace nanocarbon::annealing {

namespace {

constexpr int sweeps = 60;

}  // namespace

std::vector<AtomIndex> tangled_atoms(std::span<const Vec3> positions, const FixedBondGraph& graph,
                                     ThreadTeam* team, const SeenBonds& seen) {
  std::vector<AtomIndex> tangled;
  const NeighbourList close = neighbours_within(positions, graph.space.cell(), seen.closest_unbonded, team);
  for (AtomIndex a = 0; a < positions.size(); ++a) {
    const auto& bonded = graph.neighbours[a];
    bool bad = false;
    for (const AtomIndex n : bonded)
      bad |= n != no_atom && graph.space.displacement(positions[a], positions[n]).norm() > seen.longest;
    for (const Neighbour& n : close.of(a))
      bad |= std::find(bonded.begin(), bonded.end(), n.atom) == bonded.end();
    if (bad) tangled.push_back(a);
  }
  return tangled;
}

std::vector<AtomIndex> unknot(std::vector<Vec3>& positions, const FixedBondGraph& graph,
                              const TetherSurface& surface, std::span<const AtomIndex> around,
                              unsigned radius) {
  std::vector<AtomIndex> region(around.begin(), around.end());
  std::vector<bool> inside(positions.size(), false);
  for (const AtomIndex a : region) inside[a] = true;
  std::size_t shell = 0;
  for (unsigned bonds = 0; bonds < radius; ++bonds)
    topology::add_bond_shell(graph, region, shell, topology::FirstTime(inside));
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (const AtomIndex a : region) {
      Vec3 sum = Vec3::Zero();
      int count = 0;
      for (const AtomIndex n : graph.neighbours[a])
        if (n != no_atom) {
          sum += graph.space.beside(positions[n], positions[a]);
          ++count;
        }
      if (count == 3) positions[a] = sum / count;
      // Centroids sink into a curved surface.
      if (sweep % 10 == 9) positions[a] = surface.nearest(positions[a]);
    }
  return region;
}

}  // namespace nanocarbon::annealing
