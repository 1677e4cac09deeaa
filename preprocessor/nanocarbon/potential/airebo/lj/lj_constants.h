// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/potential/airebo/lj/lj_kernel.h"
#include "nanocarbon/potential/airebo/lj/lj_parameters.h"

namespace nanocarbon::airebo {

//! The parameters in the form that the inner loops need.
LjConstants make_lj_constants(const LjParameters& parameters);

//! Which of the loops belongs to these parameters.
//! \param mixed whether there is hydrogen
LjVariant lj_variant(const LjParameters& parameters, bool energy, bool mixed);

//! Sets a search's squared distances, up to a margin (Angstrom) beyond the end of the sum.
void set_reach(LjSearch& search, const LjParameters& parameters, double margin);

}  // namespace nanocarbon::airebo
