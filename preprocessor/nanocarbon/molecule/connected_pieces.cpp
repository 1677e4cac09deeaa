#include "nanocarbon/molecule/connected_pieces.h"

namespace nanocarbon {

Pieces connected_pieces(std::size_t atoms, std::span<const Bond> bonds) {
  SignedSets sets(atoms);
  for (const Bond& bond : bonds) sets.join(bond.first, bond.second);
  return numbered_pieces(atoms, sets);
}

Pieces numbered_pieces(std::size_t atoms, SignedSets& sets) {
  Pieces pieces;
  pieces.of_atom.resize(atoms);
  for (std::uint32_t a = 0; a < atoms; ++a) {
    const std::uint32_t root = sets.find(a).root;  // the lowest atom, so its piece has its number
    pieces.of_atom[a] = root == a ? pieces.count++ : pieces.of_atom[root];
  }
  return pieces;
}

}  // namespace nanocarbon
