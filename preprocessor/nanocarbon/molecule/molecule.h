// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "nanocarbon/core/cell.h"
#include "nanocarbon/core/element.h"
#include "nanocarbon/core/vec3.h"
#include "nanocarbon/topology/bonds.h"
#include "nanocarbon/topology/rings.h"

namespace nanocarbon {

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
