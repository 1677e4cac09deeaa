// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/topology/bond_graph.h"

#include <algorithm>

#include "nanocarbon/core/neighbours_within.h"

namespace nanocarbon::topology {
namespace {

// Each pair once: from its lower atom, and of an atom's bonds with its own images one of each opposite two.
bool is_listed_from(AtomIndex atom, const Neighbour& neighbour) {
  if (neighbour.atom != atom) return neighbour.atom > atom;
  return neighbour.image > std::array<std::int32_t, 3>{0, 0, 0};
}

struct Candidate {
  Neighbour neighbour;
  double squared_distance;
};

double square(double x) { return x * x; }

// Of the images of one atom: all that are close enough to form a bond, then the nearest as long as there were
// more before.
void append_bonds(AtomIndex atom, std::span<Candidate> images, const BondWindow& window, std::size_t before,
                  std::vector<Bond>& bonds) {
  std::sort(images.begin(), images.end(), [](const Candidate& a, const Candidate& b) {
    if (a.squared_distance != b.squared_distance) return a.squared_distance < b.squared_distance;
    return a.neighbour.image < b.neighbour.image;
  });
  const std::size_t first = bonds.size();
  for (std::size_t k = 0; k < images.size(); ++k) {
    const double reach = square(k < before ? window.breaking : window.form);
    if (images[k].squared_distance >= reach) break;
    bonds.push_back({atom, images[k].neighbour.atom, images[k].neighbour.image});
  }
  std::sort(bonds.begin() + static_cast<std::ptrdiff_t>(first), bonds.end());
}

double longest(const BondDistances& d, std::span<const Element> elements) {
  const bool carbon = std::find(elements.begin(), elements.end(), Element::carbon) != elements.end();
  const bool hydrogen = std::find(elements.begin(), elements.end(), Element::hydrogen) != elements.end();
  double reach = 0.0;
  const auto include = [&](const BondWindow& w) { reach = std::max({reach, w.form, w.breaking}); };
  if (carbon) include(d.carbon_carbon);
  if (hydrogen) include(d.hydrogen_hydrogen);
  if (carbon && hydrogen) include(d.carbon_hydrogen);
  return reach;
}

}  // namespace

std::vector<Bond> bonds_within(std::span<const Vec3> positions, std::span<const Element> elements,
                               const Cell* cell, const BondDistances& distances,
                               std::span<const Bond> previous) {
  std::vector<Bond> bonds;
  const double reach = longest(distances, elements);
  if (positions.empty() || reach <= 0.0) return bonds;
  const NeighbourList near = neighbours_within(positions, cell, reach);
  bonds.reserve(near.neighbours.size() / 2);
  std::vector<Candidate> row;
  auto before = previous.begin();
  for (AtomIndex i = 0; i < positions.size(); ++i) {
    row.clear();
    for (const Neighbour& n : near.of(i)) {
      if (!is_listed_from(i, n)) continue;
      Vec3 delta = positions[n.atom] - positions[i];
      if (cell) delta += image_shift(*cell, n.image);
      row.push_back({n, delta.squaredNorm()});
    }
    for (std::size_t k = 0; k < row.size();) {
      const AtomIndex j = row[k].neighbour.atom;
      std::size_t end = k;
      while (end < row.size() && row[end].neighbour.atom == j) ++end;
      const auto is_before = [&](const Bond& b) { return b.first < i || (b.first == i && b.second < j); };
      while (before != previous.end() && is_before(*before)) ++before;
      std::size_t count = 0;
      while (before != previous.end() && before->first == i && before->second == j) ++before, ++count;
      append_bonds(i, {row.data() + k, end - k}, distances.of(elements[i], elements[j]), count, bonds);
      k = end;
    }
  }
  return bonds;
}

BondChanges compare_bonds(std::span<const BondedIds> start, std::span<const BondedIds> now) {
  BondChanges changes;
  std::set_difference(start.begin(), start.end(), now.begin(), now.end(), std::back_inserter(changes.broken));
  std::set_difference(now.begin(), now.end(), start.begin(), start.end(), std::back_inserter(changes.formed));
  return changes;
}

std::vector<BondedIds> bonded_ids(std::span<const Bond> bonds) {
  std::vector<BondedIds> ids;
  ids.reserve(bonds.size());
  for (const Bond& bond : bonds) ids.push_back({bond.first, bond.second});
  return ids;
}

std::vector<bool> repelled_atoms(std::span<const std::uint32_t> initial, std::span<const std::uint32_t> now) {
  // Atoms in rows by their initial component, in ascending order.
  const std::uint32_t rows = initial.empty() ? 0 : *std::max_element(initial.begin(), initial.end()) + 1;
  std::vector<std::uint32_t> start(rows + 1, 0), atoms(initial.size());
  for (const std::uint32_t component : initial) ++start[component + 1];
  for (std::uint32_t r = 0; r < rows; ++r) start[r + 1] += start[r];
  std::vector<std::uint32_t> fill(start.begin(), start.end() - 1);
  for (std::uint32_t a = 0; a < initial.size(); ++a) atoms[fill[initial[a]]++] = a;

  std::uint32_t components = 0;
  for (const std::uint32_t component : now)
    if (component != no_component) components = std::max(components, component + 1);
  std::vector<std::uint32_t> count(components, 0);
  std::vector<bool> repelled(initial.size(), false);
  for (std::uint32_t r = 0; r < rows; ++r) {
    const std::span<const std::uint32_t> row(atoms.data() + start[r], start[r + 1] - start[r]);
    for (const std::uint32_t a : row)
      if (now[a] != no_component) ++count[now[a]];
    std::uint32_t home = no_component;
    for (const std::uint32_t a : row)
      if (now[a] != no_component && (home == no_component || count[now[a]] > count[home])) home = now[a];
    for (const std::uint32_t a : row) repelled[a] = now[a] == no_component || now[a] != home;
    for (const std::uint32_t a : row)
      if (now[a] != no_component) count[now[a]] = 0;
  }
  return repelled;
}

}  // namespace nanocarbon::topology
