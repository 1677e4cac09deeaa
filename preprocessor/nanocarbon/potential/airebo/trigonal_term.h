// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "nanocarbon/potential/airebo/model.h"
#include "nanocarbon/potential/airebo/sp2_order_bound.h"

namespace nanocarbon::airebo {

//! \brief Whether b* of two such carbons is (p_ij + p_ji)/2, for F and T vanish at three and three bonds.
bool trigonal_order_is_plain(const rebo2::Rebo2Parameters& parameters);

//! \brief What S_b takes off a close pair of three-bonded carbons: -V slw S_r (1 - S_b), and its forces.
//! \details As add_long_range_term() without a path, for atoms whose bonds are whole.
//! \param along unit vector from i to j
//! \param length Angstrom
//! \param forces x, y, z of every atom; added to, eV/Angstrom
//! \pre trigonal_order_is_plain()
//! \return eV
double add_trigonal_term(const TrigonalCarbon& i, const TrigonalCarbon& j, const std::array<double, 3>& along,
                         double length, const AireboModel& model, double* forces);

}  // namespace nanocarbon::airebo
