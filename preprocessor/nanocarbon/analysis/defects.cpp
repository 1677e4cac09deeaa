// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/analysis/defects.h"

#include <fmt/format.h>

#include <algorithm>

#include "nanocarbon/core/disjoint_sets.h"
#include "nanocarbon/core/space.h"

namespace nanocarbon::analysis {
namespace {

using Sizes = std::vector<std::uint32_t>;

// A bond of a ring by its atoms; which image it leads to is left out.
struct RingBond {
  std::uint64_t key;
  std::uint32_t ring;
  friend auto operator<=>(const RingBond&, const RingBond&) = default;
};

std::uint64_t key_of(AtomIndex a, AtomIndex b) {
  const auto [low, high] = std::minmax(a, b);
  return (std::uint64_t{low} << 32) | high;
}

std::pair<AtomIndex, AtomIndex> atoms_of(std::uint64_t key) {
  return {static_cast<AtomIndex>(key >> 32), static_cast<AtomIndex>(key)};
}

std::vector<RingBond> bonds_of_rings(const Rings& rings, const std::vector<std::uint32_t>& wanted) {
  std::vector<RingBond> bonds;
  for (const std::uint32_t r : wanted) {
    const auto ring = rings[r];
    for (std::size_t k = 0; k < ring.size(); ++k)
      bonds.push_back({key_of(ring[k], ring[(k + 1) % ring.size()]), r});
  }
  std::sort(bonds.begin(), bonds.end());
  return bonds;
}

class RingDefects {
 public:
  RingDefects(const BondRows& rows, const Rings& rings) : rows_(rows), rings_(rings) {}

  std::vector<Defect> find() {
    std::vector<std::uint32_t> unusual;
    for (std::uint32_t r = 0; r < rings_.size(); ++r)
      if (rings_[r].size() != 6) unusual.push_back(r);
    const std::vector<RingBond> bonds = bonds_of_rings(rings_, unusual);
    DisjointSets sets(rings_.size());
    for (std::size_t k = 1; k < bonds.size(); ++k)
      if (bonds[k].key == bonds[k - 1].key) sets.join(bonds[k - 1].ring, bonds[k].ring);
    std::sort(unusual.begin(), unusual.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::pair(sets.find(a), a) < std::pair(sets.find(b), b);
    });
    std::vector<Defect> defects;
    for (std::size_t k = 0; k < unusual.size(); ++k) {
      if (k == 0 || sets.find(unusual[k]) != sets.find(unusual[k - 1])) defects.emplace_back();
      defects.back().rings.push_back(unusual[k]);
    }
    for (Defect& defect : defects) describe(defect);
    return defects;
  }

 private:
  void describe(Defect& defect) {
    for (const std::uint32_t r : defect.rings) {
      defect.ring_sizes.push_back(static_cast<std::uint32_t>(rings_[r].size()));
      defect.atoms.insert(defect.atoms.end(), rings_[r].begin(), rings_[r].end());
    }
    std::sort(defect.ring_sizes.begin(), defect.ring_sizes.end());
    std::sort(defect.atoms.begin(), defect.atoms.end());
    defect.atoms.erase(std::unique(defect.atoms.begin(), defect.atoms.end()), defect.atoms.end());
    defect.kind = kind_of(defect);
  }

