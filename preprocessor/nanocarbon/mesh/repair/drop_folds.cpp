// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/repair/drop_folds.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "nanocarbon/core/disjoint_sets.h"
#include "nanocarbon/mesh/edge_table.h"
#include "nanocarbon/mesh/same_faces.h"

namespace nanocarbon::mesh {
namespace {

enum class Verdict : std::uint8_t { none, fin, sheet, unclear };

// What an edge says of the folded part at it, by the number of its other faces.
Verdict verdict_of_edge(std::size_t others) {
  return others == 0   ? Verdict::none
         : others == 1 ? Verdict::sheet
         : others == 2 ? Verdict::fin
                       : Verdict::unclear;
}

Verdict together(Verdict a, Verdict b) {
  if (a == Verdict::none || a == b) return b;
  return b == Verdict::none ? a : Verdict::unclear;
}

}  // namespace

DroppedFolds drop_folds(PolygonSoup& soup) {
  DroppedFolds dropped;
  std::vector<SameFace> pairs = same_faces(soup);
  std::erase_if(pairs, [](const SameFace& same) { return same.same_winding; });
  if (pairs.empty()) return dropped;
  constexpr std::uint32_t single = std::uint32_t(-1);
  std::vector<std::uint32_t> pair_of(soup.faces(), single);
  for (std::uint32_t i = 0; i < pairs.size(); ++i) pair_of[pairs[i].face] = pair_of[pairs[i].earlier] = i;

  const EdgeTable edges = edge_table(soup);
  DisjointSets parts(pairs.size());
  std::vector<Verdict> of_pair(pairs.size(), Verdict::none);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    std::uint32_t first = single;
    std::size_t others = 0;
    for (const EdgeUse& use : edges.uses_of(e)) {
      const std::uint32_t pair = pair_of[use.face];
      if (pair == single)
        ++others;
      else if (first == single)
        first = pair;
      else
        parts.join(first, pair);
    }
    if (first != single) of_pair[first] = together(of_pair[first], verdict_of_edge(others));
  }
  std::vector<Verdict> of_part(pairs.size(), Verdict::none);
  for (std::uint32_t i = 0; i < pairs.size(); ++i) {
    Verdict& verdict = of_part[parts.find(i)];
    verdict = together(verdict, of_pair[i]);
  }

  PolygonSoup kept;
  for (FaceIndex face = 0; face < soup.faces(); ++face) {
    const std::uint32_t pair = pair_of[face];
    if (pair != single) {
      const Verdict verdict = of_part[parts.find(pair)];
      if (verdict == Verdict::fin) {
        ++dropped.of_fins;
        continue;
      }
      if (verdict != Verdict::unclear && pairs[pair].face == face) {
        ++dropped.of_sheets;
        continue;
      }
    }
    kept.corners.insert(kept.corners.end(), soup.face(face).begin(), soup.face(face).end());
    kept.close_face();
  }
  soup.corners = std::move(kept.corners);
  soup.offsets = std::move(kept.offsets);
  return dropped;
}

}  // namespace nanocarbon::mesh
