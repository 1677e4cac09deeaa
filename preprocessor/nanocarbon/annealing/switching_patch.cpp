// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/switching_patch.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "nanocarbon/annealing/network_springs.h"

namespace nanocarbon::annealing {

namespace {

// The energy of a bond depends on its atoms' neighbours: what free atoms change reaches this many bonds
// further.
constexpr unsigned halo = 3;

}  // namespace

AtomIndex SwitchingPatch::local(AtomIndex global) const {
  if (global == no_atom) return no_atom;
  if (is_added_atom(global)) return static_cast<AtomIndex>(free_ - added_ + (global - added_atoms.front()));
  return local_of_[global];
}

void SwitchingPatch::gather(const SwitchingState& state, const NetworkEdit& edit, unsigned radius) {
  const TrivalentNetwork& network = state.network;
  local_of_.resize(network.atoms.size(), no_atom);
  for (const AtomIndex a : global_)  // what the gather before this one left
    if (a < local_of_.size()) local_of_[a] = no_atom;
  global_.clear();
  distance_.clear();
  radius_ = radius;
  tether_ = state.tether;
  mean_height_ = state.mean_height;
  reach_ = state.reach;
  space_ = state.space;
  graph_.hydrogen = network.hydrogen;
  graph_.steric_reach = network.steric_reach;
  added_ = static_cast<std::size_t>(edit.added);
  positions_.clear();
  // Beside the atom that it is taken after.
  const auto take = [&](AtomIndex a, unsigned distance, std::size_t after) {
    if (a == no_atom || local_of_[a] != no_atom) return;
    local_of_[a] = static_cast<AtomIndex>(global_.size());
    global_.push_back(a);
    distance_.push_back(distance);
    positions_.push_back(after < positions_.size() ? space_.beside(state.positions[a], positions_[after])
                                                   : state.positions[a]);
  };
  for (const NetworkEdit::AtomChange& change : edit.atoms)
    if (!is_added_atom(change.atom)) take(change.atom, 0, 0);
  std::size_t at = 0;
  for (unsigned distance = 1; distance <= radius + halo; ++distance) {
    const std::size_t end = global_.size();
    for (; at < end; ++at)
      if (global_[at] < network.atoms.size())
        for (const AtomIndex n : network.atoms[global_[at]].neighbour) take(n, distance, at);
    if (distance != radius) continue;
    free_ = global_.size();
    for (std::size_t k = 0; k < added_; ++k) {
      global_.push_back(added_atoms[k]);
      distance_.push_back(0);
      positions_.push_back(Vec3::Zero());
    }
    free_ += added_;
  }
  atoms_.resize(global_.size());
  shifts_.assign(global_.size(), Vec3::Zero());
  planes_.resize(global_.size());
  edges_.assign(global_.size(), {Vec3::Zero(), Vec3::Zero()});
  for (std::size_t k = 0; k < global_.size(); ++k) {
    const AtomIndex a = global_[k];
    if (is_added_atom(a)) {
      atoms_[k] = {{no_atom, no_atom, no_atom}, {no_atom, no_atom, no_atom}};
      planes_[k] = {Vec3::Zero(), Vec3::Zero()};
      continue;
    }
    atoms_[k] = network.atoms[a];
    for (AtomIndex& n : atoms_[k].neighbour) n = local(n);
    planes_[k] = state.planes[a];
    if (!state.edges.empty()) edges_[k] = state.edges[a];
    if (!space_.periodic()) continue;
    shifts_[k] = positions_[k] - state.positions[a];
    planes_[k].point += shifts_[k];
    edges_[k].point += shifts_[k];
  }
  list_bonds();
  list_contacts(state);
}

void SwitchingPatch::list_bonds() {
  graph_.neighbours.resize(atoms_.size());
  for (std::size_t k = 0; k < atoms_.size(); ++k)
    graph_.neighbours[k] = atoms_[k].exists() ? atoms_[k].neighbour : std::array{no_atom, no_atom, no_atom};
  // Atoms come in order of distance, and the last shell only lends its positions.
  graph_.inner = static_cast<std::size_t>(std::find(distance_.begin(), distance_.end(), radius_ + halo) -
                                          distance_.begin());
  graph_.space = has_bonds_to_images() ? space_ : Space();
  rebo2_.set_graph(graph_);
}

// As where the patch reaches round the cell.
bool SwitchingPatch::has_bonds_to_images() const {
  if (!space_.periodic()) return false;
  for (std::size_t k = 0; k < graph_.inner_count(); ++k)
    for (const AtomIndex n : graph_.neighbours[k])
      if (n != no_atom && !space_.is_nearest(positions_[k], positions_[n])) return true;
  return false;
}

void SwitchingPatch::list_contacts(const SwitchingState& state) {
  contacts_.clear();
  for (std::uint32_t k = 0; k < free_; ++k) {
    if (global_[k] >= state.positions.size()) continue;
    for (const AtomIndex other : state.contacts.near(global_[k])) {
      if (other >= state.network.atoms.size() || !state.network.atoms[other].exists()) continue;
      const AtomIndex other_local = local_of_[other];
      const bool both_free = other_local < free_;
      if (both_free && other_local < k) continue;
      // Atoms that are near each other stay so: the image is the same for all of a relaxation.
      const Vec3 there =
          space_.beside(both_free ? positions_[other_local] : state.positions[other], positions_[k]);
      contacts_.push_back(
          {k, both_free ? Vec3(there - positions_[other_local]) : there, both_free ? other_local : no_atom});
    }
  }
}

void SwitchingPatch::take_positions(const SwitchingPatch& smaller) {
  for (std::size_t k = 0; k < smaller.free_; ++k)
    positions_[local(smaller.global_[k])] = smaller.positions_[k];
}

void SwitchingPatch::apply(const NetworkEdit& edit) {
  for (const auto& [atom, record] : edit.atoms) {
    TrivalentAtom& changed = atoms_[local(atom)];
    changed = record;
    for (AtomIndex& n : changed.neighbour) n = local(n);
  }
  switch (edit.kind) {
    case NetworkEdit::Kind::flip:
      place_flipped(local(edit.centre[0]), local(edit.centre[1]));
      break;
    case NetworkEdit::Kind::split:
      place_added(local(edit.centre[0]), local(edit.centre[1]));
      break;
    case NetworkEdit::Kind::insert:
    case NetworkEdit::Kind::close:
      place_outside(edit.polygon);
      break;
    default:  // nothing is new
      break;
  }
  list_bonds();
}

void SwitchingPatch::place_flipped(AtomIndex i, AtomIndex j) {
  const auto outer = [&](AtomIndex a, AtomIndex other) {
    Vec3 sum = Vec3::Zero();
    double count = 0;
    for (const AtomIndex n : atoms_[a].neighbour)
      if (n != other && n != no_atom) {
        sum += graph_.space.beside(positions_[n], positions_[i]);
        ++count;
      }
    return Vec3(sum / count);  // an open atom still has one
  };
  const Vec3 centre = 0.5 * (positions_[i] + graph_.space.beside(positions_[j], positions_[i]));
  const Vec3 direction = (outer(i, j) - outer(j, i)).normalized();
  positions_[i] = centre + 0.5 * bond_rest_length * direction;
  // Beside where it was, as its plane is.
  positions_[j] = graph_.space.beside(centre - 0.5 * bond_rest_length * direction, positions_[j]);
}

void SwitchingPatch::place_added(AtomIndex u, AtomIndex w) {
  const auto between = [&](AtomIndex a, AtomIndex other, std::vector<AtomIndex>& ends) {
    Vec3 sum = Vec3::Zero();
    for (const AtomIndex n : atoms_[a].neighbour)
      if (n != other) {
        ends.push_back(n);
        sum += 0.5 * graph_.space.beside(positions_[n], positions_[ends.front()]);
      }
    return sum;
  };
  std::vector<AtomIndex> ends;
  positions_[u] = between(u, w, ends);
  const Vec3 other_side = between(w, u, ends);  // beside ends[0]
  positions_[w] = graph_.space.beside(other_side, positions_[ends[2]]);
  planes_[u] = planes_[ends[0]];
  planes_[w] = planes_[ends[2]];
  edges_[u] = edges_[ends[0]];
  edges_[w] = edges_[ends[2]];
  const Vec3 apart = graph_.space.displacement(positions_[u], positions_[w]);
  const double length = apart.norm();
  if (length > bond_rest_length) {
    const Vec3 inward = 0.5 * (length - bond_rest_length) / length * apart;
    positions_[u] += 0.5 * inward;
    positions_[w] -= 0.5 * inward;
  }
}

void SwitchingPatch::place_outside(std::uint32_t polygon) {
  const auto first = static_cast<AtomIndex>(free_ - added_), last = static_cast<AtomIndex>(free_ - 1);
  const auto held = [&](AtomIndex n) { return n != no_atom && (n < first || n > last); };
  const AtomIndex start = atoms_[first].neighbour[2];
  AtomIndex end = no_atom;
  for (const AtomIndex n : atoms_[last].neighbour)
    if (held(n) && n != start) end = n;
  const Vec3 from = positions_[start], chord = graph_.space.displacement(from, positions_[end]);
  const Vec3 middle = from + 0.5 * chord, along = chord.normalized();
  // The sheet goes on away from what else the two are bonded to.
  Vec3 outward = Vec3::Zero();
  for (const AtomIndex a : {start, end})
    for (const AtomIndex n : atoms_[a].neighbour)
      if (held(n) && n != start && n != end)
        outward += (middle - graph_.space.beside(positions_[n], middle)).normalized();
  outward = (outward - outward.dot(along) * along).normalized();
  const double steps = static_cast<double>(added_) + 1, half_arc = steps * std::numbers::pi / polygon;
  const double radius = 0.5 * bond_rest_length / std::sin(std::numbers::pi / polygon);
  const Vec3 centre = middle - radius * std::cos(half_arc) * outward;
  for (std::size_t k = 0; k < added_; ++k) {
    const double angle = half_arc * (2 * (static_cast<double>(k) + 1) / steps - 1);
    positions_[first + k] = centre + radius * (std::cos(angle) * outward + std::sin(angle) * along);
    planes_[first + k] = planes_[2 * k < added_ ? start : end];
    edges_[first + k] = edges_[2 * k < added_ ? start : end];
  }
}

double SwitchingPatch::energy_and_gradient(std::span<const Vec3> free, std::span<Vec3> gradient) {
  std::copy(free.begin(), free.end(), positions_.begin());
  gradient_.assign(positions_.size(), Vec3::Zero());
  double energy = rebo2_.evaluate_guarded(positions_, gradient_);
  for (std::size_t k = 0; k < free_; ++k) {
    if (!atoms_[k].exists()) continue;
    const double height = height_above(planes_[k], positions_[k]) - mean_height_;
    gradient_[k] += tether_ * height * planes_[k].normal;
    energy += 0.5 * tether_ * height * height;
  }
  energy += add_boundary_tether(edges_, graph_, reach_, positions_, gradient_);
  for (const Contact& contact : contacts_) {
    if (!atoms_[contact.local].exists()) continue;
    const bool both_free = contact.other_local != no_atom;
    if (both_free && !atoms_[contact.other_local].exists()) continue;
    Vec3 at_own = Vec3::Zero();
    energy += steric_pair(positions_[contact.local],
                          both_free ? Vec3(positions_[contact.other_local] + contact.other) : contact.other,
                          graph_.steric_reach, at_own);
    gradient_[contact.local] += at_own;
    if (both_free) gradient_[contact.other_local] -= at_own;
  }
  for (std::size_t k = 0; k < free_; ++k) gradient[k] += gradient_[k];
  return energy;
}

double SwitchingPatch::energy() {
  const std::vector<Vec3> free(positions_.begin(), positions_.begin() + static_cast<std::ptrdiff_t>(free_));
  std::vector<Vec3> unused(free_, Vec3::Zero());
  return energy_and_gradient(free, unused);
}

std::size_t SwitchingPatch::energy_atoms() const {
  std::size_t count = 0;
  for (std::size_t k = 0; k < graph_.inner_count(); ++k) count += atoms_[k].exists() ? 1 : 0;
  return count;
}

void SwitchingPatch::relax_springs(int iterations) {
  std::vector<Vec3> free(positions_.begin(), positions_.begin() + static_cast<std::ptrdiff_t>(free_));
  const auto energy = [&](std::span<const Vec3> x, std::span<Vec3> g) {
    std::copy(x.begin(), x.end(), positions_.begin());
    gradient_.assign(positions_.size(), Vec3::Zero());
    const double sum = add_springs(graph_, positions_, gradient_);
    for (std::size_t k = 0; k < free_; ++k) g[k] += gradient_[k];
    return sum;
  };
  minimisation::minimise_lbfgs(free, energy,
                               {.max_iterations = iterations, .force_tolerance = 0.1, .max_step = 0.2});
  std::copy(free.begin(), free.end(), positions_.begin());
}

minimisation::LbfgsResult SwitchingPatch::relax(const minimisation::LbfgsOptions& options) {
  std::vector<Vec3> free(positions_.begin(), positions_.begin() + static_cast<std::ptrdiff_t>(free_));
  const auto energy = [&](std::span<const Vec3> x, std::span<Vec3> g) { return energy_and_gradient(x, g); };
  const minimisation::LbfgsResult result = minimisation::minimise_lbfgs(free, energy, options);
  std::copy(free.begin(), free.end(), positions_.begin());
  return result;
}

bool SwitchingPatch::unfolded(double least_cosine) const {
  for (std::size_t k = 0; k < free_; ++k) {
    const auto& n = atoms_[k].neighbour;
    if (!atoms_[k].exists() || n[0] == no_atom || n[1] == no_atom || n[2] == no_atom) continue;
    const Vec3 normal = graph_.space.displacement(positions_[n[0]], positions_[n[1]])
                            .cross(graph_.space.displacement(positions_[n[0]], positions_[n[2]]));
    if (normal.dot(planes_[k].normal) < least_cosine * normal.norm()) return false;
  }
  return true;
}

}  // namespace nanocarbon::annealing
