// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "nanocarbon/building/size_request.h"
#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::building {

//! \brief Where and why REBO2 would see other bonds than a molecule's.
//! \param molecule at rest
//! \param surface that it was made for
std::string describe_failure(const Molecule& molecule, const SizedSurface& surface);

}  // namespace nanocarbon::building
