// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "nanocarbon/core/element.h"
#include "nanocarbon/potential/airebo/lj/lj_chunk.h"

namespace nanocarbon::airebo {

//! The pairs of the sum, by clusters of four atoms.
struct LjLists {
  //! Where an atom's force is to be collected.
  struct Share {
    std::uint32_t chunk;
    std::uint32_t place;
  };

  std::vector<LjChunk> chunks;
  std::vector<std::array<std::int32_t, 3>> images;  //!< what LjChunk::images refers to
  std::vector<std::uint32_t> offsets;               //!< of each of the caller's atoms in shares, and the end
  std::vector<Share> shares;
  double margin = 0.0;  //!< the lists are valid until an atom has moved by half of it, Angstrom
};

//! Sites of the sum: atoms or images of atoms, in clusters of four.
struct LjSites {
  std::vector<std::uint32_t> atoms;   //!< [4 cluster + lane]; padding repeats a site
  std::vector<std::uint32_t> images;  //!< which translation to add; empty where all are zero
  std::vector<std::uint8_t> real;     //!< [cluster] the lanes that are not padding
  std::vector<std::uint8_t> hydrogens;

  std::uint32_t clusters() const { return static_cast<std::uint32_t>(real.size()); }
  //! Appends one group of atoms (and images, unless empty) in clusters.
  void add(std::span<const std::uint32_t> group, std::span<const std::uint32_t> group_images,
           std::span<const Element> elements);
};

//! Pairs of sites to be left out; compressed rows, each pair at one end or at both.
struct LjExcluded {
  std::vector<std::uint32_t> offsets;
  std::vector<std::uint32_t> sites;

  //! \param pairs in any order
  LjExcluded(std::vector<std::array<std::uint32_t, 2>> pairs, std::size_t rows);
};

//! Makes chunks of rows that come in the order of their sites.
class LjListBuilder {
 public:
  struct Partner {
    std::uint32_t cluster;
    std::uint32_t mask;
  };

  //! What becomes of the rows of a chunk that is complete but for them.
  using TakeRows = std::function<void(LjChunk&, std::span<const LjRow>, std::span<const LjEntry>)>;

  //! \param own_sites the sites that have rows;
  //! \param chunk_clusters how many clusters of them share a chunk
  //! \param take_rows empty: they become the chunk's list
  LjListBuilder(const LjSites& sites, const LjExcluded& excluded, std::size_t own_sites,
                std::uint32_t chunk_clusters, TakeRows take_rows = {});

  //! \param partners of the site, each cluster once; changed
  void add_row(std::uint32_t site, std::vector<Partner>& partners);

  //! \param atoms how many the caller has
  LjLists finish(std::size_t atoms);

 private:
  void open_chunk(std::uint32_t first_cluster);
  void close_chunk();
  std::uint32_t local(std::uint32_t cluster);

  const LjSites& sites_;
  const LjExcluded& excluded_;
  std::uint32_t own_clusters_;
  std::uint32_t chunk_clusters_;
  TakeRows take_rows_;
  std::uint32_t chunk_end_ = 0;
  std::vector<std::uint32_t> local_;  // numbers of clusters in the open chunk
  std::vector<std::uint32_t> in_row_;
  std::vector<std::uint32_t> touched_;
  std::vector<LjRow> rows_;  // of the open chunk
  std::vector<LjEntry> entries_;
  LjLists lists_;
};

}  // namespace nanocarbon::airebo
