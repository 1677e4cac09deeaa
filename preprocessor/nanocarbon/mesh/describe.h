#pragma once

#include <string>

#include "nanocarbon/mesh/diagnosis.h"

namespace nanocarbon {

//! One line for people: how many, what is wrong, where first, what to do.
std::string describe(const MeshFinding& finding);

}  // namespace nanocarbon