  std::string kind_of(const Defect& defect) {
    const Sizes& sizes = defect.ring_sizes;
    if (sizes == Sizes{5, 9} && two_bonded(defect) == 1) return "vacancy";
    if (sizes == Sizes{12} && two_bonded(defect) == 3) return "vacancy";
    if (sizes.size() == 1) {
      if (sizes[0] == 4) return "square";
      if (sizes[0] == 5) return "pentagon";
      if (sizes[0] == 7) return "heptagon";
      if (sizes[0] == 8) return "octagon";
      return fmt::format("ring of {}", sizes[0]);
    }
    if (sizes == Sizes{5, 7}) return "5-7 pair";
    if (sizes == Sizes{5, 5, 7, 7}) return is_stone_wales(defect) ? "Stone-Wales" : "two 5-7 pairs";
    if (sizes == Sizes{5, 5, 8}) return "divacancy 5-8-5";
    if (sizes == Sizes{5, 5, 5, 7, 7, 7} && around_one_atom(defect)) return "divacancy 555-777";
    if (sizes == Sizes{5, 5, 5, 5, 7, 7, 7, 7} && around_hexagon(defect)) return "divacancy 5555-6-7777";
    return fmt::format("cluster of {} rings", sizes.size());
  }

  std::size_t two_bonded(const Defect& defect) const {
    return static_cast<std::size_t>(std::count_if(defect.atoms.begin(), defect.atoms.end(),
                                                  [&](AtomIndex a) { return rows_.degree(a) == 2; }));
  }

  bool holds(std::uint32_t ring, AtomIndex atom) const {
    const auto atoms = rings_[ring];
    return std::find(atoms.begin(), atoms.end(), atom) != atoms.end();
  }

  std::size_t rings_of(const Defect& defect, AtomIndex atom, std::size_t size) const {
    return static_cast<std::size_t>(
        std::count_if(defect.rings.begin(), defect.rings.end(),
                      [&](std::uint32_t r) { return rings_[r].size() == size && holds(r, atom); }));
  }

  // The two heptagons share a bond, and a pentagon is at each of its ends.
  bool is_stone_wales(const Defect& defect) const {
    const std::vector<RingBond> bonds = bonds_of_rings(rings_, defect.rings);
    for (std::size_t k = 1; k < bonds.size(); ++k) {
      if (bonds[k].key != bonds[k - 1].key || rings_[bonds[k].ring].size() != 7 ||
          rings_[bonds[k - 1].ring].size() != 7)
        continue;
      const auto [a, b] = atoms_of(bonds[k].key);
      if (rings_of(defect, a, 5) == 1 && rings_of(defect, b, 5) == 1) return true;
    }
    return false;
  }

  bool around_one_atom(const Defect& defect) const {
    return std::any_of(defect.atoms.begin(), defect.atoms.end(),
                       [&](AtomIndex a) { return rings_of(defect, a, 7) == 3; });
  }

  // The hexagon in the middle: all its bonds are other rings' as well.
  bool around_hexagon(const Defect& defect) {
    if (hexagons_.empty()) {
      for (std::uint32_t r = 0; r < rings_.size(); ++r)
        if (rings_[r].size() == 6)
          for (const AtomIndex a : rings_[r]) hexagons_.emplace_back(a, r);
      std::sort(hexagons_.begin(), hexagons_.end());
    }
    for (const AtomIndex a : defect.atoms) {
      if (rings_of(defect, a, 5) + rings_of(defect, a, 7) != 2) continue;
      const auto [first, last] =
          std::equal_range(hexagons_.begin(), hexagons_.end(), std::pair(a, 0u),
                           [](const auto& x, const auto& y) { return x.first < y.first; });
      for (auto hexagon = first; hexagon != last; ++hexagon) {
        const auto atoms = rings_[hexagon->second];
        if (std::all_of(atoms.begin(), atoms.end(),
                        [&](AtomIndex b) { return rings_of(defect, b, 5) + rings_of(defect, b, 7) == 2; }))
          return true;
      }
    }
    return false;
  }

