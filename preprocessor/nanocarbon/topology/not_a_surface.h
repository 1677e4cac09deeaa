// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "nanocarbon/topology/bonds.h"

namespace nanocarbon::topology {

//! Why a bond graph is not a surface, and the atom where.
struct NotASurface {
  std::string reason;  //!< names atoms by ID
  AtomIndex atom;
};

}  // namespace nanocarbon::topology
