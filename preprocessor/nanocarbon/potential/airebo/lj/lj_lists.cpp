// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/airebo/lj/lj_lists.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

namespace nanocarbon::airebo {

namespace {

constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();

}  // namespace

void LjSites::add(std::span<const std::uint32_t> group, std::span<const std::uint32_t> group_images,
                  std::span<const Element> elements) {
  for (std::size_t begin = 0; begin < group.size(); begin += lj_lanes) {
    const std::size_t count = std::min<std::size_t>(lj_lanes, group.size() - begin);
    std::uint8_t hydrogen = 0;
    for (std::size_t l = 0; l < lj_lanes; ++l) {
      const std::size_t at = begin + std::min(l, count - 1);
      atoms.push_back(group[at]);
      if (!group_images.empty()) images.push_back(group_images[at]);
      if (elements[group[at]] == Element::hydrogen) hydrogen |= static_cast<std::uint8_t>(1u << l);
    }
    real.push_back(static_cast<std::uint8_t>((1u << count) - 1u));
    hydrogens.push_back(hydrogen);
  }
}

LjExcluded::LjExcluded(std::vector<std::array<std::uint32_t, 2>> pairs, std::size_t rows)
    : offsets(rows + 1, 0), sites(2 * pairs.size()) {
  for (const auto& pair : pairs)
    for (const std::uint32_t site : pair) ++offsets[site + 1];
  for (std::size_t r = 0; r < rows; ++r) offsets[r + 1] += offsets[r];
  std::vector<std::uint32_t> next(offsets.begin(), offsets.end() - 1);
  for (const auto& [a, b] : pairs) {
    sites[next[a]++] = b;
    sites[next[b]++] = a;
  }
}

LjListBuilder::LjListBuilder(const LjSites& sites, const LjExcluded& excluded, std::size_t own_sites,
                             std::uint32_t chunk_clusters, TakeRows take_rows)
    : sites_(sites),
      excluded_(excluded),
      own_clusters_(static_cast<std::uint32_t>((own_sites + lj_lanes - 1) / lj_lanes)),
      chunk_clusters_(chunk_clusters),
      take_rows_(std::move(take_rows)),
      local_(sites.clusters(), nowhere),
      in_row_(sites.clusters(), nowhere) {}

std::uint32_t LjListBuilder::local(std::uint32_t cluster) {
  std::uint32_t& number = local_[cluster];
  if (number == nowhere) {
    number = static_cast<std::uint32_t>(touched_.size());
    // One is kept for the padding.
    if (number + 1 >= lj_most_clusters) throw std::length_error("too many atoms for one list of pairs");
    touched_.push_back(cluster);
  }
  return number;
}

void LjListBuilder::open_chunk(std::uint32_t first_cluster) {
  lists_.chunks.emplace_back();
  chunk_end_ = static_cast<std::uint32_t>(
      std::min<std::uint64_t>(own_clusters_, std::uint64_t{first_cluster} + chunk_clusters_));
  for (std::uint32_t c = first_cluster; c < chunk_end_; ++c) local(c);
}

void LjListBuilder::close_chunk() {
  if (lists_.chunks.empty()) return;
  LjChunk& chunk = lists_.chunks.back();
  touched_.push_back(touched_.front());
  for (const std::uint32_t cluster : touched_) {
    const auto begin = static_cast<std::ptrdiff_t>(lj_lanes * std::size_t{cluster});
    const auto copy = [&](const std::vector<std::uint32_t>& from, std::vector<std::uint32_t>& to) {
      if (!from.empty()) to.insert(to.end(), from.begin() + begin, from.begin() + begin + lj_lanes);
    };
    copy(sites_.atoms, chunk.atoms);
    copy(sites_.images, chunk.images);
    chunk.real.push_back(sites_.real[cluster]);
    chunk.mixed |= sites_.hydrogens[cluster] != 0;
  }
  chunk.real.back() = 0;
  chunk.clusters.resize(touched_.size());
  for (const std::uint32_t cluster : touched_) local_[cluster] = nowhere;
  touched_.clear();
  if (take_rows_) {
    take_rows_(chunk, rows_, entries_);
  } else {
    chunk.list_rows.assign(rows_.begin(), rows_.end());
    chunk.list.assign(entries_.begin(), entries_.end());
  }
  rows_.clear();
  entries_.clear();
}

void LjListBuilder::add_row(std::uint32_t site, std::vector<Partner>& partners) {
  const std::uint32_t own_cluster = site / lj_lanes;
  if (own_cluster >= chunk_end_) {
    close_chunk();
    open_chunk(own_cluster);
  }
  const auto begin = excluded_.offsets[site], end = excluded_.offsets[site + 1];
  if (begin != end) {
    for (std::uint32_t k = 0; k < partners.size(); ++k) in_row_[partners[k].cluster] = k;
    for (std::uint32_t e = begin; e < end; ++e) {
      const std::uint32_t other = excluded_.sites[e];
      const std::uint32_t k = in_row_[other / lj_lanes];
      if (k != nowhere) partners[k].mask &= ~(1u << other % lj_lanes);
    }
    for (const Partner& p : partners) in_row_[p.cluster] = nowhere;
  }
  const std::size_t first = entries_.size();
  for (const Partner& p : partners)
    if (p.mask != 0)
      entries_.push_back(local(p.cluster) << lj_number_bit |
                         std::uint32_t{sites_.hydrogens[p.cluster]} << lj_kind_bit | p.mask);
  if (entries_.size() == first) return;
  if (entries_.size() > nowhere) throw std::length_error("too many pairs for one list");
  const std::uint32_t lane = site % lj_lanes;
  rows_.push_back({local(own_cluster) * lj_lanes + lane,
                   static_cast<std::uint32_t>(sites_.hydrogens[own_cluster] >> lane & 1),
                   static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(entries_.size())});
}

LjLists LjListBuilder::finish(std::size_t atoms) {
  close_chunk();
  const auto for_all_places = [&](const auto& action) {
    for (std::uint32_t c = 0; c < lists_.chunks.size(); ++c) {
      const LjChunk& chunk = lists_.chunks[c];
      for (std::uint32_t place = 0; place < chunk.atoms.size(); ++place)
        if (chunk.real[place / lj_lanes] >> place % lj_lanes & 1) action(chunk.atoms[place], c, place);
    }
  };
  lists_.offsets.assign(atoms + 1, 0);
  for_all_places([&](std::uint32_t atom, std::uint32_t, std::uint32_t) { ++lists_.offsets[atom + 1]; });
  for (std::size_t a = 0; a < atoms; ++a) lists_.offsets[a + 1] += lists_.offsets[a];
  lists_.shares.resize(lists_.offsets.back());
  std::vector<std::uint32_t> next(lists_.offsets.begin(), lists_.offsets.end() - 1);
  for_all_places([&](std::uint32_t atom, std::uint32_t chunk, std::uint32_t place) {
    lists_.shares[next[atom]++] = {chunk, place};
  });
  return std::move(lists_);
}

}  // namespace nanocarbon::airebo
