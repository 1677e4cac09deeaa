#pragma once

#include <cstddef>
#include <string>

#include "nanocarbon/building/size_request.h"
#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon {

//! \brief Where and why REBO2 would see other bonds than a molecule's, and how many atoms are likely to do.
//! \details The number is that which leaves every part of the shape as wide as carbon likes it, rather than
//! as narrow as it may just be; one and a half times as many where nothing is narrow. \param molecule at rest
//! \param surface that it was made for
std::string why_it_does_not_hold(const Molecule& molecule, const SizedSurface& surface);

}  // namespace nanocarbon
