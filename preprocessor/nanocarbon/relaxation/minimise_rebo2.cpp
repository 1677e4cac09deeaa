#include "nanocarbon/relaxation/minimise_rebo2.h"

#include <algorithm>

#include "nanocarbon/core/neighbours_within.h"
#include "nanocarbon/rebo2/rebo2.h"
#include "nanocarbon/relaxation/lbfgs.h"

namespace nanocarbon {

namespace {

// Where the cut-off of carbon begins and ends (Brenner et al. 2002, table 2), Angstrom.
constexpr double kWholeBond = 1.7, kNoBond = 2.0;

// Whether REBO2 sees exactly the molecule's bonds between its carbons.
bool bonds_are_those_seen(const Molecule& molecule) {
  const NeighbourList near = neighbours_within(molecule.positions, nullptr, kNoBond);
  const auto is_carbon = [&](AtomIndex a) { return molecule.elements[a] == Element::carbon; };
  std::size_t seen = 0, listed = 0;
  for (AtomIndex a = 0; a < molecule.size(); ++a)
    for (const Neighbour& n : near.of(a)) seen += a < n.atom && is_carbon(a) && is_carbon(n.atom);
  for (const Bond& bond : molecule.bonds) {
    if (!is_carbon(bond.first) || !is_carbon(bond.second)) continue;
    ++listed;
    if ((molecule.positions[bond.first] - molecule.positions[bond.second]).norm() > kWholeBond) return false;
  }
  return seen == listed;
}

}  // namespace

Rebo2MinimisationResult minimise_rebo2(Molecule& molecule, const Rebo2MinimisationOptions& options) {
  Rebo2 rebo2;
  const auto energy = [&](std::span<const Vec3> positions, std::span<Vec3> gradient) {
    const Rebo2Result& result = rebo2.evaluate(positions, molecule.elements);
    for (std::size_t a = 0; a < gradient.size(); ++a) gradient[a] -= result.forces[a];
    return result.energy;
  };
  const LbfgsResult relaxed =
      minimise_lbfgs(molecule.positions, energy,
                     {.max_iterations = options.max_iterations, .force_tolerance = options.force_tolerance});
  return {relaxed.energy, relaxed.max_force, relaxed.iterations, relaxed.converged,
          bonds_are_those_seen(molecule)};
}

}  // namespace nanocarbon
