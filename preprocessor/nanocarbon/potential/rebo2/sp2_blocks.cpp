// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/rebo2/sp2_blocks.h"

#include <algorithm>

namespace nanocarbon::rebo2 {

namespace {

using Bonds = std::array<std::uint32_t, 3>;

double squared_distance(const potential::AtomsView& atoms, std::uint32_t i, std::uint32_t j) {
  double sum = 0.0;
  for (int d = 0; d < 3; ++d) {
    const double delta = atoms.positions[3 * std::size_t{j} + d] - atoms.positions[3 * std::size_t{i} + d];
    sum += delta * delta;
  }
  return sum;
}

//! Copies by how many steps along near pairs they are away from own atoms: 1 and 2.
std::array<std::vector<std::uint32_t>, 2> copies_by_shell(const potential::AtomsView& atoms,
                                                          const potential::NearPairs& near) {
  std::array<std::vector<std::uint32_t>, 2> shells;
  std::vector<bool> seen(atoms.all - atoms.own, false);
  const auto collect = [&](std::uint32_t from, std::vector<std::uint32_t>& shell) {
    for (const std::uint32_t to : near.of(from))
      if (to >= atoms.own && !seen[to - atoms.own]) {
        seen[to - atoms.own] = true;
        shell.push_back(to);
      }
  };
  for (std::uint32_t i = 0; i < atoms.own; ++i) collect(i, shells[0]);
  for (const std::uint32_t copy : shells[0]) collect(copy, shells[1]);
  for (auto& shell : shells) std::sort(shell.begin(), shell.end());
  return shells;
}

class Builder {
 public:
  Builder(const potential::AtomsView& atoms, const potential::NearPairs& near,
          const Rebo2Parameters& parameters)
      : atoms_(atoms), near_(near), bonds_(atoms.all), candidate_(atoms.all, false) {
    const PairParameters& pair = parameters.pairs[pair_index(Element::carbon, Element::carbon)];
    // Halfway into the window: an atom whose third neighbour is beyond is more likely two-coordinated.
    const double longest = 0.5 * (pair.cutoff_begin + pair.cutoff_end);
    longest_squared_ = longest * longest;
  }

  Sp2Blocks build() {
    const auto shells = copies_by_shell(atoms_, near_);
    std::vector<std::uint32_t> own_atoms(atoms_.own);
    for (std::uint32_t i = 0; i < atoms_.own; ++i) own_atoms[i] = i;
    const std::vector<std::uint32_t>& own = own_atoms;
    for (const auto* group : {&own, &shells[0]})
      for (const std::uint32_t i : *group) candidate_[i] = find_bonds(i);
    remove_triangles();

    blocks_.place.assign(atoms_.all, Sp2Blocks::nowhere);
    add_blocks(own);
    blocks_.own_blocks = blocks_.blocks;
    add_blocks(shells[0]);
    assign_slots();
    find_reverses();
    for (const auto* group : {&own, &shells[0]})
      for (const std::uint32_t i : *group) {
        if (candidate_[i])
          watch(i);
        else if (!near_.of(i).empty())
          blocks_.others.push_back(i);
      }
    for (const std::uint32_t i : shells[1])
      if (atoms_.elements[i] == Element::carbon && near_.of(i).size() > 3) blocks_.crowded.push_back(i);
    return std::move(blocks_);
  }

 private:
  //! The three nearest; false where they do not make a candidate.
  bool find_bonds(std::uint32_t i) {
    const auto row = near_.of(i);
    if (atoms_.elements[i] != Element::carbon || row.size() < 3) return false;
    std::array<double, 3> squared;
    squared.fill(std::numeric_limits<double>::infinity());
    Bonds& bonds = bonds_[i];
    for (const std::uint32_t j : row) {
      const double d = squared_distance(atoms_, i, j);
      if (d >= squared[2]) continue;
      int at = 2;
      for (; at > 0 && d < squared[at - 1]; --at) {
        squared[at] = squared[at - 1];
        bonds[at] = bonds[at - 1];
      }
      squared[at] = d;
      bonds[at] = j;
    }
    if (!(squared[2] < longest_squared_)) return false;
    return std::all_of(bonds.begin(), bonds.end(),
                       [&](std::uint32_t j) { return atoms_.elements[j] == Element::carbon; });
  }

  bool has_bond(std::uint32_t i, std::uint32_t j) const {
    return candidate_[i] && std::find(bonds_[i].begin(), bonds_[i].end(), j) != bonds_[i].end();
  }

