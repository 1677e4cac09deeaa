// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "nanocarbon/building/size_request.h"
#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::building {

//! \brief Says where and why REBO2 would see other bonds than the molecule's.
//! \param molecule at rest
//! \param surface on which it was built
std::string describe_failure(const Molecule& molecule, const SizedSurface& surface);

}  // namespace nanocarbon::building
