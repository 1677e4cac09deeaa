// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/fixed_bond_loops.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

#include "nanocarbon/potential/rebo2/coordination_tables.h"
#include "nanocarbon/potential/rebo2/kernels/sp2_dispatch.h"
#include "nanocarbon/potential/rebo2/parameters.h"
#include "nanocarbon/potential/rebo2/sp2_constants.h"

namespace nanocarbon::annealing {

namespace {

constexpr std::uint32_t nowhere = static_cast<std::uint32_t>(-1);

// Bonds of intermediate molecules; the polynomials are good to 1e-10 eV there. Angstrom.
constexpr double shortest = 1.1, longest = 2.0;
// Nearly straight and nearly folded angles have no direction for a dihedral.
constexpr double largest_cosine = 0.998;

rebo2::Sp2Constants wide_constants() {
  rebo2::Sp2Constants c = rebo2::make_sp2_constants(rebo2::rebo2_parameters(), shortest, longest);
  c.lowest_cosine = -largest_cosine;
  c.highest_cosine = largest_cosine;
  return c;
}

double torsion_constant() {
  static const double constant = rebo2::sp2_bond_constants(rebo2::rebo2_tables()).torsion;
  return constant;
}

rebo2::Sp2Modifiers make_plain_modifiers() {
  rebo2::Sp2Modifiers m = {};
  std::fill_n(m.on, rebo2::sp2_block, 1.0);
  for (auto& torsion : m.torsion) std::fill_n(torsion, rebo2::sp2_block, torsion_constant());
  return m;
}

const rebo2::Sp2Modifiers& plain_modifiers() {
  static const rebo2::Sp2Modifiers plain = make_plain_modifiers();
  return plain;
}

const rebo2::Sp2Loops& loops() {
  static const rebo2::Sp2Loops& best = rebo2::usable_sp2_kernels().front()->bond_order;
  return best;
}

// Where a bond of the atom at a place stands in [block][s][lane].
std::size_t record(std::size_t at, std::size_t s) {
  return (at / rebo2::sp2_block * 3 + s) * rebo2::sp2_block + at % rebo2::sp2_block;
}

}  // namespace

void FixedBondLoops::lay_out_atoms(const FixedBondGraph& graph) {
  place_.assign(graph.neighbours.size(), nowhere);
  atoms_.clear();
  first_block_.assign(1, 0);
  for (std::size_t chunk = 0; chunk < chunks_.count(); ++chunk) {
    for (std::size_t a = chunks_.begin(chunk); a < chunks_.end(chunk); ++a)
      if (graph.complete(static_cast<AtomIndex>(a))) {
        place_[a] = static_cast<std::uint32_t>(atoms_.size());
        atoms_.push_back(static_cast<AtomIndex>(a));
      }
    // Padding repeats the first atom of its block.
    while (atoms_.size() % rebo2::sp2_block != 0)
      atoms_.push_back(atoms_[atoms_.size() / rebo2::sp2_block * rebo2::sp2_block]);
    first_block_.push_back(atoms_.size() / rebo2::sp2_block);
  }
}

void FixedBondLoops::set_graph(const FixedBondGraph& graph) {
  chunks_ = AtomChunks(graph);
  lay_out_atoms(graph);
  slots_.resize(first_block_.back());
  for (std::uint32_t block = 0; block < slots_.size(); ++block) slots_[block] = block;
  outside_.assign(slots_.size(), 0);
  lay_out_bonds(graph);
  set_modifiers(graph);
  geometry_.resize(blocks() * 12 * rebo2::sp2_block);
  tensors_.assign(blocks() * 18 * rebo2::sp2_block + 6, 0);
  forces_.assign(3 * graph.neighbours.size(), 0);
  space_ = graph.space;
  copies_known_ = !space_.periodic();
  copies_.clear();
}

void FixedBondLoops::lay_out_bonds(const FixedBondGraph& graph) {
  const auto zero_record = static_cast<std::uint32_t>(3 * rebo2::sp2_block * blocks());
  neighbours_.resize(3 * atoms_.size());
  reverses_.resize(3 * atoms_.size());
  for (std::size_t at = 0; at < atoms_.size(); ++at)
    for (std::uint32_t s = 0; s < 3; ++s) {
      const AtomIndex n = graph.neighbours[atoms_[at]][s];
      neighbours_[record(at, s)] = n;
      reverses_[record(at, s)] =
          place_[n] == nowhere ? zero_record : 3 * place_[n] + graph.slot(n, atoms_[at]);
    }
}

void FixedBondLoops::set_modifiers(const FixedBondGraph& graph) {
  special_.clear();
  special_of_block_.assign(blocks(), 0);
  const auto special = [&](std::size_t at) -> rebo2::Sp2Modifiers& {
    std::size_t& k = special_of_block_[at / rebo2::sp2_block];
    if (k == 0) {
      special_.push_back(plain_modifiers());
      k = special_.size();
    }
    return special_[k - 1];
  };
  for (std::size_t at = 0; at < atoms_.size(); ++at) {
    if (place_[atoms_[at]] != at) special(at).on[at % rebo2::sp2_block] = 0;
    for (std::uint32_t s = 0; s < 3; ++s)
      if (place_[graph.neighbours[atoms_[at]][s]] == nowhere)
        special(at).torsion[s][at % rebo2::sp2_block] = 0;
  }
  modifiers_.resize(blocks());
  for (std::size_t block = 0; block < blocks(); ++block)
    modifiers_[block] =
        special_of_block_[block] ? &special_[special_of_block_[block] - 1] : &plain_modifiers();
}

void FixedBondLoops::find_copies(std::span<const Vec3> positions) {
  for (std::size_t at = 0; at < atoms_.size(); ++at)
    for (std::uint32_t s = 0; s < 3; ++s) {
      std::uint32_t& n = neighbours_[record(at, s)];
      const std::array<std::int32_t, 3> image = space_.image(positions[atoms_[at]], positions[n]);
      if (image == std::array<std::int32_t, 3>{0, 0, 0}) continue;
      copies_.push_back({n, image_shift(*space_.cell(), image)});
      n = static_cast<std::uint32_t>(positions.size() + copies_.size() - 1);
    }
  forces_.assign(3 * (positions.size() + copies_.size()), 0);
  copies_known_ = true;
}

rebo2::Sp2Data FixedBondLoops::data() {
  static const rebo2::Sp2Constants constants = wide_constants();
  return {&constants,       places_->data(),   atoms_.data(),    neighbours_.data(),
          reverses_.data(), slots_.data(),     geometry_.data(), tensors_.data(),
          outside_.data(),  modifiers_.data(), forces_.data(),   nullptr};
}

void FixedBondLoops::measure(std::span<const Vec3> positions, ThreadTeam* team) {
  if (blocks() == 0) return;
  if (!copies_known_) find_copies(positions);
  places_ = positions.data();
  if (!copies_.empty()) {
    with_copies_.assign(positions.begin(), positions.end());
    for (const Copy& copy : copies_) with_copies_.push_back(positions[copy.of] + copy.shift);
    places_ = with_copies_.data();
  }
  const rebo2::Sp2Data arrays = data();
  for_each_index(team, chunks_.count(), [&](std::size_t chunk) {
    loops().first(arrays, first_block_[chunk], first_block_[chunk + 1]);
  });
}

std::vector<AtomIndex> FixedBondLoops::outside() const {
  std::vector<AtomIndex> result;
  for (std::size_t block = 0; block < blocks(); ++block)
    for (std::uint32_t bits = outside_[block]; bits != 0; bits &= bits - 1) {
      const std::size_t at = block * rebo2::sp2_block + static_cast<std::size_t>(std::countr_zero(bits));
      if (place_[atoms_[at]] == at) result.push_back(atoms_[at]);
    }
  return result;
}

void FixedBondLoops::find_strained(double long_bond, double close_neighbours, std::size_t chunk,
                                   std::vector<AtomIndex>& strained) const {
  constexpr double rounding = 1e-9;
  const double longest = long_bond - rounding, close2 = std::pow(close_neighbours + rounding, 2);
  for (std::size_t block = first_block_[chunk]; block < first_block_[chunk + 1]; ++block) {
    const double* g = &geometry_[block * 12 * rebo2::sp2_block];
    const auto at = [&](std::size_t piece, std::size_t lane) { return g[piece * rebo2::sp2_block + lane]; };
    std::array<bool, rebo2::sp2_block> found = {};
    bool any = false;
    for (std::size_t l = 0; l < rebo2::sp2_block; ++l) {
      bool is = false;
      for (std::size_t s = 0; s < 3; ++s) {
        const std::size_t a = 4 * s, b = 4 * ((s + 1) % 3);
        const double r = at(a + 3, l), q = at(b + 3, l);
        const double cosine = at(a, l) * at(b, l) + at(a + 1, l) * at(b + 1, l) + at(a + 2, l) * at(b + 2, l);
        is |= (r > longest) | (r * r + q * q - 2 * r * q * cosine < close2);
      }
      found[l] = is;
      any |= is;
    }
    if (!any) continue;
    for (std::size_t l = 0; l < rebo2::sp2_block; ++l) {
      const std::size_t place = block * rebo2::sp2_block + l;
      if (found[l] && place_[atoms_[place]] == place) strained.push_back(atoms_[place]);
    }
  }
}

double FixedBondLoops::add(std::span<const AtomIndex> left_out, const FixedBondGraph& graph,
                           std::span<Vec3> gradient, ThreadTeam* team) {
  if (blocks() == 0) return 0;
  // What these atoms change of the modifiers, for now.
  std::map<std::size_t, rebo2::Sp2Modifiers> changed;
  const auto modifiers_at = [&](std::size_t place) -> rebo2::Sp2Modifiers& {
    const std::size_t block = place / rebo2::sp2_block;
    return changed.try_emplace(block, *modifiers_[block]).first->second;
  };
  for (const AtomIndex a : left_out) {
    if (place_[a] == nowhere) continue;
    modifiers_at(place_[a]).on[place_[a] % rebo2::sp2_block] = 0;
    for (const AtomIndex n : graph.neighbours[a])
      if (place_[n] != nowhere)
        modifiers_at(place_[n]).torsion[graph.slot(n, a)][place_[n] % rebo2::sp2_block] = 0;
  }
  for (auto& [block, modifiers] : changed) modifiers_[block] = &modifiers;

  const rebo2::Sp2Data arrays = data();
  const double energy = chunks_.sum(team, [&](std::size_t chunk) {
    rebo2::Sp2Energy part = {};
    loops().second(arrays, first_block_[chunk], first_block_[chunk + 1], &part);
    return part.repulsive + part.sigma_pi + part.conjugation + part.dihedral;
  });
  for (const auto& [block, modifiers] : changed)
    modifiers_[block] =
        special_of_block_[block] ? &special_[special_of_block_[block] - 1] : &plain_modifiers();

  for_chunks(team, gradient.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t a = begin; a < end; ++a)
      for (int d = 0; d < 3; ++d) gradient[a][d] -= forces_[3 * a + static_cast<std::size_t>(d)];
  });
  for (std::size_t c = 0; c < copies_.size(); ++c)
    for (int d = 0; d < 3; ++d)
      gradient[copies_[c].of][d] -= forces_[3 * (gradient.size() + c) + static_cast<std::size_t>(d)];
  for_chunks(team, forces_.size(), [&](std::size_t begin, std::size_t end) {
    std::fill(forces_.begin() + static_cast<std::ptrdiff_t>(begin),
              forces_.begin() + static_cast<std::ptrdiff_t>(end), 0.0);
  });
  return energy;
}

}  // namespace nanocarbon::annealing
