// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "nanocarbon/core/disjoint_sets.h"
#include "nanocarbon/topology/bonds.h"

namespace nanocarbon::topology {

//! The connected components of a bond graph, numbered from 0 by their lowest atom.
struct Components {
  std::vector<std::uint32_t> of_atom;
  std::uint32_t count = 0;
};

//! Connected components by union-find, linear in atoms and bonds. Images of a bond's second atom do not
//! matter.
Components connected_components(std::size_t atoms, std::span<const Bond> bonds);

//! The same from sets that are already joined.
Components numbered_components(std::size_t atoms, DisjointSets& sets);

}  // namespace nanocarbon::topology