  const BondRows& rows_;
  const Rings& rings_;
  std::vector<std::pair<AtomIndex, std::uint32_t>> hexagons_;  // by atom, made where they are asked for
};

void add_holes(const BondRows& rows, const Rings& holes, std::vector<Defect>& defects) {
  for (std::size_t h = 0; h < holes.size(); ++h) {
    std::vector<AtomIndex> atoms(holes[h].begin(), holes[h].end());
    std::sort(atoms.begin(), atoms.end());
    atoms.erase(std::unique(atoms.begin(), atoms.end()), atoms.end());
    const auto open =
        std::count_if(atoms.begin(), atoms.end(), [&](AtomIndex a) { return rows.degree(a) == 2; });
    std::string kind =
        atoms.size() == 14 && open == 4 ? "open divacancy" : fmt::format("hole of {} atoms", atoms.size());
    defects.push_back({std::move(kind), {}, {}, std::move(atoms), {}});
  }
}

bool are_bonded(const BondRows& rows, AtomIndex a, AtomIndex b) {
  const auto ends = rows.of(a);
  return std::any_of(ends.begin(), ends.end(), [&](const BondRowEnd& end) { return end.atom == b; });
}

// Bonds that lie on a ring of at most eight, sorted.
std::vector<std::uint64_t> bonds_on_small_rings(const Rings& rings) {
  std::vector<std::uint64_t> keys;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const auto ring = rings[r];
    if (ring.size() > 8) continue;
    for (std::size_t k = 0; k < ring.size(); ++k)
      keys.push_back(key_of(ring[k], ring[(k + 1) % ring.size()]));
  }
  std::sort(keys.begin(), keys.end());
  return keys;
}

void add_single_atoms(const Molecule& molecule, const BondRows& rows, std::vector<Defect>& defects) {
  for (AtomIndex a = 0; a < molecule.size(); ++a) {
    if (molecule.elements[a] != Element::carbon) continue;
    const auto ends = rows.of(a);
    if (ends.size() == 1) defects.push_back({"carbon with one bond", {}, {}, {a}, {}});
    if (ends.size() >= 5)
      defects.push_back({fmt::format("carbon with {} bonds", ends.size()), {}, {}, {a}, {}});
    if (ends.size() == 2 && are_bonded(rows, ends[0].atom, ends[1].atom))
      defects.push_back({"adatom", {}, {}, {a}, {}});
  }
}

void add_crosslinks(const Molecule& molecule, const BondRows& rows, const MoleculeComponents& components,
                    std::vector<Defect>& defects) {
  if (components.all_surfaces()) return;  // no carbon of a surface has four
  const std::vector<std::uint64_t> inside = bonds_on_small_rings(components.rings);
  for (const Bond& bond : molecule.bonds)
    if (rows.degree(bond.first) == 4 && rows.degree(bond.second) == 4 && bond.first != bond.second &&
        molecule.elements[bond.first] == Element::carbon &&
        molecule.elements[bond.second] == Element::carbon &&
        components.list[components.of_atom[bond.first]].rings != RingKind::none &&
        !std::binary_search(inside.begin(), inside.end(), key_of(bond.first, bond.second)))
      defects.push_back({"crosslink", {}, {}, {bond.first, bond.second}, {}});
}

}  // namespace

std::vector<Defect> find_defects(const Molecule& molecule, const BondRows& rows,
                                 const MoleculeComponents& components) {
  std::vector<Defect> defects = RingDefects(rows, components.rings).find();
  add_holes(rows, components.holes, defects);
  add_single_atoms(molecule, rows, defects);
  add_crosslinks(molecule, rows, components, defects);
  const Space space = molecule.cell ? Space(*molecule.cell) : Space();
  for (Defect& defect : defects) {
    const Vec3& anchor = molecule.positions[defect.atoms.front()];
    Vec3 sum = Vec3::Zero();
    for (const AtomIndex a : defect.atoms) sum += space.displacement(anchor, molecule.positions[a]);
    defect.position = space.wrapped(anchor + sum / static_cast<double>(defect.atoms.size()));
  }
  std::stable_sort(defects.begin(), defects.end(), [](const Defect& a, const Defect& b) {
    return std::pair(std::string_view(a.kind), a.atoms.front()) <
           std::pair(std::string_view(b.kind), b.atoms.front());
  });
  return defects;
}

}  // namespace nanocarbon::analysis
