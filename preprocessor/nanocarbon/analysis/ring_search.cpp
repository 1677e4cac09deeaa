// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/analysis/ring_search.h"

#include <algorithm>

#include "nanocarbon/core/thread_team.h"

namespace nanocarbon::analysis {
namespace {

std::uint64_t hash_of(AtomIndex atom, const std::array<std::int32_t, 3>& image) {
  std::uint64_t h = atom;
  for (const std::int32_t i : image) h = (h ^ static_cast<std::uint32_t>(i)) * 0x9e3779b97f4a7c15ull;
  return h ^ (h >> 29);
}

}  // namespace

UnfoldedSurroundings::UnfoldedSurroundings(const BondRows& rows) : rows_(rows), table_(1024, none) {}

void UnfoldedSurroundings::start(AtomIndex atom) {
  if (places_.size() * 8 > table_.size()) {
    std::fill(table_.begin(), table_.end(), none);
  } else {
    for (const Place& place : places_) {  // cheaper than all of the table
      std::size_t slot = hash_of(place.atom, place.image) & (table_.size() - 1);
      while (table_[slot] != none) table_[slot] = none, slot = (slot + 1) & (table_.size() - 1);
    }
  }
  places_.clear();
  links_.clear();
  place_of(atom, {0, 0, 0});
}

void UnfoldedSurroundings::grow_table() {
  table_.assign(2 * table_.size(), none);
  for (std::uint32_t p = 0; p < places_.size(); ++p) {
    std::size_t slot = hash_of(places_[p].atom, places_[p].image) & (table_.size() - 1);
    while (table_[slot] != none) slot = (slot + 1) & (table_.size() - 1);
    table_[slot] = p;
  }
}

std::uint32_t UnfoldedSurroundings::place_of(AtomIndex atom, const std::array<std::int32_t, 3>& image) {
  std::size_t slot = hash_of(atom, image) & (table_.size() - 1);
  for (; table_[slot] != none; slot = (slot + 1) & (table_.size() - 1)) {
    const Place& place = places_[table_[slot]];
    if (place.atom == atom && place.image == image) return table_[slot];
  }
  const auto found = static_cast<std::uint32_t>(places_.size());
  places_.push_back({atom, image, none, none});
  if (reached_.size() < places_.size()) reached_.resize(2 * places_.size(), 0);
  table_[slot] = found;
  if (2 * places_.size() > table_.size()) grow_table();
  return found;
}

std::span<const std::uint32_t> UnfoldedSurroundings::neighbours(std::uint32_t place) {
  if (places_[place].first == none) {
    const AtomIndex atom = places_[place].atom;
    const std::array<std::int32_t, 3> image = places_[place].image;
    const auto first = static_cast<std::uint32_t>(links_.size());
    for (const BondRowEnd& end : rows_.of(atom)) {
      std::array<std::int32_t, 3> there = image;
      for (int d = 0; d < 3; ++d) there[d] += end.image[d];
      links_.push_back(place_of(end.atom, there));
    }
    places_[place].first = first;
    places_[place].last = static_cast<std::uint32_t>(links_.size());
  }
  return {links_.data() + places_[place].first, links_.data() + places_[place].last};
}

bool UnfoldedSurroundings::is_nearer(std::uint32_t from, std::uint32_t to, int bonds, std::uint32_t avoided) {
  if (bonds <= 0) return false;
  if (from == to) return true;
  call_ += 2;  // marks of this call: call_ and call_ + 1
  front_[0].assign(1, from);
  front_[1].assign(1, to);
  reached_[from] = call_;
  reached_[to] = call_ + 1;
  if (avoided != none) reached_[avoided] = 0;
  for (int length = 1; length < bonds; ++length) {
    const int side = front_[1].size() < front_[0].size();
    after_.clear();
    for (const std::uint32_t place : front_[side])
      for (const std::uint32_t next : neighbours(place)) {
        if (next == avoided) continue;
        if (reached_[next] == call_ + (1 - side)) return true;
        if (reached_[next] == call_ + side) continue;
        reached_[next] = call_ + side;
        after_.push_back(next);
      }
    front_[side].swap(after_);
    if (front_[side].empty()) return false;
  }
  return false;
}

void FoundRings::add(UnfoldedSurroundings& surroundings, std::span<const std::uint32_t> ring) {
  const AtomIndex origin = surroundings.atom(0);
  std::vector<std::uint32_t> names;  // of the atoms along the ring
  names.reserve(ring.size());
  for (const std::uint32_t place : ring) names.push_back(surroundings.atom(place));
  // A ring that passes several images of its atom is found at each of them. It is known by its bonds, as the rows
  // number them, in the order along the ring.
  if (std::count(names.begin(), names.end(), origin) > 1) {
    const std::size_t size = ring.size();
    std::vector<std::uint32_t> forwards, backwards;
    const auto step = [&](std::uint32_t a, std::uint32_t b) {
      const auto near = surroundings.neighbours(a);
      return static_cast<std::uint32_t>(std::find(near.begin(), near.end(), b) - near.begin());
    };
    for (std::size_t k = 0; k < size; ++k) {
      const std::uint32_t a = ring[k], b = ring[(k + 1) % size];
      forwards.insert(forwards.end(), {names[k], step(a, b)});
      const std::uint32_t c = ring[size - 1 - k], d = ring[(2 * size - 2 - k) % size];
      backwards.insert(backwards.end(), {names[size - 1 - k], step(c, d)});
    }
    std::vector<std::uint32_t> least = forwards;
    for (auto* way : {&forwards, &backwards})
      for (std::size_t k = 0; k < size; ++k) {
        std::rotate(way->begin(), way->begin() + 2, way->end());
        least = std::min(least, *way);
      }
    if (std::find(repeated_.begin(), repeated_.end(), least) != repeated_.end()) return;
    repeated_.push_back(least);
  }
  atoms.insert(atoms.end(), names.begin(), names.end());
  offsets.push_back(static_cast<std::uint32_t>(atoms.size()));
}

RingStatistics search_at_all_atoms(const BondRows& rows, const RingSearchOptions& options,
                                   const std::function<RingsAtAtom()>& make_search) {
  constexpr std::size_t block = 2048;
  const std::size_t blocks = (rows.atoms() + block - 1) / block;
  struct Worker {
    UnfoldedSurroundings surroundings;
    RingsAtAtom search;
    FoundRings found;
  };
  ThreadTeam team(std::max(1u, options.threads));
  std::vector<Worker> workers;
  for (unsigned t = 0; t < team.size(); ++t)
    workers.push_back({UnfoldedSurroundings(rows), make_search(), FoundRings()});
  std::vector<Rings> found(blocks);
  team.run(blocks, [&](std::size_t b, unsigned thread) {
    Worker& worker = workers[thread];
    const std::size_t end = std::min(rows.atoms(), (b + 1) * block);
    for (std::size_t a = b * block; a < end; ++a) {
      if (rows.degree(static_cast<AtomIndex>(a)) < 2) continue;
      worker.found.clear();
      worker.surroundings.start(static_cast<AtomIndex>(a));
      worker.search(worker.surroundings, worker.found);
      const auto before = static_cast<std::uint32_t>(found[b].atoms.size());
      found[b].atoms.insert(found[b].atoms.end(), worker.found.atoms.begin(), worker.found.atoms.end());
      for (std::size_t r = 1; r < worker.found.offsets.size(); ++r)
        found[b].offsets.push_back(before + worker.found.offsets[r]);
    }
  });
  RingStatistics result;
  result.counts.assign(static_cast<std::size_t>(options.max_ring) + 1, 0);
  for (Rings& some : found) {
    for (std::size_t r = 0; r < some.size(); ++r) {
      ++result.counts[some[r].size()];
      result.rings.atoms.insert(result.rings.atoms.end(), some[r].begin(), some[r].end());
      result.rings.offsets.push_back(static_cast<std::uint32_t>(result.rings.atoms.size()));
    }
    some = {};
  }
  return result;
}

std::optional<AtomIndex> crowded_atom(const BondRows& rows) {
  constexpr std::size_t most = 12;
  for (AtomIndex a = 0; a < rows.atoms(); ++a)
    if (rows.degree(a) > most) return a;
  return std::nullopt;
}

}  // namespace nanocarbon::analysis
