// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "nanocarbon/core/element.h"

namespace nanocarbon::potential {

//! \brief The atoms of one evaluation: own atoms first, then copies.
//! \details A copy is a periodic image, or an atom of another process. Copies have positions and rows of near
//! pairs and receive forces, but have no terms of their own. They must reach three bonds (6 Angstrom) beyond the
//! own atoms.
struct AtomsView {
  const double* positions;  //!< x, y, z of each atom, Angstrom
  const Element* elements;
  std::uint32_t own;
  std::uint32_t all;
};

//! \brief For each atom, the atoms that may be bonded to it: all within the cut-off, perhaps more.
//! \details Compressed rows, of own atoms and of copies. The rows of copies more than two bonds away may be empty.
struct NearPairs {
  std::vector<std::uint32_t> offsets = {0};
  std::vector<std::uint32_t> atoms;

  std::span<const std::uint32_t> of(std::uint32_t atom) const {
    return {atoms.data() + offsets[atom], atoms.data() + offsets[atom + 1]};
  }
};

}  // namespace nanocarbon::potential
