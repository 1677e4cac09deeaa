// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/minimisation/multilevel/coarsening.h"

#include <algorithm>
#include <numeric>

namespace nanocarbon::multilevel {

namespace {

constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

// In order of size a greedy choice would pack the nodes as densely as can be; from a shuffled one about half
// as many are left.
std::vector<std::uint32_t> shuffled(std::size_t count) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  std::uint64_t state = 1;
  for (std::size_t i = count; i > 1; --i) {
    state = state * 6364136223846793005ull + 1442695040888963407ull;  // Knuth's MMIX
    std::swap(order[i - 1], order[(state >> 33) % i]);
  }
  return order;
}

std::vector<std::uint32_t> choose(const NodeGraph& graph, unsigned separation) {
  std::vector<bool> covered(graph.size(), false);
  std::vector<std::uint32_t> chosen, ball, seen(graph.size(), none);
  for (const std::uint32_t centre : shuffled(graph.size())) {
    if (covered[centre]) continue;
    chosen.push_back(centre);
    ball.assign(1, centre);
    seen[centre] = centre;
    std::size_t shell = 0;
    for (unsigned steps = 1; steps < separation; ++steps)
      for (const std::size_t end = ball.size(); shell < end; ++shell)
        for (const std::uint32_t n : graph.of(ball[shell]))
          if (seen[n] != centre) {
            seen[n] = centre;
            ball.push_back(n);
          }
    for (const std::uint32_t n : ball) covered[n] = true;
  }
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

}  // namespace

Coarsening coarsen(const NodeGraph& graph, unsigned separation) {
  Coarsening result;
  result.chosen = choose(graph, separation);
  result.owner.assign(graph.size(), none);
  for (std::uint32_t c = 0; c < result.chosen.size(); ++c) result.owner[result.chosen[c]] = c;
  std::vector<std::uint32_t> reached = result.chosen;
  for (std::size_t k = 0; k < reached.size(); ++k)
    for (const std::uint32_t n : graph.of(reached[k]))
      if (result.owner[n] == none) {
        result.owner[n] = result.owner[reached[k]];
        reached.push_back(n);
      }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> touching;
  for (std::uint32_t i = 0; i < graph.size(); ++i)
    for (const std::uint32_t n : graph.of(i))
      if (n > i && result.owner[n] != result.owner[i])
        touching.emplace_back(result.owner[i], result.owner[n]);
  result.graph = graph_of_pairs(result.chosen.size(), touching);
  return result;
}

std::vector<std::uint32_t> compact_order(const NodeGraph& graph) {
  constexpr std::size_t few = 8;
  std::vector<Coarsening> levels;
  const NodeGraph* fine = &graph;
  while (fine->size() > few) {
    Coarsening coarser = coarsen(*fine, 2);
    if (coarser.chosen.size() == fine->size()) break;
    levels.push_back(std::move(coarser));
    fine = &levels.back().graph;
  }
  std::vector<std::uint32_t> order(fine->size());
  std::iota(order.begin(), order.end(), 0u);
  for (; !levels.empty(); levels.pop_back()) {
    const Coarsening& level = levels.back();
    NodeGraph owned;
    owned.nodes = level.owner;
    owned.offsets.resize(level.owner.size() + 1);
    std::iota(owned.offsets.begin(), owned.offsets.end(), 0u);
    owned = transposed(owned, level.chosen.size());
    std::vector<std::uint32_t> finer;
    finer.reserve(level.owner.size());
    for (const std::uint32_t c : order) finer.insert(finer.end(), owned.of(c).begin(), owned.of(c).end());
    order = std::move(finer);
  }
  return order;
}

}  // namespace nanocarbon::multilevel
