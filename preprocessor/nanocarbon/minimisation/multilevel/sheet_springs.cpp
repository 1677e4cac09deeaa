// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/minimisation/multilevel/sheet_springs.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace nanocarbon::multilevel {

namespace {

constexpr double loose_stiffness = 1;  // eV/Angstrom^2
// Keeps the matrix definite: far below what bends the largest sheet least, 1e-8 for a million atoms; eV/Angstrom^2.
constexpr double anchor = 1e-9;
// A third of what graphite has across its sheets: 0.18 for each atom, of its elastic constant c33 of 37 GPa.
constexpr double anchor_of_several = 0.06;

NodeGraph within_two_bonds(const NodeGraph& bonds) {
  NodeGraph result;
  result.nodes.reserve(10 * bonds.size());
  std::vector<std::uint32_t> row;
  for (std::uint32_t a = 0; a < bonds.size(); ++a) {
    row.assign(1, a);
    for (const std::uint32_t n : bonds.of(a)) {
      row.push_back(n);
      for (const std::uint32_t m : bonds.of(n)) row.push_back(m);
    }
    std::sort(row.begin(), row.end());
    result.nodes.insert(result.nodes.end(), row.begin(), std::unique(row.begin(), row.end()));
    result.offsets.push_back(static_cast<std::uint32_t>(result.nodes.size()));
  }
  return result;
}

}  // namespace

SheetSprings::SheetSprings(NodeGraph bonds, const SheetStiffness& stiffness)
    : bonds_(std::move(bonds)), pattern_(within_two_bonds(bonds_)), stiffness_(stiffness) {
  const auto bends = [&](std::uint32_t a) { return bonds_.of(a).size() == 3; };
  for (std::uint32_t a = 0; a < bonds_.size(); ++a) {
    const auto near = bonds_.of(a);
    loose_.push_back(!bends(a) && std::none_of(near.begin(), near.end(), bends));
  }
  anchor_ = is_connected(bonds_) ? anchor : anchor_of_several;
}

void SheetSprings::set(const Space& space, std::span<const Vec3> positions, const Holds& holds) {
  space_ = space;
  positions_.assign(positions.begin(), positions.end());
  holds_ = holds;
  normals_.assign(positions.size(), Vec3::Zero());
  for (std::size_t a = 0; a < positions.size(); ++a) {
    const auto near = bonds_.of(a);
    if (near.size() != 3) continue;
    const Vec3 first = space_.displacement(positions[near[0]], positions[near[1]]),
               second = space_.displacement(positions[near[0]], positions[near[2]]);
    const Vec3 across = first.cross(second);
    const double length = across.norm();
    if (length > 1e-6) normals_[a] = across / length;
  }
}

void SheetSprings::row(std::size_t atom, std::vector<Block>& blocks) const {
  const auto coupled = pattern_.of(atom);
  blocks.assign(coupled.size(), Block{});
  const auto block_of = [&](std::uint32_t other) -> Block& {
    std::size_t k = 0;
    while (coupled[k] != other) ++k;
    return blocks[k];
  };
  Block own = {};
  const auto add_spring = [&](std::uint32_t other, double stiffness) {
    const Vec3 away = space_.displacement(positions_[atom], positions_[other]);
    const double squared = std::max(away.squaredNorm(), 1e-6);
    const Block spring = dyad(away, stiffness / squared);
    add(own, 1, spring);
    add(block_of(other), -1, spring);
  };
  const auto add_soft_bond = [&](std::uint32_t other) {
    const Block soft = multiple_of_identity(loose_stiffness);
    add(own, 1, soft);
    add(block_of(other), -1, soft);
  };
  const auto add_height = [&](std::uint32_t centre, double share) {
    const Block height = dyad(normals_[centre], share * stiffness_.height);
    add(centre == atom ? own : block_of(centre), 1, height);
    for (const std::uint32_t n : bonds_.of(centre)) add(n == atom ? own : block_of(n), -1.0 / 3, height);
  };
  add_height(static_cast<std::uint32_t>(atom), 1);
  for (const std::uint32_t n : bonds_.of(atom)) {
    add_spring(n, stiffness_.bond);
    if (loose_[atom] || loose_[n]) add_soft_bond(n);
    add_height(n, -1.0 / 3);
    for (const std::uint32_t m : bonds_.of(n))
      if (m != atom) add_spring(m, stiffness_.second_neighbour);
  }
  if (!holds_.empty()) add(own, 1, dyad(holds_[atom], 1));
  add(own, bonds_.of(atom).empty() ? loose_stiffness : anchor_, multiple_of_identity(1));
  add(block_of(static_cast<std::uint32_t>(atom)), 1, own);
}

}  // namespace nanocarbon::multilevel
