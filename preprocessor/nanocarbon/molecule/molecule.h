#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "nanocarbon/core/cell.h"
#include "nanocarbon/core/element.h"
#include "nanocarbon/core/vec3.h"

namespace nanocarbon {

using AtomIndex = std::uint32_t;

//! A bond between two atoms, first < second; in a periodic cell also the image of the second that is bonded
//! (first <= second there, and an atom may be bonded to its own image).
struct Bond {
  AtomIndex first;
  AtomIndex second;
  std::array<std::int32_t, 3> image = {0, 0, 0};
  friend auto operator<=>(const Bond&, const Bond&) = default;
};

//! Rings (faces of the bond graph on its surface) as atom cycles, counter-clockwise seen from outside, in
//! compressed rows.
struct Rings {
  std::vector<std::uint32_t> offsets = {0};  //!< size rings + 1
  std::vector<AtomIndex> atoms;

  std::size_t size() const { return offsets.size() - 1; }
  std::span<const AtomIndex> operator[](std::size_t ring) const {
    return {atoms.data() + offsets[ring], atoms.data() + offsets[ring + 1]};
  }
};

//! Atoms, bonds and rings. Bonds are sorted and unique. Rings may be empty where they are not known.
struct Molecule {
  std::vector<Vec3> positions;  //!< Angstrom
  std::vector<Element> elements;
  std::vector<Bond> bonds;
  Rings rings;
  std::optional<Cell> cell;  //!< nothing for a molecule in free space

  std::size_t size() const { return positions.size(); }
};

}  // namespace nanocarbon
