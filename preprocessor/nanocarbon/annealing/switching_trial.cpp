// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/switching_trial.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "nanocarbon/annealing/boundary_edit.h"

namespace nanocarbon::annealing {

namespace {

constexpr unsigned screen_radius = 3, radius = 6;  // bonds
constexpr long longest_chain = 4;  // atoms of an armchair edge's bay: in a longer one hydrogens would meet
constexpr double screen_margin = 1.7;  // eV above the threshold at which a screened flip is dropped

long squared_defect(long size) { return (size - 6) * (size - 6); }

// Change of the sum of (size - 6)^2 over rings; nothing where a ring or a chain on the boundary gets a size it must
// not have.
std::optional<long> defect_change(const TrivalentNetwork& network, const NetworkEdit& edit,
                                  long largest_ring) {
  long change = 0;
  for (const auto& [ring, difference] : edit.rings) {
    const bool is_new = is_added_ring(ring);
    const bool was_chain = is_new ? edit.new_rings_open : network.rings[ring].boundary;
    const bool is_chain = (was_chain && ring != edit.closed) || ring == edit.opened;
    const long before = is_new ? 0 : static_cast<long>(network.rings[ring].size), after = before + difference;
    if (!is_new && !was_chain) change -= squared_defect(before);
    if (after == 0) continue;
    if (is_chain) {
      if (after > longest_chain && (!was_chain || is_new || after > before)) return {};
      continue;
    }
    const bool better = !is_new && !was_chain && std::labs(after - 6) < std::labs(before - 6);
    if ((after < 5 || after > largest_ring) && !better) return {};
    change += squared_defect(after);
  }
  return change;
}

// At a chain of the boundary: a switch, or atoms come or go.
std::optional<NetworkEdit> draw_boundary_edit(const TrivalentNetwork& network, RingIndex chain,
                                              RandomStream& random) {
  std::vector<AtomIndex> atoms;
  atoms_of_ring(network, chain, atoms);
  const AtomIndex atom = atoms[random.below(atoms.size())];
  const unsigned corner = slot_of_ring(network.atoms[atom], chain);
  switch (random.below(5)) {
    case 0:
      return flip_bond(network, atom, static_cast<unsigned>(random.below(3)));
    case 1:
      return close_chain(network, chain, static_cast<std::uint32_t>(5 + random.below(3)));
    case 2:  // one of the rings behind it
      return open_ring(network, network.atoms[atom].ring[(corner + 1 + random.below(2)) % 3]);
    case 3:
      return insert_open_atom(network, atom, (corner + 1) % 3);
    default:
      return remove_open_atom(network, random.below(2) == 0 ? atoms.front() : atoms.back());
  }
}

std::optional<NetworkEdit> draw_any_edit(const TrivalentNetwork& network, RingIndex ring, double climb_share,
                                         RandomStream& random) {
  if (network.rings[ring].boundary) return draw_boundary_edit(network, ring, random);
  std::vector<AtomIndex> atoms;
  atoms_of_ring(network, ring, atoms);
  const std::size_t place = random.below(atoms.size());
  const AtomIndex atom = atoms[place];
  const unsigned corner = slot_of_ring(network.atoms[atom], ring);
  // A ring at the boundary may also lose its open atoms.
  if (network.atoms[atom].neighbour[corner] == no_atom && random.uniform() < 0.5)
    return random.below(2) == 0 ? open_ring(network, ring) : remove_open_atom(network, atom);
  const double kind = random.uniform();
  // The bond of the ring that follows the atom, or the one that leads away from the ring.
  const unsigned slot = random.uniform() < 0.5 ? (corner + 1) % 3 : corner;
  if (kind >= climb_share) return flip_bond(network, atom, slot);
  if (kind < 0.5 * climb_share) return collapse_bond(network, atom, slot);
  // A defect's own ring or the ring across is split: pentagons cannot be.
  const AtomIndex outside = network.atoms[atom].neighbour[corner];
  RingIndex target = ring;
  if (outside != no_atom && random.uniform() < 0.5)
    target = network.atoms[outside].ring[slot_of_neighbour(network.atoms[outside], atom)];
  const std::uint32_t size = network.rings[target].size;
  if (size < 6 || network.rings[target].boundary) return {};
  const auto count = static_cast<unsigned>(3 + random.below(size - 5));
  return split_ring(network, target, static_cast<unsigned>(random.below(size)), count);
}

}  // namespace

std::optional<NetworkEdit> draw_edit(const TrivalentNetwork& network, std::span<const RingIndex> defects,
                                     double climb_share, RandomStream& random, long largest_ring) {
  const RingIndex ring = defects[random.below(defects.size())];
  auto edit = draw_any_edit(network, ring, climb_share, random);
  if (!edit) return {};
  const auto change = defect_change(network, *edit, largest_ring);
  if (!change || *change > 4 || (*change == 4 && random.uniform() > 0.2)) return {};
  return edit;
}

double draw_allowance(const NetworkEdit& edit, const TrialTerms& terms, RandomStream& random) {
  const double above = static_cast<double>(terms.atoms_above_target), gained = edit.atoms_added();
  return -terms.temperature * std::log(std::max(random.uniform(), 1e-300)) -
         terms.count_penalty * ((above + gained) * (above + gained) - above * above);
}

Trial try_edit(const SwitchingState& state, NetworkEdit edit, double allowance, double least_cosine,
               TrialWorkspace& workspace) {
  Trial trial;
  const bool screened = edit.kind != NetworkEdit::Kind::collapse && edit.kind != NetworkEdit::Kind::split;
  if (screened) {
    SwitchingPatch& patch = workspace.near;
    patch.gather(state, edit, screen_radius);
    const double before = patch.energy();
    const double allowed =
        allowance + edit.atoms_added() * before / static_cast<double>(patch.energy_atoms());
    patch.apply(edit);
    patch.relax_springs(6);
    // What is still far above after a few steps never comes down.
    const auto far_above = [&](int iteration, double energy, std::span<const Vec3>) {
      return energy > before + allowed + (iteration < 3 ? 8 : iteration < 5 ? 4.5 : 2.8);
    };
    const minimisation::LbfgsResult relaxed =
        patch.relax({.max_iterations = 8, .force_tolerance = 0.02, .max_step = 0.2, .stop = far_above});
    if (!(relaxed.energy - before < allowed + screen_margin)) return trial;
  }
  SwitchingPatch& patch = workspace.far;
  patch.gather(state, edit, radius);
  const double before = patch.energy();
  if (edit.atoms_added() != 0)
    allowance += edit.atoms_added() * before / static_cast<double>(patch.energy_atoms());
  patch.apply(edit);
  if (screened)
    patch.take_positions(workspace.near);
  else
    patch.relax_springs(10);
  double previous = 1e300;
  const auto hopeless = [&](int iteration, double energy, std::span<const Vec3>) {
    if (iteration % 5 != 0) return false;
    const double gain = previous - energy;
    previous = energy;
    return energy - 3 * gain > before + allowance;
  };
  const minimisation::LbfgsResult relaxed =
      patch.relax({.max_iterations = 40, .force_tolerance = 0.02, .max_step = 0.15, .stop = hopeless});
  trial.energy_change = relaxed.energy - before;
  trial.accepted = trial.energy_change <= allowance && patch.unfolded(least_cosine);
  if (!trial.accepted) return trial;
  for (std::size_t k = 0; k < patch.size(); ++k) {
    trial.looked.push_back(patch.atom(k));
    if (k >= patch.free_count()) continue;
    trial.moved.push_back(patch.atom(k));
    trial.positions.push_back(patch.position(k));
    trial.planes.push_back(patch.plane(k));
    trial.edges.push_back(patch.edge(k));
  }
  trial.edit = std::move(edit);
  return trial;
}

}  // namespace nanocarbon::annealing
