#include "nanocarbon/molecule/connected_pieces.h"

#include <numeric>

namespace nanocarbon {

Pieces connected_pieces(std::size_t atoms, std::span<const Bond> bonds) {
  // The lower root becomes the parent, so a piece's root is its lowest atom.
  std::vector<std::uint32_t> parent(atoms);
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::uint32_t a) {
    while (parent[a] != a) a = parent[a] = parent[parent[a]];
    return a;
  };
  for (const Bond& bond : bonds) {
    const std::uint32_t a = root(bond.first), b = root(bond.second);
    if (a < b)
      parent[b] = a;
    else
      parent[a] = b;
  }
  Pieces pieces;
  pieces.of_atom.resize(atoms);
  for (std::uint32_t a = 0; a < atoms; ++a) {
    const std::uint32_t r = root(a);
    pieces.of_atom[a] = r == a ? pieces.count++ : pieces.of_atom[r];
  }
  return pieces;
}

}  // namespace nanocarbon
