// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "nanocarbon/core/cell.h"
#include "nanocarbon/core/thread_team.h"
#include "nanocarbon/core/vec3.h"

namespace nanocarbon {

//! One neighbour of an atom: the atom and the periodic image of it that is near.
struct Neighbour {
  std::uint32_t atom;
  std::array<std::int32_t, 3> image;  //!< cell multiples to add to the atom's position as given
  friend auto operator<=>(const Neighbour&, const Neighbour&) = default;
};

//! Full neighbour lists (each pair appears at both ends) in compressed rows.
struct NeighbourList {
  std::vector<std::size_t> offsets;  //!< size atoms + 1; row i is [offsets[i], offsets[i + 1])
  std::vector<Neighbour> neighbours;

  std::size_t atoms() const { return offsets.empty() ? 0 : offsets.size() - 1; }
  std::span<const Neighbour> of(std::size_t atom) const {
    return {neighbours.data() + offsets[atom], neighbours.data() + offsets[atom + 1]};
  }
};

//! \brief All neighbours at a distance below the cut-off.
//! \details Spatial hashing: linear in atoms for any extent of the coordinates, also where a few atoms are
//! far away. An atom is its own neighbour where a periodic image of it is near. Rows are sorted by atom, then
//! image.
//! \param positions Angstrom; they need not lie inside the cell. Must be finite.
//! \param cell nullptr for no periodicity. Cells smaller than the cut-off are handled with as many images as
//! needed.
//! \param cutoff Angstrom, above zero
//! \param team may be null
NeighbourList neighbours_within(std::span<const Vec3> positions, const Cell* cell, double cutoff,
                                ThreadTeam* team = nullptr);

}  // namespace nanocarbon
