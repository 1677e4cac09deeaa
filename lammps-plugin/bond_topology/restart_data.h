// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "bond_topology/surface_watch.h"

namespace nanocarbon {

//! What a restart file holds of a watch: the start, from which all else follows, and the bonds now.
struct RestartData {
  WatchedAtoms start;
  std::vector<topology::BondedIds> bonds;  //!< sorted
};

std::string to_bytes(const RestartData& data);

//! \param bytes as to_bytes wrote them, on a machine with the same byte order (as LAMMPS demands of restart
//! files)
//! \return false where they are not from this version of the format
bool from_bytes(const char* bytes, RestartData& data);

}  // namespace nanocarbon
