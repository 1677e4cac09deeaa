// SPDX-License-Identifier: GPL-2.0-or-later
// Work on long arrays by several threads, with results that do not depend on how many there are.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "nanocarbon/core/thread_team.h"

namespace nanocarbon {

//! Entries that one thread works on at a time. Sums are added up chunk by chunk, whatever the threads.
inline constexpr std::size_t chunk_size = 4096;

inline std::size_t chunks_of(std::size_t count) { return (count + chunk_size - 1) / chunk_size; }

//! Calls work(index) for every index below count, by the team's threads if there is a team.
template <typename Work>
void for_each_index(ThreadTeam* team, std::size_t count, const Work& work) {
  if (team && team->size() > 1 && count > 1)
    team->run(count, [&work](std::size_t index, unsigned) { work(index); });
  else
    for (std::size_t index = 0; index < count; ++index) work(index);
}

//! Calls work(begin, end) for every chunk of the entries below count.
template <typename Work>
void for_chunks(ThreadTeam* team, std::size_t count, const Work& work) {
  for_each_index(team, chunks_of(count), [&](std::size_t chunk) {
    work(chunk * chunk_size, std::min(count, (chunk + 1) * chunk_size));
  });
}

//! The sum of sum_of(begin, end) over all chunks, in their order.
template <typename SumOf>
double sum_chunks(ThreadTeam* team, std::size_t count, const SumOf& sum_of) {
  std::vector<double> parts(chunks_of(count));
  for_chunks(team, count,
             [&](std::size_t begin, std::size_t end) { parts[begin / chunk_size] = sum_of(begin, end); });
  double sum = 0;
  for (const double part : parts) sum += part;
  return sum;
}

//! The largest of largest_of(begin, end) over all chunks, and of zero.
template <typename LargestOf>
double largest_in_chunks(ThreadTeam* team, std::size_t count, const LargestOf& largest_of) {
  std::vector<double> parts(chunks_of(count));
  for_chunks(team, count,
             [&](std::size_t begin, std::size_t end) { parts[begin / chunk_size] = largest_of(begin, end); });
  double largest = 0;
  for (const double part : parts) largest = std::max(largest, part);
  return largest;
}

}  // namespace nanocarbon
