// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/analysis/frame_comparison.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace nanocarbon::analysis {
namespace {

std::optional<AtomIndex> index_of(std::span<const std::int64_t> ids, std::int64_t id) {
  const auto found = std::lower_bound(ids.begin(), ids.end(), id);
  if (found == ids.end() || *found != id) return std::nullopt;
  return static_cast<AtomIndex>(found - ids.begin());
}

// The bonds of the frame before by this frame's indices.
std::vector<Bond> carried_over(const NamedBonds& before, std::span<const std::int64_t> ids) {
  if (std::equal(ids.begin(), ids.end(), before.ids.begin(), before.ids.end())) return before.bonds;
  std::vector<Bond> bonds;
  for (const Bond& bond : before.bonds) {
    const auto first = index_of(ids, before.ids[bond.first]), second = index_of(ids, before.ids[bond.second]);
    if (first && second) bonds.push_back({*first, *second, bond.image});
  }
  return bonds;  // IDs ascend in both, so they are still sorted
}

}  // namespace

NamedBonds frame_bonds(const Molecule& molecule, std::span<const std::int64_t> ids,
                       const topology::BondDistances& distances, const NamedBonds* before) {
  NamedBonds result;
  result.ids.assign(ids.begin(), ids.end());
  const std::vector<Bond> previous = before ? carried_over(*before, ids) : std::vector<Bond>();
  result.bonds = topology::bonds_within(molecule.positions, molecule.elements,
                                        molecule.cell ? &*molecule.cell : nullptr, distances, previous);
  result.named.reserve(result.bonds.size());
  for (const Bond& bond : result.bonds) result.named.push_back({ids[bond.first], ids[bond.second]});
  std::sort(result.named.begin(), result.named.end());
  return result;
}

FrameChange compare_frames(const NamedBonds& start, const topology::SurfaceTopology& start_surface,
                           const NamedBonds& now, const topology::SurfaceTopology& now_surface) {
  FrameChange result;
  result.changes = topology::compare_bonds(start.named, now.named);
  std::set_difference(start.ids.begin(), start.ids.end(), now.ids.begin(), now.ids.end(),
                      std::back_inserter(result.lost));
  std::set_difference(now.ids.begin(), now.ids.end(), start.ids.begin(), start.ids.end(),
                      std::back_inserter(result.added));
  std::vector<std::uint32_t> components(start.ids.size(), topology::no_component);
  for (std::size_t s = 0, n = 0; s < start.ids.size() && n < now.ids.size();) {
    if (start.ids[s] == now.ids[n])
      components[s++] = now_surface.component_of_atom[n++];
    else
      ++(start.ids[s] < now.ids[n] ? s : n);
  }
  const std::vector<bool> repelled = topology::repelled_atoms(start_surface.component_of_atom, components);
  for (std::size_t s = 0; s < start.ids.size(); ++s)
    if (repelled[s]) result.repelled.push_back(start.ids[s]);
  topology::Judgement judgement =
      topology::judge(start_surface, now_surface, result.changes.none(), result.lost.size());
  result.verdict = judgement.verdict;
  result.reason = std::move(judgement.reason);
  return result;
}

FrameStep compare_with_before(const NamedBonds& before, const NamedBonds& now) {
  const topology::BondChanges changes = topology::compare_bonds(before.named, now.named);
  std::vector<std::int64_t> kept;
  std::set_intersection(before.ids.begin(), before.ids.end(), now.ids.begin(), now.ids.end(),
                        std::back_inserter(kept));
  return {changes.broken.size(), changes.formed.size(), before.ids.size() - kept.size(),
          now.ids.size() - kept.size()};
}

std::vector<AtomFate> atom_fates(std::span<const std::int64_t> ids, const FrameChange& change) {
  std::vector<AtomFate> fates(ids.size(), AtomFate::unchanged);
  const auto mark = [&](std::int64_t id, AtomFate fate) {
    if (const auto index = index_of(ids, id)) fates[*index] = fate;
  };
  for (const auto* bonds : {&change.changes.broken, &change.changes.formed})
    for (const topology::BondedIds& bond : *bonds) {
      mark(bond.first, AtomFate::rebonded);
      mark(bond.second, AtomFate::rebonded);
    }
  for (const std::int64_t id : change.repelled) mark(id, AtomFate::repelled);
  return fates;
}

}  // namespace nanocarbon::analysis
