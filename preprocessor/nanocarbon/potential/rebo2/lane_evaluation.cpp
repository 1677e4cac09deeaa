// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/rebo2/lane_evaluation.h"

#include <algorithm>

#include "nanocarbon/potential/rebo2/lane_constants.h"
#include "nanocarbon/potential/rebo2/switching.h"

namespace nanocarbon::rebo2 {

using potential::AtomsView;

namespace {

// Half-edges that were good for fewer steps than this cost more than they saved,
constexpr int least_good_steps = 3;
constexpr int most_bad_memories = 2;
// as do those of which more than this share belong to restless nodes.
constexpr double most_restless = 0.75;

//! Whether a table is other than zero around a place.
bool is_used(const double (*table)[4], int place_i, int place_j) {
  for (int i = place_i / 2; i <= (place_i + 1) / 2; ++i)
    for (int j = place_j / 2; j <= (place_j + 1) / 2; ++j)
      for (int k = 0; k < 9; ++k)
        for (int piece = 0; piece < 4; ++piece)
          if (table[(i * 5 + j) * 9 + k][piece] != 0.0) return true;
  return false;
}

}  // namespace

LaneEvaluation::LaneEvaluation(const Rebo2Parameters& parameters, const LaneLoops& loops,
                               const std::optional<TorsionBarriers>& torsion)
    : constants_(make_lane_constants(parameters, torsion)),
      loops_(loops),
      conjugation_begin_(parameters.conjugation_begin),
      conjugation_end_(parameters.conjugation_end),
      nodes_(parameters, constants_, loops) {
  for (int pair = 0; pair < 3; ++pair)
    for (int i = 0; i < 9; ++i)
      for (int j = 0; j < 9; ++j) has_terms_[pair][i][j] = is_used(constants_.f[pair], i, j);
  for (int i = 0; i < 9; ++i)
    for (int j = 0; j < 9; ++j) {
      has_dihedrals_[i][j] = torsion || is_used(constants_.t, i, j);
      has_terms_[0][i][j] |= has_dihedrals_[i][j];
    }
}

void LaneEvaluation::sort_centres(std::uint32_t own) {
  steady_centre_batches_.clear();
  restless_centres_.clear();
  for (std::uint32_t i = 0; i < own; ++i) {
    const LaneNode& node = nodes_.nodes()[i];
    if (node.first == node.end()) continue;
    if (!nodes_.is_steady(i)) {
      restless_centres_.push_back(i);
      continue;
    }
    steady_centre_batches_.add({.hydrogen = nodes_.is_hydrogen(i),
                                .carbons = static_cast<int>(node.carbons),
                                .hydrogens = static_cast<int>(node.hydrogens),
                                .whole = true,
                                .first = nullptr,
                                .count = 0},
                               node.first);
  }
  steady_centre_batches_.finish();
}

// By the bonds that they have now.
void LaneEvaluation::sort_restless_centres() {
  restless_centre_batches_.clear();
  for (const std::uint32_t i : restless_centres_) {
    const LaneNode& node = nodes_.nodes()[i];
    const std::uint32_t bonds = node.bonded_carbons + node.bonded_hydrogens;
    bool whole = nodes_.whole_place(i) >= 0;
    for (std::uint32_t e = node.first; e < node.first + bonds; ++e) whole &= nodes_.weight(e) == 1.0;
    for (std::uint32_t e = node.first + bonds; e < node.end(); ++e)
      std::fill_n(nodes_.gradient().begin() + 4 * std::ptrdiff_t{e}, 4, 0.0);
    if (bonds == 0) continue;
    restless_centre_batches_.add({.hydrogen = nodes_.is_hydrogen(i),
                                  .carbons = static_cast<int>(node.bonded_carbons),
                                  .hydrogens = static_cast<int>(node.bonded_hydrogens),
                                  .whole = whole,
                                  .first = nullptr,
                                  .count = 0},
                                 node.first);
  }
  restless_centre_batches_.finish();
}

void LaneEvaluation::find_conjugation(LaneNode& node) {
  const std::uint32_t place = nodes_.place(node.atom);
  if (is_conjugated_[place]) return;
  is_conjugated_[place] = 1;
  double sum = 0.0;
  std::uint32_t e = node.first;
  for (; e < node.first + node.carbons; ++e) {
    const double weight = nodes_.weight(e);
    const double n = nodes_.coordination(nodes_.to(e)) - weight;
    ValueSlope f = {0.0, 0.0};
    if (n < conjugation_end_) f = cosine_switch(n, conjugation_begin_, conjugation_end_);
    conjugation_[e] = {f.value, f.slope, 0.0, 0.0};
    sum += weight * f.value;
  }
  for (; e < node.end(); ++e) conjugation_[e] = {};
  node.conjugation_sum = sum;
}

void LaneEvaluation::add_bond(const Selected& selected, std::uint32_t own, LaneBondBatches& to) {
  const std::uint32_t edge = selected.edge;
  LaneNode& i = nodes_.of(nodes_.from(edge));
  LaneNode& j = nodes_.of(nodes_.to(edge));
  find_conjugation(i);
  find_conjugation(j);
  std::array<std::uint32_t, std::size_t{2} * lane_most_bonds> arms;
  LaneBondTerms bond = {.edge = edge,
                        .reverse = nodes_.edge_to(j, i.atom),
                        .pair = nodes_.pair(edge),
                        .dihedrals = selected.dihedrals,
                        .triangles = false,
                        .arms_i = 0,
                        .arms_j = 0,
                        .arms = {},
                        .numbers = {}};
  if (selected.dihedrals) {
    std::uint32_t* arm = arms.data();
    for (std::uint32_t e = i.first; e < i.end(); ++e) {
      if (e == edge || nodes_.is_beyond(e)) continue;
      *arm++ = e;
      ++bond.arms_i;
    }
    for (std::uint32_t e = j.first; e < j.end(); ++e) {
      if (e == bond.reverse || nodes_.is_beyond(e)) continue;
      for (std::uint32_t a = 0; a < bond.arms_i; ++a) bond.triangles |= nodes_.to(e) == nodes_.to(arms[a]);
      *arm++ = e;
      ++bond.arms_j;
    }
    bond.arms = {arms.data(), std::size_t{bond.arms_i} + bond.arms_j};
  }
  const double weight = nodes_.weight(edge);
  const auto unsaturated = [&](std::uint32_t e) { return nodes_.weight(e) * conjugation_[e].unsaturation; };
  bond.numbers[lane_n_i] = nodes_.coordination(i.atom) - weight;
  bond.numbers[lane_n_j] = nodes_.coordination(j.atom) - weight;
  bond.numbers[lane_sum_i] = i.conjugation_sum - unsaturated(edge);
  bond.numbers[lane_sum_j] = j.conjugation_sum - unsaturated(bond.reverse);
  bond.numbers[lane_share] = j.atom < own ? 1.0 : 0.5;
  to.add(bond);
}

// Of N_conj, which is of carbons alone.
bool LaneEvaluation::has_steady_neighbours(const LaneNode& node) const {
  bool steady = true;
  for (std::uint32_t e = node.first; e < node.first + node.carbons; ++e)
    steady &= nodes_.is_steady(nodes_.to(e));
  return steady;
}

// Which bonds have terms as a whole, and which may come to have them; false as of evaluate().
bool LaneEvaluation::find_terms(std::uint32_t own) {
  steady_batches_.clear();
  selected_.clear();
  restless_bonds_.clear();
  for (std::uint32_t i = 0; i < own; ++i) {
    const LaneNode& node = nodes_.nodes()[i];
    for (std::uint32_t e = node.first; e < node.end(); ++e) {
      const std::uint32_t j = nodes_.to(e);
      if (j < i) continue;
      if (!nodes_.is_steady(i) || !nodes_.is_steady(j)) {
        restless_bonds_.push_back(e);
        continue;
      }
      const int at_i = nodes_.whole_place(i), at_j = nodes_.whole_place(j);
      const std::uint32_t pair = nodes_.pair(e);
      if (has_terms_[pair][at_i][at_j]) selected_.push_back({e, pair == 0 && has_dihedrals_[at_i][at_j]});
    }
  }
  if (!find_neighbours_of_copies(own)) return false;
  is_conjugated_.assign(nodes_.nodes().size(), 0);
  for (const Selected& bond : selected_) {
    if (has_steady_neighbours(nodes_.of(nodes_.from(bond.edge))) &&
        has_steady_neighbours(nodes_.of(nodes_.to(bond.edge))))
      add_bond(bond, own, steady_batches_);
    else
      restless_bonds_.push_back(bond.edge);
  }
  steady_batches_.keep_numbers();
  return true;
}

// N_conj needs the coordination of all neighbours of both ends; false as of evaluate().
bool LaneEvaluation::find_neighbours_of_copies(std::uint32_t own) {
  const auto known = static_cast<std::uint32_t>(nodes_.nodes().size());
  const auto measured = static_cast<std::uint32_t>(nodes_.edge_count());
  bool few = true;
  const auto add_neighbours = [&](std::uint32_t edge) {
    const std::uint32_t j = nodes_.to(edge);
    if (j < own) return;
    const LaneNode at_j = nodes_.of(j);
    for (std::uint32_t e = at_j.first; e < at_j.end(); ++e) few &= nodes_.add(nodes_.to(e));
  };
  for (const Selected& bond : selected_) add_neighbours(bond.edge);
  for (const std::uint32_t bond : restless_bonds_) add_neighbours(bond);
  if (!few) return false;
  nodes_.measure_from(known, measured);
  const std::size_t edges = nodes_.edge_count();
  if (conjugation_.size() < edges) conjugation_.resize(edges + edges / 4);
  return true;
}

// Where its ends' coordination numbers without it are in the tables; negative where it is no bond.
std::array<int, 2> LaneEvaluation::places_in_tables(std::uint32_t e) const {
  const double weight = nodes_.weight(e);
  if (weight <= negligible) return {-1, -1};
  const std::uint32_t i = nodes_.from(e), j = nodes_.to(e);
  const int at_i = nodes_.whole_place(i), at_j = nodes_.whole_place(j);
  if ((at_i | at_j) >= 0) return {at_i, at_j};
  return {table_place(nodes_.coordination(i) - weight), table_place(nodes_.coordination(j) - weight)};
}

bool LaneEvaluation::may_have_terms(std::uint32_t e) const {
  const auto [at_i, at_j] = places_in_tables(e);
  return at_i >= 0 && has_terms_[nodes_.pair(e)][at_i][at_j];
}

void LaneEvaluation::select_restless(std::uint32_t own) {
  restless_batches_.clear();
  if (restless_bonds_.empty()) return;
  is_conjugated_.assign(nodes_.nodes().size(), 0);
  for (const std::uint32_t e : restless_bonds_) {
    const auto [at_i, at_j] = places_in_tables(e);
    if (at_i < 0) continue;
    const std::uint32_t pair = nodes_.pair(e);
    if (has_terms_[pair][at_i][at_j])
      add_bond({e, pair == 0 && has_dihedrals_[at_i][at_j]}, own, restless_batches_);
  }
}

// Finds half-edges, and what can be kept with them; false as of evaluate().
bool LaneEvaluation::find_and_remember(std::uint32_t own) {
  if (!nodes_.find(own, true)) return false;
  remembers_ = nodes_.restless(own) <= most_restless * own;
  if (!remembers_) return true;
  if (!find_terms(own)) return false;
  sort_centres(own);
  nodes_.remember();
  return true;
}

// Half-edges for this step alone: all atoms and bonds are as restless ones.
bool LaneEvaluation::find_for_once(std::uint32_t own) {
  if (!nodes_.find(own, false)) return false;
  steady_batches_.clear();
  steady_centre_batches_.clear();
  restless_centres_.clear();
  selected_.clear();
  restless_bonds_.clear();
  for (std::uint32_t i = 0; i < own; ++i) {
    const LaneNode& node = nodes_.nodes()[i];
    if (node.first != node.end()) restless_centres_.push_back(i);
    for (std::uint32_t e = node.first; e < node.end(); ++e)
      if (nodes_.to(e) > i && may_have_terms(e)) restless_bonds_.push_back(e);
  }
  return find_neighbours_of_copies(own);
}

// Everything that is known of the bonds before the loops run; false as of evaluate().
bool LaneEvaluation::arrange(std::uint32_t own) {
  if (nodes_.same_as_remembered()) {
    ++remembered_steps_;
    ++good_steps_;
    steady_batches_.restore_numbers();
  } else {
    if (remembers_ && good_steps_ < least_good_steps) ++bad_memories_;
    good_steps_ = 0;
    remembers_ = bad_memories_ < most_bad_memories;
    if (remembers_ && !find_and_remember(own)) return false;
    if (!remembers_) {
      bad_memories_ = most_bad_memories;
      if (!find_for_once(own)) return false;
    }
  }
  sort_restless_centres();
  select_restless(own);
  return true;
}

void LaneEvaluation::differentiate(LaneNode& node) {
  const std::uint32_t place = nodes_.place(node.atom);
  if (is_differentiated_[place]) return;
  is_differentiated_[place] = 1;
  differentiated_.push_back(place);
  node.by_coordination = node.by_conjugation_sum = 0.0;
  if (is_conjugated_[place]) return;
  is_conjugated_[place] = 1;
  for (std::uint32_t e = node.first; e < node.end(); ++e) conjugation_[e] = {};
}

void LaneEvaluation::gather_derivatives(const LaneBondBatch& batch) {
  for (std::size_t b = 0; b < batch.bonds.count; ++b) {
    const double* numbers =
        batch.numbers.data() + (b / lane_block * lane_pieces) * lane_block + b % lane_block;
    const auto add = [&](std::uint32_t edge, LaneBondPiece coordination, LaneBondPiece sum) {
      const double by_coordination = numbers[coordination * lane_block], by_sum = numbers[sum * lane_block];
      if (by_coordination == 0.0 && by_sum == 0.0) return;
      LaneNode& node = nodes_.of(nodes_.from(edge));
      differentiate(node);
      node.by_coordination += by_coordination;
      node.by_conjugation_sum += by_sum;
      conjugation_[edge].by_coordination += by_coordination;
      conjugation_[edge].by_sum += by_sum;
    };
    add(batch.edges[b], lane_n_i, lane_sum_i);
    add(batch.reverses[b], lane_n_j, lane_sum_j);
  }
}

void LaneEvaluation::add_derivatives_by_weight() {
  is_differentiated_.assign(nodes_.nodes().size(), 0);
  differentiated_.clear();
  restless_batches_.for_each([&](const LaneBondBatch& batch) { gather_derivatives(batch); });
  // First what N_conj passes on to the neighbours' coordination, then all coordinations.
  for (std::size_t n = 0, ends = differentiated_.size(); n < ends; ++n) {
    const LaneNode node = nodes_.nodes()[differentiated_[n]];
    for (std::uint32_t e = node.first; e < node.first + node.carbons; ++e) {
      const double by_sum = node.by_conjugation_sum - conjugation_[e].by_sum;
      if (by_sum == 0.0 || conjugation_[e].slope == 0.0) continue;
      const double by_coordination = by_sum * nodes_.weight(e) * conjugation_[e].slope;
      LaneNode& next = nodes_.of(nodes_.to(e));
      differentiate(next);
      next.by_coordination += by_coordination;
      conjugation_[nodes_.edge_to(next, node.atom)].by_coordination += by_coordination;
    }
  }
  for (const std::uint32_t place : differentiated_) {
    const LaneNode& node = nodes_.nodes()[place];
    if (nodes_.whole_place(node.atom) >= 0) continue;
    for (std::uint32_t e = node.first; e < node.end(); ++e) {
      const double weight_slope = nodes_.weight_slope(e);
      if (weight_slope == 0.0) continue;
      const Conjugation& c = conjugation_[e];
      const double by_weight =
          node.by_coordination - c.by_coordination + (node.by_conjugation_sum - c.by_sum) * c.unsaturation;
      nodes_.gradient()[4 * std::size_t{e} + 3] += by_weight * weight_slope;
    }
  }
}

std::optional<EnergyParts> LaneEvaluation::evaluate(const AtomsView& atoms, double* forces,
                                                    double* atom_energies) {
  nodes_.take_positions(atoms);
  if (!arrange(atoms.own)) return {};
  const std::size_t own_edges = atoms.own > 0 ? nodes_.nodes()[atoms.own - 1].end() : 0;
  energies_.assign(atom_energies ? nodes_.edge_count() : 0, 0.0);
  const LaneEdges edges = nodes_.edges(atom_energies ? energies_.data() : nullptr);
  LaneEnergy energy = {};
  const auto run_centres = [&](const LaneCentres& centres) { loops_.centres(edges, centres, &energy); };
  steady_centre_batches_.for_each(run_centres);
  restless_centre_batches_.for_each(run_centres);
  std::size_t pulled = own_edges;
  if (!steady_batches_.empty() || !restless_batches_.empty()) {
    pulled = nodes_.edge_count();
    std::fill(edges.gradient + 4 * own_edges, edges.gradient + 4 * pulled, 0.0);
    const auto run = [&](const LaneBondBatch& batch) { loops_.bonds(edges, batch.bonds, &energy); };
    steady_batches_.for_each(run);
    restless_batches_.for_each(run);
    add_derivatives_by_weight();
  }
  forces_.resize(4 * std::size_t{atoms.all}, 0.0);  // zeros are left behind
  loops_.pull(edges, pulled, forces_.data());
  for (std::size_t i = 0; i < atoms.all; ++i)
    for (int d = 0; d < 3; ++d) {
      forces[3 * i + d] += forces_[4 * i + d];
      forces_[4 * i + d] = 0.0;
    }
  if (atom_energies)
    for (std::uint32_t e = 0; e < own_edges; ++e) {
      atom_energies[nodes_.from(e)] += 0.5 * energies_[e];
      atom_energies[nodes_.to(e)] += 0.5 * energies_[e];
    }
  return EnergyParts{energy.repulsive, energy.sigma_pi, energy.conjugation, energy.dihedral, energy.torsion};
}

std::size_t LaneEvaluation::memory() const {
  return nodes_.memory() + sizeof(Conjugation) * conjugation_.capacity() +
         sizeof(double) * (forces_.capacity() + energies_.capacity());
}

}  // namespace nanocarbon::rebo2
