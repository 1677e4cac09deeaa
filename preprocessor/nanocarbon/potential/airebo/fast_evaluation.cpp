// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/airebo/fast_evaluation.h"

#include <algorithm>
#include <cmath>

#include "nanocarbon/potential/airebo/exclusions.h"
#include "nanocarbon/potential/rebo2/kernels/sp2_dispatch.h"

namespace nanocarbon::airebo {

using potential::AtomsView;
using potential::NearPairs;
using rebo2::Centre;

namespace {

Vec3 separation(const AtomsView& atoms, std::uint32_t i, std::uint32_t j) {
  return Eigen::Map<const Vec3>(atoms.positions + 3 * std::size_t{j}) -
         Eigen::Map<const Vec3>(atoms.positions + 3 * std::size_t{i});
}

}  // namespace

FastEvaluation::FastEvaluation(const AireboModel& model)
    : model_(model),
      bonds_(model.parameters.rebo, *rebo2::usable_sp2_kernels().front(),
             model.terms.torsion ? std::optional(model.parameters.torsion) : std::nullopt),
      trigonal_(model),
      stars_(model) {}

void FastEvaluation::lists_changed(const AtomsView& atoms, const NearPairs& near, NearPairs candidates,
                                   double margin) {
  margin_ = margin;
  whole_ = find_whole_bonds(atoms, near, model_.parameters);
  excluded_ = find_exclusions(atoms.own, whole_);
  candidates_ = {};
  if (model_.terms.long_range)
    for (std::uint32_t i = 0; i < atoms.own; ++i) {
      for (const std::uint32_t j : candidates.of(i))
        if (!is_excluded(excluded_, atoms.own, i, j)) candidates_.atoms.push_back(j);
      candidates_.offsets.push_back(static_cast<std::uint32_t>(candidates_.atoms.size()));
    }
  affected_flag_.assign(atoms.all, 0);
  affected_.clear();
  near_changed(atoms, near);
}

void FastEvaluation::near_changed(const AtomsView& atoms, const NearPairs& near) {
  bonds_.near_changed();
  if (!model_.terms.long_range) return;
  find_close_pairs(atoms);
  watch_.prepare(atoms, near, whole_, atoms_to_watch(atoms, near), model_.parameters, margin_);
}

void FastEvaluation::find_close_pairs(const AtomsView& atoms) {
  close_.clear();
  stars_.clear();
  trigonal_.clear(atoms.all);
  constexpr std::uint32_t unknown = BondStars::none - 1;
  star_of_.assign(atoms.all, unknown);
  const auto star = [&](std::uint32_t atom) {
    if (star_of_[atom] == unknown) star_of_[atom] = stars_.add(atom, atoms, whole_);
    return star_of_[atom];
  };
  for (std::uint32_t i = 0; i < atoms.own; ++i)
    for (const std::uint32_t j : candidates_.of(i)) {
      const std::size_t pair = rebo2::pair_index(atoms.elements[i], atoms.elements[j]);
      const double range = model_.parameters.long_range[pair].length_switch_end + margin_;
      if (separation(atoms, i, j).squaredNorm() < range * range && !trigonal_.add(i, j, atoms, whole_))
        close_.push_back({i, j, star(i), star(j), static_cast<std::uint32_t>(pair)});
    }
}

std::vector<char> FastEvaluation::atoms_to_watch(const AtomsView& atoms, const NearPairs& near) const {
  std::vector<char> watched(atoms.all, 0);
  std::fill_n(watched.begin(), atoms.own, 1);
  // Up to two bonds from own atoms, for paths; own atoms have all rows.
  std::vector<std::uint32_t> shell(atoms.own), next;
  for (std::uint32_t i = 0; i < atoms.own; ++i) shell[i] = i;
  for (int step = 0; step < 2; ++step) {
    next.clear();
    for (const std::uint32_t i : shell)
      for (const std::uint32_t j : near.of(i))
        if (!watched[j]) {
          watched[j] = 1;
          next.push_back(j);
        }
    shell.swap(next);
  }
  for (const ClosePair& pair : close_) watched[pair.j] = 1;
  trigonal_.mark_second_atoms(watched);
  return watched;
}

double FastEvaluation::collect_bond_order_terms(const AtomsView& atoms, double* forces) {
  stars_.new_step();
  std::array<double, 3> end_squared, switch_begin;
  for (int p = 0; p < 3; ++p) {
    const LongRangeParameters& pair = model_.parameters.long_range[p];
    const double end = std::min(pair.length_switch_end, lj_reach(model_.lj, p));
    end_squared[p] = end * end;
    switch_begin[p] = pair.order_switch_begin;
  }
  const auto add_term = [&](std::uint32_t i, std::uint32_t j) {
    terms_.push_back({.i = i, .j = j, .c = 1.0, .d = 0.0});
  };
  left_.clear();
  const double energy = trigonal_.evaluate(atoms, watch_, forces, left_);
  for (const auto& [i, j] : left_) add_term(i, j);
  for (const ClosePair& pair : close_) {
    const double* a = atoms.positions + 3 * std::size_t{pair.i};
    const double* b = atoms.positions + 3 * std::size_t{pair.j};
    const double x = b[0] - a[0], y = b[1] - a[1], z = b[2] - a[2];
    const double squared = x * x + y * y + z * z;
    if (!(squared < end_squared[pair.elements])) continue;
    if (pair.star_i == BondStars::none || pair.star_j == BondStars::none || watch_.is_disturbed(pair.i) ||
        watch_.is_disturbed(pair.j)) {
      add_term(pair.i, pair.j);
      continue;
    }
    stars_.place(pair.star_i, atoms);
    stars_.place(pair.star_j, atoms);
    const double inverse = 1.0 / std::sqrt(squared);
    const double bound =
        stars_.order_bound(pair.star_i, pair.star_j, {x * inverse, y * inverse, z * inverse}, atoms);
    if (!(bound <= switch_begin[pair.elements])) add_term(pair.i, pair.j);  // else S_b = 1
  }
  return energy;
}

void FastEvaluation::find_affected(const AtomsView& atoms, const NearPairs& near) {
  affected_.clear();
  const auto reach = [&](std::uint32_t atom) {
    if (affected_flag_[atom]) return;
    affected_flag_[atom] = 1;
    affected_.push_back(atom);
  };
  for (const std::uint32_t atom : watch_.find(atoms.positions)) reach(atom);
  std::size_t done = 0;
  for (int step = 0; step < 2; ++step)
    for (const std::size_t end = affected_.size(); done < end; ++done) {
      const std::uint32_t i = affected_[done];
      for (const std::uint32_t j : near.of(i)) {
        const std::size_t pair = rebo2::pair_index(atoms.elements[i], atoms.elements[j]);
        const double bond = model_.parameters.rebo.pairs[pair].cutoff_end;
        if (separation(atoms, i, j).squaredNorm() < bond * bond) reach(j);
      }
      for (const std::uint32_t j : whole_.of(i)) reach(j);
    }
  for (const std::uint32_t atom : affected_) affected_flag_[atom] = 0;
}

void FastEvaluation::collect_path_terms(const AtomsView& atoms, const NearPairs& near) {
  const auto add_with_neighbours = [&](std::uint32_t atom, auto&& then) {
    edges_.add(atom, atoms, near, model_.parameters.rebo);
    const Centre centre = edges_.centre(atom);
    for (std::uint32_t e = centre.first; e < centre.first + centre.count; ++e) then(edges_[e].to);
  };
  const auto add = [&](std::uint32_t atom) { edges_.add(atom, atoms, near, model_.parameters.rebo); };
  for (const std::uint32_t i : affected_)
    if (i < atoms.own) add_with_neighbours(i, [&](std::uint32_t k) { add_with_neighbours(k, add); });
  for (const std::uint32_t i : affected_) {
    if (i >= atoms.own) continue;
    paths_.find(edges_, i);
    const auto share = [&](std::uint32_t j) { return j < atoms.own ? 1.0 : 0.5; };
    for (const BondPath& path : paths_.all()) {
      if (path.to < i) continue;  // at the other end; copies have larger numbers
      const bool excluded = is_excluded(excluded_, atoms.own, i, path.to);
      if (excluded && path.weight == 1.0) continue;
      terms_.push_back(
          {.i = i, .j = path.to, .c = excluded ? 1.0 : 0.0, .d = 1.0, .share = share(path.to), .path = path});
    }
    for (const std::uint32_t j : excluded_.of(i))
      if (!paths_.to(j))
        terms_.push_back({.i = i, .j = j, .c = 1.0, .d = 1.0, .share = share(j), .path = {}});
  }
}

AireboEnergyParts FastEvaluation::evaluate(const AtomsView& atoms, const NearPairs& near, double* forces) {
  AireboEnergyParts energy;
  energy.bonds = bonds_.evaluate(atoms, near, forces, {});
  terms_.clear();
  if (!model_.terms.long_range) return energy;
  edges_.clear(atoms.all);
  find_affected(atoms, near);
  collect_path_terms(atoms, near);
  energy.long_range += collect_bond_order_terms(atoms, forces);
  if (terms_.empty()) return energy;
  for (const LongRangeTerm& term : terms_) add_bonds_for(term, atoms, near, model_, edges_);
  for (const LongRangeTerm& term : terms_)
    energy.long_range += add_long_range_term(term, atoms, model_, edges_, scratch_, forces, {});
  edges_.add_forces(forces);
  return energy;
}

std::size_t FastEvaluation::memory() const {
  return bonds_.memory() + trigonal_.memory() + sizeof(ClosePair) * close_.capacity() +
         sizeof(std::uint32_t) *
             (whole_.atoms.capacity() + whole_.offsets.capacity() + excluded_.atoms.capacity() +
              excluded_.offsets.capacity() + candidates_.atoms.capacity() + candidates_.offsets.capacity() +
              star_of_.capacity());
}

}  // namespace nanocarbon::airebo
