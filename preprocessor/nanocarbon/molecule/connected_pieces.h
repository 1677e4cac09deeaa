#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "nanocarbon/molecule/molecule.h"
#include "nanocarbon/molecule/signed_sets.h"

namespace nanocarbon {

//! The connected pieces of a bond graph, numbered from 0 by their lowest atom.
struct Pieces {
  std::vector<std::uint32_t> of_atom;
  std::uint32_t count = 0;
};

//! Connected pieces by union-find, linear in atoms and bonds. Images of a bond's second atom do not matter.
Pieces connected_pieces(std::size_t atoms, std::span<const Bond> bonds);

//! The same from sets that are already joined.
Pieces numbered_pieces(std::size_t atoms, SignedSets& sets);

}  // namespace nanocarbon
