// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::features {

//! Distance at which two sheets of carbon rest beside each other: a little above graphite's 3.35 Angstrom,
//! since the surface that is left between rims has to be bent round, too.
inline constexpr double resting_sheet_distance = 3.6;

//! \brief Moves sides of a surface apart that lie closer than sheets of carbon would.
//! \details Thin plates grow and narrow gaps widen, each side by half of what is missing, at most 0.6
//! Angstrom; what surrounds them (rims) goes along. Nothing else moves.
//! \param surface Angstrom
//! \return nothing where there is room everywhere; else a finer mesh of the same topology
std::optional<TriangleMesh> with_room_for_sheets(const TriangleMesh& surface,
                                                 double distance = resting_sheet_distance,
                                                 unsigned threads = 1);

}  // namespace nanocarbon::features