  //! In a ring of three an atom would be both ends of a dihedral.
  void remove_triangles() {
    std::vector<std::uint32_t> removed;
    for (std::uint32_t i = 0; i < atoms_.all; ++i) {
      if (!candidate_[i]) continue;
      for (int s = 0; s < 3; ++s) {
        const std::uint32_t a = bonds_[i][s], b = bonds_[i][(s + 1) % 3];
        if (has_bond(a, b) || has_bond(b, a)) removed.insert(removed.end(), {i, a, b});
      }
    }
    for (const std::uint32_t i : removed) candidate_[i] = false;
  }

  void add_blocks(const std::vector<std::uint32_t>& group) {
    std::vector<std::uint32_t> members;
    for (const std::uint32_t i : group)
      if (candidate_[i]) members.push_back(i);
    for (std::size_t begin = 0; begin < members.size(); begin += sp2_block) {
      const std::size_t count = std::min(sp2_block, members.size() - begin);
      for (std::size_t l = 0; l < sp2_block; ++l)
        blocks_.atoms.push_back(members[begin + std::min(l, count - 1)]);
      for (int s = 0; s < 3; ++s)
        for (std::size_t l = 0; l < sp2_block; ++l)
          blocks_.neighbours.push_back(bonds_[members[begin + std::min(l, count - 1)]][s]);
      for (std::size_t l = 0; l < count; ++l)
        blocks_.place[members[begin + l]] = static_cast<std::uint32_t>(blocks_.blocks * sp2_block + l);
      blocks_.real.push_back(count == 32 ? ~0u : (1u << count) - 1u);
      ++blocks_.blocks;
    }
  }

  //! An own block's slot is free again when everything that its atoms are bonded to has been through both
  //! passes.
  void assign_slots() {
    std::size_t reach = 0;
    std::uint32_t most = 0;
    for (std::size_t block = 0; block < blocks_.own_blocks; ++block) {
      most = std::max(most, static_cast<std::uint32_t>(block + 1));
      for (std::size_t n = 0; n < 3 * sp2_block; ++n) {
        const std::uint32_t at = blocks_.place[blocks_.neighbours[block * 3 * sp2_block + n]];
        if (at == Sp2Blocks::nowhere || at / sp2_block >= blocks_.own_blocks) continue;
        const std::size_t other = at / sp2_block;
        most = std::max(most, static_cast<std::uint32_t>(other + 1));
        reach = std::max(reach, other > block ? other - block : block - other);
      }
      blocks_.needs.push_back(most);
    }
    const std::size_t turns =
        std::max<std::size_t>(1, std::min(blocks_.own_blocks, 2 * (reach + Sp2Blocks::window)));
    for (std::size_t block = 0; block < blocks_.blocks; ++block)
      blocks_.slots.push_back(static_cast<std::uint32_t>(
          block < blocks_.own_blocks ? block % turns : turns + block - blocks_.own_blocks));
    blocks_.slot_count = turns + blocks_.blocks - blocks_.own_blocks;
  }

  void find_reverses() {
    blocks_.reverses.assign(blocks_.neighbours.size(), blocks_.zero_record());
    for (std::uint32_t at = 0; at < blocks_.blocks * sp2_block; ++at)
      for (int s = 0; s < 3; ++s) {
        const std::uint32_t j = blocks_.neighbour(at, s);
        if (!candidate_[j]) continue;
        const auto back = std::find(bonds_[j].begin(), bonds_[j].end(), blocks_.atoms[at]);
        if (back == bonds_[j].end()) continue;
        const std::uint32_t slot = blocks_.slots[blocks_.place[j] / sp2_block];
        blocks_.reverses[Sp2Blocks::index(at, s)] =
            static_cast<std::uint32_t>(3 * (slot * sp2_block + blocks_.place[j] % sp2_block)) +
            static_cast<std::uint32_t>(back - bonds_[j].begin());
      }
  }

  void watch(std::uint32_t i) {
    for (const std::uint32_t j : near_.of(i))
      if (!has_bond(i, j) && (!candidate_[j] || i < j || has_bond(j, i))) blocks_.watched.push_back({i, j});
  }

  const potential::AtomsView& atoms_;
  const potential::NearPairs& near_;
  double longest_squared_;
  std::vector<Bonds> bonds_;
  std::vector<bool> candidate_;
  Sp2Blocks blocks_;
};

static_assert(sp2_block == 32, "Sp2Blocks::real has a bit for each lane");

}  // namespace

Sp2Blocks make_sp2_blocks(const potential::AtomsView& atoms, const potential::NearPairs& near,
                          const Rebo2Parameters& parameters) {
  return Builder(atoms, near, parameters).build();
}

}  // namespace nanocarbon::rebo2
