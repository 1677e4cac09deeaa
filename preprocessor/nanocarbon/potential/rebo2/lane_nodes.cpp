// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/rebo2/lane_nodes.h"

#include <algorithm>
#include <array>
#include <limits>

namespace nanocarbon::rebo2 {

using potential::AtomsView;
using potential::NearPairs;

namespace {

constexpr std::uint32_t absent = std::numeric_limits<std::uint32_t>::max();

// Angstrom, of half-edges beyond a bond's reach, by pair_index(): the two hydrogens of CH2, at 1.78, are within,
// hydrogen at the next carbon, at 2.15, is not.
constexpr std::array<double, 3> margins = {0.15, 0.15, 0.25};
constexpr double steady_slack = 0.04;  // Angstrom, of a steady node's bonds to where their switch begins

double squared_distance(const double* from, const double* to) {
  const double x = to[0] - from[0], y = to[1] - from[1], z = to[2] - from[2];
  return x * x + y * y + z * z;
}

}  // namespace

LaneNodes::LaneNodes(const Rebo2Parameters& parameters, const LaneConstants& constants,
                     const LaneLoops& loops)
    : constants_(constants), loops_(loops) {
  for (std::size_t pair = 0; pair < 3; ++pair) {
    cutoffs_[pair] = parameters.pairs[pair].cutoff_end;
    longest_steady_[pair] = parameters.pairs[pair].cutoff_begin - steady_slack;
  }
}

void LaneNodes::near_changed(const AtomsView& atoms, const NearPairs& near) {
  near_.offsets = near.offsets;
  near_.atoms.resize(near.atoms.size());
  near_hydrogens_.resize(atoms.all);
  std::vector<std::uint32_t> hydrogens;
  for (std::uint32_t i = 0; i < atoms.all; ++i) {
    const auto row = near.of(i);
    std::uint32_t* to = near_.atoms.data() + near.offsets[i];
    if (hydrogens.size() < row.size()) hydrogens.resize(row.size());
    std::size_t carbons = 0, others = 0;
    for (const std::uint32_t j : row) {  // without branches: elements come in any order
      const bool hydrogen = atoms.elements[j] == Element::hydrogen;
      to[carbons] = hydrogens[others] = j;
      carbons += !hydrogen;
      others += hydrogen;
    }
    std::copy_n(hydrogens.begin(), others, to + carbons);
    near_hydrogens_[i] = near.offsets[i] + static_cast<std::uint32_t>(carbons);
  }
  // No more half-edges than near pairs, and a block beyond them.
  const std::size_t most = near.atoms.size() + lane_block;
  for (auto* list : {&from_, &to_, &pair_}) list->resize(most);
  place_.assign(atoms.all, absent);
  coordination_.resize(atoms.all);
  whole_place_.resize(atoms.all);
  nodes_.clear();
  remembered_ = false;
}

void LaneNodes::take_positions(const AtomsView& atoms) {
  elements_ = atoms.elements;
  positions_.resize(4 * std::size_t{atoms.all});
  for (std::size_t i = 0; i < atoms.all; ++i)
    for (int d = 0; d < 3; ++d) positions_[4 * i + d] = atoms.positions[3 * i + d];
}

bool LaneNodes::add(std::uint32_t atom) {
  if (place_[atom] != absent) return true;
  place_[atom] = static_cast<std::uint32_t>(nodes_.size());
  const double* from = positions_.data() + 4 * std::size_t{atom};
  const double x = from[0], y = from[1], z = from[2];
  const auto first = static_cast<std::uint32_t>(edge_count_);
  std::uint32_t n = first;
  const std::uint32_t element = static_cast<std::uint32_t>(elements_[atom]);
  const auto take = [&](std::uint32_t begin, std::uint32_t end, std::uint32_t pair) {
    const double reach = squared_reach_[pair];
    const std::uint32_t before = n;
    for (std::uint32_t k = begin; k < end; ++k) {
      const std::uint32_t j = near_.atoms[k];
      const double* to = positions_.data() + 4 * std::size_t{j};
      const double a = to[0] - x, b = to[1] - y, c = to[2] - z;
      to_[n] = j;
      n += a * a + b * b + c * c < reach;
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

void LaneNodes::measure_from(std::uint32_t node, std::uint32_t edge) {
  for (std::size_t n = 0; edge_count_ > 0 && n < lane_block; ++n) {
    from_[edge_count_ + n] = from_[edge_count_ - 1];
    to_[edge_count_ + n] = to_[edge_count_ - 1];
    pair_[edge_count_ + n] = pair_[edge_count_ - 1];
  }
  const std::size_t records = 4 * (edge_count_ + lane_block);
  for (auto* array : {&geometry_, &weights_, &gradient_})
    if (array->size() < records) array->resize(records + records / 4);
  if (edge < edge_count_) loops_.measure(edges(nullptr), edge, edge_count_);
  is_steady_.resize(nodes_.size());
  for (; node < nodes_.size(); ++node) {
    LaneNode& at = nodes_[node];
    sum_weights(at);
    bool steady = whole_place_[at.atom] >= 0;
    for (std::size_t e = at.first; e < at.end(); ++e)
      steady &= geometry_[4 * e + 3] < longest_steady_[pair_[e]];
    is_steady_[node] = steady;
  }
}

void LaneNodes::sum_weights(LaneNode& node) {
  double sum = 0.0;
  bool whole = true;
  for (std::uint32_t e = node.first; e < node.end(); ++e) {
    sum += weight(e);
    whole &= (weight(e) == 1.0 || weight(e) == 0.0) && weight_slope(e) == 0.0;
  }
  node.bonded_carbons = node.carbons;
  node.bonded_hydrogens = node.hydrogens;
  for (std::uint32_t e = node.end(); e > node.first && is_beyond(e - 1); --e)
    --(node.bonded_hydrogens > 0 ? node.bonded_hydrogens : node.bonded_carbons);
  coordination_[node.atom] = sum;
  whole_place_[node.atom] = whole ? static_cast<std::int8_t>(table_place(sum - 1.0)) : std::int8_t{-1};
}

LaneEdges LaneNodes::edges(double* energies) {
  return {&constants_,      positions_.data(), from_.data(),     to_.data(), pair_.data(),
          geometry_.data(), weights_.data(),   gradient_.data(), energies};
}

bool LaneNodes::find(std::uint32_t own, bool beyond) {
  return (beyond && find_within(own, margins)) || find_within(own, {});
}

bool LaneNodes::find_within(std::uint32_t own, const std::array<double, 3>& beyond) {
  for (std::size_t pair = 0; pair < 3; ++pair)
    squared_reach_[pair] = (cutoffs_[pair] + beyond[pair]) * (cutoffs_[pair] + beyond[pair]);
  for (const LaneNode& node : nodes_) place_[node.atom] = absent;
  nodes_.clear();
  edge_count_ = 0;
  remembered_ = false;
  bool few = true;
  for (std::uint32_t i = 0; i < own; ++i) few &= add(i);
  for (std::size_t e = 0, end = edge_count_; e < end; ++e)
    if (to_[e] >= own) few &= add(to_[e]);
  if (few) measure_from(0, 0);
  return few;
}

std::size_t LaneNodes::restless(std::uint32_t own) const {
  return static_cast<std::size_t>(std::count(is_steady_.begin(), is_steady_.begin() + own, 0));
}

void LaneNodes::remember() {
  apart_.resize(near_.atoms.size() + 1);
  std::size_t apart = 0;
  steady_edges_.clear();
  restless_.clear();
  for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
    const LaneNode& node = nodes_[n];
    if (!is_steady_[n])
      restless_.push_back(n);
    else if (!steady_edges_.empty() && steady_edges_.back()[1] == node.first)
      steady_edges_.back()[1] = node.end();
    else
      steady_edges_.push_back({node.first, node.end()});
    const std::uint32_t i = node.atom;
    const auto element = static_cast<std::uint32_t>(elements_[i]);
    // Half-edges are in the order of the near pairs.
    std::uint32_t e = node.first;
    for (std::uint32_t k = near_.offsets[i]; k < near_.offsets[i + 1]; ++k) {
      const std::uint32_t j = near_.atoms[k];
      const bool is_edge = e < node.end() && to_[e] == j;
      const bool is_in_other_row = place_[j] != absent && j < i;
      apart_[apart] = {i, j, element + (k >= near_hydrogens_[i] ? 1u : 0u)};
      apart += !is_edge && !is_in_other_row;
      e += is_edge;
    }
  }
  apart_.resize(apart);
  remembered_ = true;
}

bool LaneNodes::same_as_remembered() {
  if (!remembered_) return false;
  const std::array<double, 3> squared = {cutoffs_[0] * cutoffs_[0], cutoffs_[1] * cutoffs_[1],
                                         cutoffs_[2] * cutoffs_[2]};
  bool apart = true;
  for (const Apart& pair : apart_)
    apart &= squared_distance(positions_.data() + 4 * std::size_t{pair.first},
                              positions_.data() + 4 * std::size_t{pair.second}) >= squared[pair.pair];
  if (!apart || edge_count_ == 0) return apart;
  loops_.measure(edges(nullptr), 0, edge_count_);
  bool whole = true;
  for (const auto& [begin, end] : steady_edges_)
    for (std::uint32_t e = begin; e < end; ++e) whole &= weight(e) == 1.0;
  if (!whole) return false;
  for (const std::uint32_t node : restless_) sum_weights(nodes_[node]);
  return true;
}

std::size_t LaneNodes::memory() const {
  std::size_t bytes = sizeof(LaneNode) * nodes_.capacity() + sizeof(Apart) * apart_.capacity();
  for (const auto* list : {&near_.offsets, &near_.atoms, &near_hydrogens_, &place_, &from_, &to_, &pair_})
    bytes += sizeof(std::uint32_t) * list->capacity();
  for (const auto* array : {&positions_, &geometry_, &weights_, &gradient_, &coordination_})
    bytes += sizeof(double) * array->capacity();
  return bytes;
}

}  // namespace nanocarbon::rebo2
