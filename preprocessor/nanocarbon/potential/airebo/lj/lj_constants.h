// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/potential/airebo/lj/lj_kernel.h"
#include "nanocarbon/potential/airebo/lj/lj_parameters.h"

namespace nanocarbon::airebo {

//! The parameters as the inner loops need them.
LjConstants make_lj_constants(const LjParameters& parameters);

//! Which of the loops belongs to these parameters.
LjVariant lj_variant(const LjParameters& parameters, bool energy);

//! Fills a search's squared distances: up to a margin (Angstrom) beyond where the sum ends.
void set_reach(LjSearch& search, const LjParameters& parameters, double margin);

}  // namespace nanocarbon::airebo
