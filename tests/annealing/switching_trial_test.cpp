// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/switching_trial.h"

#include <gtest/gtest.h>

#include "nanocarbon/annealing/bond_switching.h"
#include "nanocarbon/potential/rebo2/parameters.h"
#include "support/rough_sphere.h"

namespace nanocarbon::annealing {
namespace {

// An icosahedral fullerene relaxed on its sphere: bent alike everywhere, by far more than a large molecule.
struct Fullerene {
  explicit Fullerene(int n) {
    const TriangleMesh mesh = test::unit_sphere(n);
    const double scale = test::scale_for(mesh.triangles.size(), 4 * std::numbers::pi);
    state.network = trivalent_network(mesh);
    for (const Triangle& t : mesh.triangles)
      state.positions.push_back(scale *
                                (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]).normalized());
    state.tether = 0;
    const TetherSurface surface(test::unit_sphere(16), scale);
    per_atom = relax_state(state, surface, 2000, 1e-3) / static_cast<double>(state.positions.size());
  }
  SwitchingState state;
  double per_atom = 0;
};

// The bond that leads from one pentagon of the fullerene to the ring beyond: removing it is a climb.
NetworkEdit climb_at_a_pentagon(const TrivalentNetwork& network) {
  for (RingIndex ring = 0; ring < network.rings.size(); ++ring) {
    if (network.rings[ring].size != 5) continue;
    std::vector<AtomIndex> atoms;
    atoms_of_ring(network, ring, atoms);
    const unsigned corner = slot_of_ring(network.atoms[atoms[0]], ring);
    if (auto edit = collapse_bond(network, atoms[0], corner)) return *edit;
  }
  throw std::logic_error("no pentagon");
}

// Where everything is bent alike, the energy of two atoms is what the mean of all says, not graphene's: by
// the latter, climbs that take atoms away would gain twice what bending costs.
TEST(TryEdit, AtomsLostCountWithTheMeanEnergyAround) {
  const Fullerene fullerene(4);  // 320 atoms, 0.15 eV an atom above graphene
  ASSERT_GT(fullerene.per_atom - rebo2::graphene_energy, 0.12);
  TrialWorkspace workspace;
  const NetworkEdit edit = climb_at_a_pentagon(fullerene.state.network);
  const Trial open = try_edit(fullerene.state, edit, 1000, -1, workspace);
  ASSERT_TRUE(open.accepted);
  const double price = open.energy_change - edit.atoms_added() * fullerene.per_atom;
  constexpr double margin = 0.15;  // eV: the patch is a part of the molecule, with a pentagon in its midst
  EXPECT_TRUE(try_edit(fullerene.state, edit, price + margin, -1, workspace).accepted);
  EXPECT_FALSE(try_edit(fullerene.state, edit, price - margin, -1, workspace).accepted);
}

}  // namespace
}  // namespace nanocarbon::annealing
