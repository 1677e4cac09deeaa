// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/rebo2/lane_evaluation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "nanocarbon/potential/rebo2/lane_constants.h"
#include "nanocarbon/potential/rebo2/switching.h"

namespace nanocarbon::rebo2 {

using potential::AtomsView;
using potential::NearPairs;

namespace {

constexpr std::uint32_t absent = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint32_t counts = lane_most_bonds + 1;  // of bonds to one element

//! Even at a whole number, odd between two; the tables end at 4.
int table_place(double n) {
  if (n >= 4.0) return 8;
  if (!(n > 0.0)) return 0;
  const int below = static_cast<int>(n);
  return 2 * below + (n != below);
}

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
      conjugation_end_(parameters.conjugation_end) {
  for (int pair = 0; pair < 3; ++pair) {
    squared_cutoffs_[pair] = parameters.pairs[pair].cutoff_end * parameters.pairs[pair].cutoff_end;
    for (int i = 0; i < 9; ++i)
      for (int j = 0; j < 9; ++j) has_terms_[pair][i][j] = is_used(constants_.f[pair], i, j);
  }
  for (int i = 0; i < 9; ++i)
    for (int j = 0; j < 9; ++j) {
      has_dihedrals_[i][j] = torsion || is_used(constants_.t, i, j);
      has_terms_[0][i][j] |= has_dihedrals_[i][j];
    }
  centre_batches_.resize(std::size_t{4} * counts * counts);
  bond_batches_.resize(3 + std::size_t{2} * counts * counts);
}

void LaneEvaluation::near_changed(const AtomsView& atoms, const NearPairs& near) {
  near_.offsets = near.offsets;
  near_.atoms.resize(near.atoms.size());
  near_hydrogens_.resize(atoms.all);
  for (std::uint32_t i = 0; i < atoms.all; ++i) {
    std::uint32_t* to = near_.atoms.data() + near.offsets[i];
    for (const std::uint32_t j : near.of(i))
      if (atoms.elements[j] == Element::carbon) *to++ = j;
    near_hydrogens_[i] = static_cast<std::uint32_t>(to - near_.atoms.data());
    for (const std::uint32_t j : near.of(i))
      if (atoms.elements[j] == Element::hydrogen) *to++ = j;
  }
  // No more half-edges than near pairs, and a block beyond them.
  const std::size_t most = near.atoms.size() + lane_block;
  for (auto* list : {&from_, &to_, &pair_}) list->resize(most);
  place_.assign(atoms.all, absent);
  coordination_.resize(atoms.all);
  whole_place_.resize(atoms.all);
  nodes_.clear();
}

bool LaneEvaluation::add_node(std::uint32_t atom) {
  if (place_[atom] != absent) return true;
  place_[atom] = static_cast<std::uint32_t>(nodes_.size());
  const double* from = positions_.data() + 4 * std::size_t{atom};
  const double x = from[0], y = from[1], z = from[2];
  const auto first = static_cast<std::uint32_t>(edge_count_);
  std::uint32_t n = first;
  const std::uint32_t element = static_cast<std::uint32_t>(elements_[atom]);
  const auto take = [&](std::uint32_t begin, std::uint32_t end, std::uint32_t pair) {
    const double cutoff = squared_cutoffs_[pair];
    const std::uint32_t before = n;
    for (std::uint32_t k = begin; k < end; ++k) {
      const std::uint32_t j = near_.atoms[k];
      const double* to = positions_.data() + 4 * std::size_t{j};
      const double a = to[0] - x, b = to[1] - y, c = to[2] - z;
      to_[n] = j;
      n += a * a + b * b + c * c < cutoff;
    }
    for (std::uint32_t e = before; e < n; ++e) {
      from_[e] = atom;
      pair_[e] = pair;
    }
  };
  take(near_.offsets[atom], near_hydrogens_[atom], element);
  const std::uint32_t hydrogens = n;
  take(near_hydrogens_[atom], near_.offsets[atom + 1], element + 1);
  nodes_.push_back({.atom = atom, .first = first, .carbons = hydrogens - first, .hydrogens = n - hydrogens});
  edge_count_ = n;
  return n - first <= static_cast<std::uint32_t>(lane_most_bonds);
}

void LaneEvaluation::measure_from(std::uint32_t node, std::uint32_t edge) {
  if (edge_count_ == 0) return;
  for (std::size_t n = 0; n < lane_block; ++n) {
    from_[edge_count_ + n] = from_[edge_count_ - 1];
    to_[edge_count_ + n] = to_[edge_count_ - 1];
    pair_[edge_count_ + n] = pair_[edge_count_ - 1];
  }
  const std::size_t records = 4 * (edge_count_ + lane_block);
  for (auto* array : {&geometry_, &weights_, &gradient_})
    if (array->size() < records) array->resize(records + records / 4);
  loops_.measure(edges(), edge, edge_count_);
  for (; node < nodes_.size(); ++node) {
    const Node& at = nodes_[node];
    double sum = 0.0;
    bool whole = true;
    for (std::size_t e = at.first; e < at.end(); ++e) {
      sum += weights_[4 * e];
      whole &= weights_[4 * e + 1] == 0.0;
    }
    coordination_[at.atom] = sum;
    whole_place_[at.atom] = whole ? static_cast<std::int8_t>(table_place(sum - 1.0)) : std::int8_t{-1};
  }
}

LaneEdges LaneEvaluation::edges() {
  return {&constants_,     positions_.data(), from_.data(),
          to_.data(),      pair_.data(),      geometry_.data(),
          weights_.data(), gradient_.data(),  energies_.empty() ? nullptr : energies_.data()};
}

bool LaneEvaluation::find_bonds(const AtomsView& atoms) {
  for (const Node& node : nodes_) place_[node.atom] = absent;
  nodes_.clear();
  edge_count_ = 0;
  bool few = true;
  for (std::uint32_t i = 0; i < atoms.own; ++i) few &= add_node(i);
  for (std::size_t e = 0, end = edge_count_; e < end; ++e)
    if (to_[e] >= atoms.own) few &= add_node(to_[e]);
  measure_from(0, 0);
  return few;
}

void LaneEvaluation::run_centres(std::uint32_t own, LaneEnergy& energy) {
  for (const std::uint32_t used : used_centres_) centre_batches_[used].first.clear();
  used_centres_.clear();
  for (std::uint32_t i = 0; i < own; ++i) {
    const Node& node = nodes_[i];
    const std::uint32_t bonds = node.carbons + node.hydrogens;
    if (bonds == 0) continue;
    const bool hydrogen = elements_[i] == Element::hydrogen;
    const bool whole = whole_place_[i] >= 0;
    const std::uint32_t key = ((2u * hydrogen + whole) * counts + node.carbons) * counts + node.hydrogens;
    CentreBatch& batch = centre_batches_[key];
    if (batch.first.empty()) {
      used_centres_.push_back(key);
      batch.centres = {
          hydrogen, static_cast<int>(node.carbons), static_cast<int>(node.hydrogens), whole, nullptr, 0};
    }
    batch.first.push_back(node.first);
  }
  for (const std::uint32_t used : used_centres_) {
    CentreBatch& batch = centre_batches_[used];
    batch.centres.count = batch.first.size();
    while (batch.first.size() % lane_block != 0) batch.first.push_back(batch.first.back());
    batch.centres.first = batch.first.data();
    loops_.centres(edges(), batch.centres, &energy);
  }
}

std::uint32_t LaneEvaluation::reverse(const Node& of, std::uint32_t to) const {
  std::uint32_t e = of.first;
  while (to_[e] != to) ++e;
  return e;
}

void LaneEvaluation::find_conjugation(Node& node) {
  const std::uint32_t place = place_[node.atom];
  if (is_conjugated_[place]) return;
  is_conjugated_[place] = 1;
  double sum = 0.0;
  std::uint32_t e = node.first;
  for (; e < node.first + node.carbons; ++e) {
    const double weight = weights_[4 * std::size_t{e}];
    const double n = coordination_[to_[e]] - weight;
    ValueSlope f = {0.0, 0.0};
    if (n < conjugation_end_) f = cosine_switch(n, conjugation_begin_, conjugation_end_);
    conjugation_[e] = {f.value, f.slope, 0.0, 0.0};
    sum += weight * f.value;
  }
  for (; e < node.end(); ++e) conjugation_[e] = {};
  node.conjugation_sum = sum;
}

void LaneEvaluation::add_bond(std::uint32_t edge, const Node& i, const Node& j, bool dihedrals,
                              double share) {
  const std::uint32_t back = reverse(j, i.atom);
  std::uint32_t key = pair_[edge];
  std::array<std::uint32_t, std::size_t{2} * lane_most_bonds> arms;
  const std::uint32_t arms_i = i.end() - i.first - 1, arms_j = j.end() - j.first - 1;
  bool triangles = false;
  if (dihedrals) {
    std::uint32_t* arm = arms.data();
    for (std::uint32_t e = i.first; e < i.end(); ++e)
      if (e != edge) *arm++ = e;
    for (std::uint32_t e = j.first; e < j.end(); ++e) {
      if (e == back) continue;
      for (std::uint32_t a = 0; a < arms_i; ++a) triangles |= to_[e] == to_[arms[a]];
      *arm++ = e;
    }
    key = 3 + ((triangles ? counts : 0u) + arms_i) * counts + arms_j;
  }
  BondBatch& batch = bond_batches_[key];
  const std::uint32_t most = dihedrals ? arms_i + arms_j : 0;
  const std::size_t place = batch.bonds.count++;
  const std::size_t block = place / lane_block, lane = place % lane_block;
  if (place == 0) {
    used_bonds_.push_back(key);
    batch.bonds = {.pair = static_cast<int>(pair_[edge]),
                   .dihedrals = dihedrals,
                   .triangles = triangles,
                   .arms_i = dihedrals ? static_cast<int>(arms_i) : 0,
                   .arms_j = dihedrals ? static_cast<int>(arms_j) : 0,
                   .count = 1,
                   .edges = nullptr,
                   .arms = nullptr,
                   .numbers = nullptr};
  }
  if (lane == 0) {
    // Lanes that stay empty repeat this bond, with no share in it.
    batch.edges.resize((block + 1) * lane_block, edge);
    batch.reverses.resize((block + 1) * lane_block, back);
    batch.numbers.resize((block + 1) * lane_pieces * lane_block, 0.0);
    batch.arms.resize((block + 1) * most * lane_block);
    for (std::uint32_t a = 0; a < most; ++a)
      std::fill_n(batch.arms.begin() + static_cast<std::ptrdiff_t>((block * most + a) * lane_block),
                  lane_block, arms[a]);
  }
  batch.edges[place] = edge;
  batch.reverses[place] = back;
  for (std::uint32_t a = 0; a < most; ++a) batch.arms[(block * most + a) * lane_block + lane] = arms[a];
  const auto set = [&](LaneBondPiece piece, double number) {
    batch.numbers[(block * lane_pieces + piece) * lane_block + lane] = number;
  };
  const double weight = weights_[4 * std::size_t{edge}];
  const auto unsaturated = [&](std::uint32_t e) {
    return weights_[4 * std::size_t{e}] * conjugation_[e].unsaturation;
  };
  set(lane_n_i, coordination_[i.atom] - weight);
  set(lane_n_j, coordination_[j.atom] - weight);
  set(lane_sum_i, i.conjugation_sum - unsaturated(edge));
  set(lane_sum_j, j.conjugation_sum - unsaturated(back));
  set(lane_share, share);
}

bool LaneEvaluation::select_bonds(std::uint32_t own) {
  for (const std::uint32_t used : used_bonds_) {
    BondBatch& batch = bond_batches_[used];
    batch.bonds.count = 0;
    batch.edges.clear();
    batch.arms.clear();
    batch.reverses.clear();
    batch.numbers.clear();
  }
  used_bonds_.clear();
  selected_.clear();
  const std::size_t nodes = nodes_.size();
  for (std::uint32_t i = 0; i < own; ++i) {
    const Node& node = nodes_[i];
    const int whole_i = whole_place_[i];
    for (std::uint32_t e = node.first; e < node.end(); ++e) {
      const std::uint32_t j = to_[e];
      if (j < i) continue;
      int at_i = whole_i, at_j = whole_place_[j];
      if ((at_i | at_j) < 0) {
        const double weight = weights_[4 * std::size_t{e}];
        if (weight <= negligible) continue;
        at_i = table_place(coordination_[i] - weight);
        at_j = table_place(coordination_[j] - weight);
      }
      if (has_terms_[pair_[e]][at_i][at_j])
        selected_.push_back({e, pair_[e] == 0 && has_dihedrals_[at_i][at_j]});
    }
  }
  if (selected_.empty()) return true;
  // N_conj needs the coordination of all neighbours of both ends.
  const std::size_t measured = edge_count_;
  bool few = true;
  for (const Selected& bond : selected_) {
    const std::uint32_t j = to_[bond.edge];
    if (j < own) continue;
    const Node at_j = node_of(j);
    for (std::uint32_t e = at_j.first; e < at_j.end(); ++e) few &= add_node(to_[e]);
  }
  measure_from(static_cast<std::uint32_t>(nodes), static_cast<std::uint32_t>(measured));
  if (!few) return false;
  if (conjugation_.size() < edge_count_) conjugation_.resize(edge_count_ + edge_count_ / 4);
  is_conjugated_.assign(nodes_.size(), 0);
  is_differentiated_.assign(nodes_.size(), 0);
  differentiated_.clear();
  for (const Selected& bond : selected_) {
    Node& i = node_of(from_[bond.edge]);
    Node& j = node_of(to_[bond.edge]);
    find_conjugation(i);
    find_conjugation(j);
    add_bond(bond.edge, i, j, bond.dihedrals, j.atom < own ? 1.0 : 0.5);
  }
  return true;
}

void LaneEvaluation::run_bonds(LaneEnergy& energy) {
  for (const std::uint32_t used : used_bonds_) {
    BondBatch& batch = bond_batches_[used];
    batch.bonds.edges = batch.edges.data();
    batch.bonds.arms = batch.arms.data();
    batch.bonds.numbers = batch.numbers.data();
    loops_.bonds(edges(), batch.bonds, &energy);
    gather_derivatives(batch);
  }
}

void LaneEvaluation::differentiate(const Node& node) {
  const std::uint32_t place = place_[node.atom];
  if (is_differentiated_[place]) return;
  is_differentiated_[place] = 1;
  differentiated_.push_back(place);
  if (is_conjugated_[place]) return;
  is_conjugated_[place] = 1;
  for (std::uint32_t e = node.first; e < node.end(); ++e) conjugation_[e] = {};
}

void LaneEvaluation::gather_derivatives(const BondBatch& batch) {
  for (std::size_t b = 0; b < batch.bonds.count; ++b) {
    const double* numbers =
        batch.numbers.data() + (b / lane_block * lane_pieces) * lane_block + b % lane_block;
    const auto add = [&](std::uint32_t edge, LaneBondPiece coordination, LaneBondPiece sum) {
      const double by_coordination = numbers[coordination * lane_block], by_sum = numbers[sum * lane_block];
      if (by_coordination == 0.0 && by_sum == 0.0) return;
      Node& node = node_of(from_[edge]);
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
  // First what N_conj passes on to the neighbours' coordination, then all coordinations.
  for (std::size_t n = 0, ends = differentiated_.size(); n < ends; ++n) {
    const Node node = nodes_[differentiated_[n]];
    for (std::uint32_t e = node.first; e < node.first + node.carbons; ++e) {
      const double by_sum = node.by_conjugation_sum - conjugation_[e].by_sum;
      if (by_sum == 0.0 || conjugation_[e].slope == 0.0) continue;
      const double by_coordination = by_sum * weights_[4 * std::size_t{e}] * conjugation_[e].slope;
      Node& next = node_of(to_[e]);
      differentiate(next);
      next.by_coordination += by_coordination;
      conjugation_[reverse(next, node.atom)].by_coordination += by_coordination;
    }
  }
  for (const std::uint32_t place : differentiated_) {
    const Node& node = nodes_[place];
    if (whole_place_[node.atom] >= 0) continue;
    for (std::uint32_t e = node.first; e < node.end(); ++e) {
      const double weight_slope = weights_[4 * std::size_t{e} + 1];
      if (weight_slope == 0.0) continue;
      const Conjugation& c = conjugation_[e];
      const double by_weight =
          node.by_coordination - c.by_coordination + (node.by_conjugation_sum - c.by_sum) * c.unsaturation;
      gradient_[4 * std::size_t{e} + 3] += by_weight * weight_slope;
    }
  }
}

std::optional<EnergyParts> LaneEvaluation::evaluate(const AtomsView& atoms, double* forces,
                                                    double* atom_energies) {
  elements_ = atoms.elements;
  positions_.resize(4 * std::size_t{atoms.all});
  for (std::size_t i = 0; i < atoms.all; ++i)
    for (int d = 0; d < 3; ++d) positions_[4 * i + d] = atoms.positions[3 * i + d];
  if (!find_bonds(atoms)) return {};
  const std::size_t own_edges = atoms.own > 0 ? nodes_[atoms.own - 1].end() : 0;
  if (!select_bonds(atoms.own)) return {};
  energies_.assign(atom_energies ? edge_count_ : 0, 0.0);
  LaneEnergy energy = {};
  run_centres(atoms.own, energy);
  std::size_t pulled = own_edges;
  if (!selected_.empty()) {
    std::fill(gradient_.begin() + static_cast<std::ptrdiff_t>(4 * own_edges),
              gradient_.begin() + static_cast<std::ptrdiff_t>(4 * edge_count_), 0.0);
    run_bonds(energy);
    add_derivatives_by_weight();
    pulled = edge_count_;
  }
  forces_.assign(4 * std::size_t{atoms.all}, 0.0);
  loops_.pull(edges(), pulled, forces_.data());
  for (std::size_t i = 0; i < atoms.all; ++i)
    for (int d = 0; d < 3; ++d) forces[3 * i + d] += forces_[4 * i + d];
  if (atom_energies)
    for (std::size_t e = 0; e < own_edges; ++e) {
      atom_energies[from_[e]] += 0.5 * energies_[e];
      atom_energies[to_[e]] += 0.5 * energies_[e];
    }
  return EnergyParts{energy.repulsive, energy.sigma_pi, energy.conjugation, energy.dihedral, energy.torsion};
}

std::size_t LaneEvaluation::memory() const {
  std::size_t bytes = sizeof(Node) * nodes_.capacity() + sizeof(Conjugation) * conjugation_.capacity();
  for (const auto* list : {&near_.offsets, &near_.atoms, &near_hydrogens_, &place_, &from_, &to_, &pair_})
    bytes += sizeof(std::uint32_t) * list->capacity();
  for (const auto* array : {&positions_, &forces_, &geometry_, &weights_, &gradient_, &energies_})
    bytes += sizeof(double) * array->capacity();
  return bytes;
}

}  // namespace nanocarbon::rebo2
