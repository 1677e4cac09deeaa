// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "nanocarbon/mesh/diagnosis.h"

namespace nanocarbon::mesh {

//! One line for people: how many, what is wrong, where first, what to do.
std::string describe(const MeshFinding& finding);

}  // namespace nanocarbon::mesh
