// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/airebo/lj/lj_chunk.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nanocarbon::airebo {

namespace {

//! The farthest that atoms have moved; infinite where a place is not a number.
class Farthest {
 public:
  void add(const LjCluster& now, const LjCluster& then) {
    for (int l = 0; l < lj_lanes; ++l) {
      const double x = now.position[0][l] - then.position[0][l];
      const double y = now.position[1][l] - then.position[1][l];
      const double z = now.position[2][l] - then.position[2][l];
      const double squared = x * x + y * y + z * z;
      largest_[l] = largest_[l] > squared ? largest_[l] : squared;
      sum_[l] += squared;
    }
  }
  double distance() const {
    const double sum = sum_[0] + sum_[1] + sum_[2] + sum_[3];
    if (!std::isfinite(sum)) return std::numeric_limits<double>::infinity();
    return std::sqrt(*std::max_element(largest_, largest_ + lj_lanes));
  }

 private:
  double largest_[lj_lanes] = {};
  double sum_[lj_lanes] = {};  // not a number as soon as one of them is not
};

double farthest(const std::vector<LjCluster>& now, const std::vector<LjCluster>& then) {
  Farthest moved;
  for (std::size_t c = 0; c < now.size(); ++c) moved.add(now[c], then[c]);
  return moved.distance();
}

LjCounts search(const LjChunk& chunk, std::span<const LjRow> rows, std::span<const LjEntry> entries,
                const LjKernel& kernel, const LjParameters& parameters, double margin,
                std::vector<LjRow>& found_rows, std::vector<LjEntry>& found) {
  LjSearch search = {};
  search.clusters = chunk.clusters.data();
  set_reach(search, parameters, margin);
  search.rows = rows.data();
  search.row_count = rows.size();
  search.entries = entries.data();
  search.padding = static_cast<LjEntry>(chunk.clusters.size() - 1) << lj_number_bit;
  found_rows.resize(std::max(found_rows.size(), rows.size()));
  found.resize(std::max(found.size(), entries.size() + kernel.group * rows.size() + 1));
  return kernel.search(search, found_rows.data(), found.data());
}

}  // namespace

double place_atoms(LjChunk& chunk, const double* positions, std::span<const Vec3> translations) {
  const bool was_searched = !chunk.searched.empty();
  Farthest moved;
  for (std::size_t c = 0; c < chunk.clusters.size(); ++c) {
    LjCluster& cluster = chunk.clusters[c];
    for (int l = 0; l < lj_lanes; ++l) {
      const double* p = positions + 3 * std::size_t{chunk.atoms[lj_lanes * c + l]};
      for (int d = 0; d < 3; ++d) cluster.position[d][l] = p[d];
    }
    if (!chunk.images.empty())
      for (int l = 0; l < lj_lanes; ++l) {
        const Vec3& t = translations[chunk.images[lj_lanes * c + l]];
        for (int d = 0; d < 3; ++d) cluster.position[d][l] += t[d];
      }
    for (auto& component : cluster.force)
      for (double& f : component) f = 0.0;
    if (was_searched) moved.add(cluster, chunk.searched[c]);
  }
  return was_searched ? moved.distance() : std::numeric_limits<double>::infinity();
}

void search_rows(LjChunk& chunk, const LjKernel& kernel, const LjParameters& parameters, double margin) {
  const LjCounts counts =
      search(chunk, chunk.list_rows, chunk.list, kernel, parameters, margin, chunk.rows, chunk.entries);
  chunk.rows.resize(counts.rows);
  chunk.entries.resize(counts.entries);
  chunk.searched = chunk.clusters;
  if (!chunk.listed.empty()) chunk.strayed = farthest(chunk.clusters, chunk.listed);
}

void list_rows(LjChunk& chunk, std::span<const LjRow> rows, std::span<const LjEntry> entries,
               const LjKernel& kernel, const LjParameters& parameters, double margin, LjRowBuffer& buffer) {
  const LjCounts counts =
      search(chunk, rows, entries, kernel, parameters, margin, buffer.rows, buffer.entries);
  chunk.list_rows.assign(buffer.rows.begin(), buffer.rows.begin() + static_cast<std::ptrdiff_t>(counts.rows));
  chunk.list.assign(buffer.entries.begin(),
                    buffer.entries.begin() + static_cast<std::ptrdiff_t>(counts.entries));
  chunk.listed = chunk.clusters;
}

}  // namespace nanocarbon::airebo
