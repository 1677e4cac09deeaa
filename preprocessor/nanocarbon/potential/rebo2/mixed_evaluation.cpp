// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/rebo2/mixed_evaluation.h"

#include <algorithm>
#include <bit>

#include "nanocarbon/potential/rebo2/conjugation.h"
#include "nanocarbon/potential/rebo2/lane_constants.h"

namespace nanocarbon::rebo2 {

namespace {

//! With more atoms than this outside the fast case, evaluating all in the lane loops takes less time.
constexpr double most_outside = 0.1;

}  // namespace

MixedEvaluation::MixedEvaluation(const Rebo2Parameters& parameters, const Sp2Kernel& kernel,
                                 const std::optional<TorsionBarriers>& torsion)
    : parameters_(parameters),
      constants_(make_sp2_constants(parameters)),
      bond_constants_(sp2_bond_constants(parameters.tables)),
      torsion_(torsion),
      loops_(torsion ? kernel.with_torsion : kernel.bond_order),
      fast_applies_(sp2_case_applies(parameters)),
      lanes_apply_(lane_loops_apply(parameters)),
      lanes_(parameters, *kernel.any, torsion) {
  const double cutoff = parameters.pairs[pair_index(Element::carbon, Element::carbon)].cutoff_end;
  watch_squared_ = cutoff * cutoff;
  if (torsion) {
    constants_.torsion_barrier = torsion->barriers[pair_index(Element::carbon, Element::carbon)];
    // The loops take a bond without T for one whose own terms are evaluated elsewhere.
    fast_applies_ &= bond_constants_.torsion != 0.0;
  }
  std::fill_n(plain_.on, sp2_block, 1.0);
  std::fill_n(&plain_.torsion[0][0], 3 * sp2_block, bond_constants_.torsion);
  std::fill_n(&plain_.pi[0][0], 3 * sp2_block, bond_constants_.pi);
}

bool MixedEvaluation::lanes_pay(std::size_t outside, std::size_t own) {
  return static_cast<double>(outside) > most_outside * static_cast<double>(own);
}

std::size_t MixedEvaluation::outside_fast_case(const potential::AtomsView& atoms,
                                               const potential::NearPairs& near) const {
  std::size_t outside = 0;
  for (std::uint32_t i = 0; i < atoms.own; ++i) {
    const Eigen::Map<const Vec3> from(atoms.positions + 3 * std::size_t{i});
    int whole = 0, other = 0;
    for (const std::uint32_t j : near.of(i)) {
      const double squared =
          (Eigen::Map<const Vec3>(atoms.positions + 3 * std::size_t{j}) - from).squaredNorm();
      if (!(squared < watch_squared_)) continue;
      const bool in_range = squared > constants_.shortest * constants_.shortest &&
                            squared < constants_.longest * constants_.longest;
      (atoms.elements[j] == Element::carbon && in_range ? whole : other) += 1;
    }
    outside += atoms.elements[i] != Element::carbon || whole != 3 || other != 0;
  }
  return outside;
}

void MixedEvaluation::make_blocks(const potential::AtomsView& atoms, const potential::NearPairs& near) {
  blocks_ = make_sp2_blocks(atoms, near, parameters_);
  geometry_.resize(12 * sp2_block * blocks_.slot_count);
  tensors_.assign(6 * (std::size_t{blocks_.zero_record()} + 1), 0.0);
  outside_.resize(blocks_.blocks);
  modifiers_.assign(blocks_.own_blocks, &plain_);
  modifier_pool_.resize(blocks_.own_blocks);
  modified_blocks_.clear();
  general_flag_.assign(atoms.all, 0);
  general_.clear();
}

Sp2Modifiers* MixedEvaluation::modifiers_of(std::uint32_t place) {
  const std::uint32_t block = place / sp2_block;
  if (block >= blocks_.own_blocks) return nullptr;
  if (modifiers_[block] == &plain_) {
    modifier_pool_[block] = plain_;
    modifiers_[block] = &modifier_pool_[block];
    modified_blocks_.push_back(block);
  }
  return &modifier_pool_[block];
}

void MixedEvaluation::reset_modifiers() {
  for (const std::uint32_t block : modified_blocks_) modifiers_[block] = &plain_;
  modified_blocks_.clear();
  // The last block of own atoms may have lanes without an atom.
  if (blocks_.own_blocks > 0 && blocks_.real[blocks_.own_blocks - 1] != ~0u) {
    const auto first = static_cast<std::uint32_t>((blocks_.own_blocks - 1) * sp2_block);
    for (std::uint32_t l = 0; l < sp2_block; ++l)
      if (!(blocks_.real[blocks_.own_blocks - 1] >> l & 1u)) modifiers_of(first)->on[l] = 0.0;
  }
}

void MixedEvaluation::flag_general(std::uint32_t atom) {
  if (general_flag_[atom]) return;
  general_flag_[atom] = 1;
  general_.push_back(atom);
}

void MixedEvaluation::find_crowded_atoms(const potential::AtomsView& atoms,
                                         const potential::NearPairs& near) {
  for (const std::uint32_t atom : general_) general_flag_[atom] = 0;
  general_.clear();
  for (const std::uint32_t atom : blocks_.others) flag_general(atom);
  for (const auto& [i, j] : blocks_.watched) {
    const double* a = atoms.positions + 3 * std::size_t{i};
    const double* b = atoms.positions + 3 * std::size_t{j};
    const double x = b[0] - a[0], y = b[1] - a[1], z = b[2] - a[2];
    if (x * x + y * y + z * z < watch_squared_) [[unlikely]] {
      flag_general(i);
      if (blocks_.place[j] != Sp2Blocks::nowhere) flag_general(j);
    }
  }
  workspace_.edges.clear(atoms.all);
  for (const std::uint32_t atom : general_) workspace_.edges.add(atom, atoms, near, parameters_);
  for (const std::uint32_t atom : blocks_.crowded) workspace_.edges.add(atom, atoms, near, parameters_);
}

void MixedEvaluation::set_bond_constants(std::uint32_t at, int s, const Sp2BondConstants& constants) {
  Sp2Modifiers* modifiers = modifiers_of(at);
  if (!modifiers) return;
  modifiers->torsion[s][at % sp2_block] = constants.torsion;
  modifiers->pi[s][at % sp2_block] = constants.pi;
}

void MixedEvaluation::switch_off(std::uint32_t atom) {
  const std::uint32_t at = blocks_.place[atom];
  if (at == Sp2Blocks::nowhere) return;
  if (Sp2Modifiers* modifiers = modifiers_of(at)) modifiers->on[at % sp2_block] = 0.0;
}

void MixedEvaluation::switch_off_bond(std::uint32_t fast, std::uint32_t general) {
  const std::uint32_t at = blocks_.place[fast];
  if (at == Sp2Blocks::nowhere) return;
  for (int s = 0; s < 3; ++s)
    if (blocks_.neighbour(at, s) == general) set_bond_constants(at, s, {0.0, 0.0});
}

void MixedEvaluation::switch_off_crowded_atoms() {
  for (const std::uint32_t g : general_) {
    switch_off(g);
    for (const HalfEdge& bond : workspace_.edges.of(workspace_.edges.centre(g))) switch_off_bond(bond.to, g);
  }
}

void MixedEvaluation::switch_off_outside(std::size_t begin_block, std::size_t end_block) {
  for (std::size_t block = begin_block; block < end_block; ++block)
    for (std::uint32_t bits = outside_[block] & blocks_.real[block]; bits != 0; bits &= bits - 1) {
      const auto at = static_cast<std::uint32_t>(block * sp2_block + std::countr_zero(bits));
      flag_general(blocks_.atoms[at]);
      switch_off(blocks_.atoms[at]);
      for (int s = 0; s < 3; ++s) switch_off_bond(blocks_.neighbour(at, s), blocks_.atoms[at]);
    }
}

void MixedEvaluation::find_general_bonds(const potential::AtomsView& atoms,
                                         const potential::NearPairs& near) {
  HalfEdges& edges = workspace_.edges;
  for (const std::uint32_t g : general_) edges.add(g, atoms, near, parameters_);
  bonds_.clear();
  for (const Bond& bond : fractional_bonds_)
    if (!general_flag_[bond.first] && !general_flag_[bond.second]) bonds_.push_back(bond);
  for (const std::uint32_t g : general_)
    for (const HalfEdge& bond : edges.of(edges.centre(g))) {
      const std::uint32_t j = bond.to;
      if (g >= atoms.own && j >= atoms.own) continue;
      // Where both ends are general, both come by here.
      if (!general_flag_[j] || g < j) bonds_.emplace_back(std::min(g, j), std::max(g, j));
    }
}

void MixedEvaluation::modify_crowded_bonds(const potential::AtomsView& atoms) {
  HalfEdges& edges = workspace_.edges;
  crowded_bonds_.clear();
  fractional_bonds_.clear();
  const auto collect = [&](std::uint32_t k) {
    const Centre& centre = edges.centre(k);
    if (centre.element != Element::carbon || centre.count < 4) return;
    for (const HalfEdge& bond : edges.of(centre)) {
      if (!is_fast(bond.to)) continue;
      const std::uint32_t at = blocks_.place[bond.to];
      for (int s = 0; s < 3; ++s) {
        const std::uint32_t m = blocks_.neighbour(at, s);
        if (m != k && is_fast(m)) crowded_bonds_.emplace_back(std::min(bond.to, m), std::max(bond.to, m));
      }
    }
  };
  for (const std::uint32_t k : general_) collect(k);
  for (const std::uint32_t k : blocks_.crowded)
    if (!general_flag_[k]) collect(k);
  std::sort(crowded_bonds_.begin(), crowded_bonds_.end());
  crowded_bonds_.erase(std::unique(crowded_bonds_.begin(), crowded_bonds_.end()), crowded_bonds_.end());

  for (const auto& [i, j] : crowded_bonds_) {
    if (i >= atoms.own) continue;
    double n_conj = 1.0;
    bool whole = true;
    for (const auto& [end, other] : {Bond{i, j}, Bond{j, i}}) {
      double sum = 0.0;
      for (int s = 0; s < 3; ++s) {
        const std::uint32_t k = blocks_.neighbour(blocks_.place[end], s);
        if (k == other) continue;
        const ValueSlope f = cosine_switch(edges.coordination(k) - 1.0, parameters_.conjugation_begin,
                                           parameters_.conjugation_end);
        sum += f.value;
        whole &= f.slope == 0.0;
      }
      n_conj += sum * sum;
    }
    const Sp2BondConstants at_whole = sp2_bond_constants(parameters_.tables, n_conj);
    whole &= !torsion_ || at_whole.torsion != 0.0;
    if (!whole) fractional_bonds_.emplace_back(i, j);
    const Sp2BondConstants constants = whole ? at_whole : Sp2BondConstants{0.0, 0.0};
    for (int s = 0; s < 3; ++s) {
      if (blocks_.neighbour(blocks_.place[i], s) == j) set_bond_constants(blocks_.place[i], s, constants);
      if (blocks_.neighbour(blocks_.place[j], s) == i) set_bond_constants(blocks_.place[j], s, constants);
    }
  }
}

EnergyParts MixedEvaluation::add_general_terms(const potential::AtomsView& atoms,
                                               const potential::NearPairs& near, double* forces,
                                               const potential::AtomShares& shares) {
  HalfEdges& edges = workspace_.edges;
  for (const auto& [i, j] : bonds_)
    for (const std::uint32_t end : {i, j}) {
      edges.add(end, atoms, near, parameters_);
      const Centre centre = edges.centre(end);
      // Next to these, only what is not three-coordinated matters.
      for (std::uint32_t a = 0; a < centre.count; ++a)
        if (const std::uint32_t k = edges.of(centre)[a].to; !is_fast(k))
          edges.add(k, atoms, near, parameters_);
    }
  const Model model(parameters_, torsion_ ? &*torsion_ : nullptr);
  EnergyParts energy;
  general_own_ = 0;
  for (const std::uint32_t g : general_)
    if (g < atoms.own) {
      energy += add_centre_terms(edges, edges.centre(g), model, workspace_.angles, shares);
      ++general_own_;
    }
  for (const auto& [i, j] : bonds_) {
    const Centre& centre = edges.centre(i);
    const auto bonds = edges.of(centre);
    const std::uint32_t to = j;
    const auto ij = std::find_if(bonds.begin(), bonds.end(), [&](const HalfEdge& b) { return b.to == to; });
    energy += add_bond_terms(edges, centre, *ij, model, j < atoms.own ? 1.0 : 0.5, shares);
  }
  edges.add_forces(forces);
  return energy;
}

EnergyParts MixedEvaluation::run_fast_loops(const Sp2Data& data) {
  const std::size_t own = blocks_.own_blocks;
  loops_.first(data, own, blocks_.blocks);
  switch_off_outside(own, blocks_.blocks);
  Sp2Energy sum = {};
  std::size_t done = 0;
  for (std::size_t begin = 0; begin < own; begin += Sp2Blocks::window) {
    const std::size_t end = std::min(own, begin + Sp2Blocks::window);
    loops_.first(data, begin, end);
    switch_off_outside(begin, end);
    std::size_t ready = done;
    while (ready < own && blocks_.needs[ready] <= end) ++ready;
    loops_.second(data, done, ready, &sum);
    done = ready;
  }
  return {sum.repulsive, sum.sigma_pi, sum.conjugation, sum.dihedral, sum.torsion};
}

EnergyParts MixedEvaluation::evaluate(const potential::AtomsView& atoms, const potential::NearPairs& near,
                                      double* forces, const potential::AtomShares& shares,
                                      bool general_only) {
  if (!general_only && !shares.virials && !(torsion_ && shares.energies)) {
    if (!lists_are_good_) {
      const auto many_outside = [&] { return lanes_pay(outside_fast_case(atoms, near), atoms.own); };
      use_lanes_ = lanes_apply_ && (!fast_applies_ || (chosen_ ? *chosen_ : many_outside()));
      if (use_lanes_)
        lanes_.near_changed(atoms, near);
      else if (fast_applies_)
        make_blocks(atoms, near);
      lists_are_good_ = true;
    }
    general_own_ = 0;
    if (use_lanes_) {
      if (const auto energy = lanes_.evaluate(atoms, forces, shares.energies)) return *energy;
    } else if (fast_applies_) {
      return evaluate_mixed(atoms, near, forces, shares);
    }
  }
  general_own_ = atoms.own;
  const Model model(parameters_, torsion_ ? &*torsion_ : nullptr);
  return evaluate_general(atoms, near, model, workspace_, forces, shares);
}

EnergyParts MixedEvaluation::evaluate_mixed(const potential::AtomsView& atoms,
                                            const potential::NearPairs& near, double* forces,
                                            const potential::AtomShares& shares) {
  if (shares.energies) edge_energies_.resize(3 * sp2_block * blocks_.own_blocks);
  const Sp2Data data = {&constants_,
                        atoms.positions,
                        blocks_.atoms.data(),
                        blocks_.neighbours.data(),
                        blocks_.reverses.data(),
                        blocks_.slots.data(),
                        geometry_.data(),
                        tensors_.data(),
                        outside_.data(),
                        modifiers_.data(),
                        forces,
                        shares.energies ? edge_energies_.data() : nullptr};
  reset_modifiers();
  find_crowded_atoms(atoms, near);
  switch_off_crowded_atoms();
  modify_crowded_bonds(atoms);
  EnergyParts energy = run_fast_loops(data);
  find_general_bonds(atoms, near);
  energy += add_general_terms(atoms, near, forces, shares);
  if (shares.energies)
    for (std::uint32_t at = 0; at < blocks_.own_blocks * sp2_block; ++at)
      for (int s = 0; s < 3; ++s)
        shares.add_bond_energy(blocks_.atoms[at], blocks_.neighbour(at, s),
                               edge_energies_[Sp2Blocks::index(at, s)]);
  return energy;
}

std::size_t MixedEvaluation::memory() const {
  return lanes_.memory() +
         sizeof(double) * (geometry_.capacity() + tensors_.capacity() + edge_energies_.capacity()) +
         sizeof(std::uint32_t) * (blocks_.neighbours.capacity() + blocks_.reverses.capacity() +
                                  blocks_.atoms.capacity() + blocks_.place.capacity() + outside_.capacity()) +
         sizeof(Sp2Modifiers) * modifier_pool_.capacity();
}

}  // namespace nanocarbon::rebo2
