// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/atom_chunks.h"

#include "nanocarbon/minimisation/multilevel/chunk_colours.h"

namespace nanocarbon::annealing {

AtomChunks::AtomChunks(const FixedBondGraph& graph)
    : atoms_(graph.inner_count()), count_((atoms_ + size - 1) / size) {
  if (count_ == 1) colours_ = {{0}};
  if (count_ < 2) return;
  // Chunks that add to one atom are within two bonds of each other.
  multilevel::NodeGraph near;
  near.nodes.reserve(9 * atoms_);
  for (AtomIndex a = 0; a < atoms_; ++a) {
    for (const AtomIndex n : graph.neighbours[a]) {
      if (n == no_atom || n >= atoms_) continue;
      near.nodes.push_back(n);
      for (const AtomIndex m : graph.neighbours[n])
        if (m != no_atom && m < atoms_ && m != a) near.nodes.push_back(m);
    }
    near.offsets.push_back(static_cast<std::uint32_t>(near.nodes.size()));
  }
  colours_ = multilevel::chunks_by_colour(near, size);
}

}  // namespace nanocarbon::annealing
