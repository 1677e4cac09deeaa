// SPDX-License-Identifier: GPL-2.0-or-later
#include "bond_topology/local_bonds.h"

#include <algorithm>

#include "nanocarbon/core/neighbours_within.h"

namespace nanocarbon {
namespace {

Vec3 position(const RankAtoms& atoms, int atom) {
  return Vec3::Map(atoms.positions + 3 * static_cast<std::ptrdiff_t>(atom));
}

Element element(const RankAtoms& atoms, int atom) { return atoms.element_of_type[atoms.types[atom]]; }

double widest(const topology::BondDistances& distances) {
  return std::max({distances.carbon_carbon.breaking, distances.carbon_hydrogen.breaking,
                   distances.hydrogen_hydrogen.breaking});
}

// Whether a pair is kept with this atom: the other has a higher ID, or is its own image in one half of all
// directions.
bool kept_here(std::int64_t id, std::int64_t other, const Vec3& towards) {
  if (id != other) return id < other;
  for (int axis = 0; axis < 3; ++axis)
    if (towards[axis] != 0.0) return towards[axis] > 0.0;
  return false;
}

double squared_reach(const RankAtoms& atoms, int atom, int other, bool before,
                     const topology::BondDistances& distances) {
  const topology::BondWindow& window = distances.of(element(atoms, atom), element(atoms, other));
  const double reach = before ? window.breaking : window.form;
  return reach * reach;
}

struct Near {
  int atom;
  double square;
};

// Splitmix64's finaliser.
std::uint64_t mixed(std::uint64_t value) {
  value += 0x9e3779b97f4a7c15u;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9u;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebu;
  return value ^ (value >> 31);
}

std::uint64_t hash_of(std::int64_t first, std::int64_t second, bool bonded) {
  return mixed(mixed(mixed(static_cast<std::uint64_t>(first)) + static_cast<std::uint64_t>(second)) + bonded);
}

// Of one atom: its neighbours that are bonded, the nearest first where an ID is near several times, then the
// others that could bond.
void add_candidates(int atom, const std::vector<Near>& near, const Partners& partners, const RankAtoms& atoms,
                    const topology::BondDistances& distances, double skin, CandidateBonds& candidates) {
  std::array<bool, Partners::most> met = {};
  for (const Near& other : near) {
    bool bonded = false;
    for (int k = 0; k < partners.count && !bonded; ++k)
      if (!met[k] && partners.ids[k] == atoms.ids[other.atom]) bonded = met[k] = true;
    const double reach = distances.of(element(atoms, atom), element(atoms, other.atom)).form + skin;
    if (bonded || other.square < reach * reach)
      candidates.pairs.push_back(
          {atom, other.atom, squared_reach(atoms, atom, other.atom, bonded, distances), bonded, bonded});
  }
  for (int k = 0; k < partners.count; ++k)
    if (!met[k]) candidates.parted.push_back({atoms.ids[atom], partners.ids[k]});
}

}  // namespace

CandidateBonds find_candidates(const RankAtoms& atoms, std::span<const Partners> partners,
                               const topology::BondDistances& distances, double skin) {
  std::vector<int> watched;
  std::vector<Vec3> places;
  for (int atom = 0; atom < atoms.all; ++atom) {
    if (atoms.ids[atom] == 0) continue;
    watched.push_back(atom);
    places.push_back(position(atoms, atom));
  }
  const NeighbourList neighbours = neighbours_within(places, nullptr, widest(distances) + skin);

  CandidateBonds result;
  std::vector<Near> near;
  for (std::size_t row = 0; row < watched.size() && watched[row] < atoms.owned; ++row) {
    const int atom = watched[row];
    near.clear();
    for (const Neighbour& neighbour : neighbours.of(row)) {
      const int other = watched[neighbour.atom];
      const Vec3 towards = places[neighbour.atom] - places[row];
      if (kept_here(atoms.ids[atom], atoms.ids[other], towards))
        near.push_back({other, towards.squaredNorm()});
    }
    std::sort(near.begin(), near.end(), [&](const Near& a, const Near& b) {
      return atoms.ids[a.atom] != atoms.ids[b.atom] ? atoms.ids[a.atom] < atoms.ids[b.atom]
                                                    : a.square < b.square;
    });
    add_candidates(atom, near, partners[atom], atoms, distances, skin, result);
  }
  return result;
}

LocalChanges look(CandidateBonds& candidates, const RankAtoms& atoms) {
  LocalChanges changes;
  for (const topology::BondedIds& bond : candidates.parted) {
    ++changes.count;
    changes.hash += hash_of(bond.first, bond.second, false);
  }
  for (CandidateBond& pair : candidates.pairs) {
    pair.now = (position(atoms, pair.other) - position(atoms, pair.owned)).squaredNorm() < pair.squared_reach;
    if (pair.now == pair.before) continue;
    ++changes.count;
    changes.hash += hash_of(atoms.ids[pair.owned], atoms.ids[pair.other], pair.now);
  }
  return changes;
}

void adopt(CandidateBonds& candidates, const RankAtoms& atoms, const topology::BondDistances& distances,
           std::span<Partners> partners) {
  for (int atom = 0; atom < atoms.owned; ++atom) partners[atom].count = 0;
  for (CandidateBond& pair : candidates.pairs) {
    if (pair.now) partners[pair.owned].add(atoms.ids[pair.other]);
    if (pair.now == pair.before) continue;
    pair.before = pair.now;
    pair.squared_reach = squared_reach(atoms, pair.owned, pair.other, pair.before, distances);
  }
  candidates.parted.clear();
}

}  // namespace nanocarbon
