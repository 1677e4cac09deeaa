// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "nanocarbon/potential/airebo/lj/lj_kernel.h"

namespace nanocarbon::airebo {

//! The kernels that this processor can run, the fastest first; never empty.
const std::vector<const LjKernel*>& usable_lj_kernels();

//! \param name "generic", "avx2" or "avx512"; empty for the fastest
//! \throw UserError (usage) where this processor or build does not have them
const LjKernel& find_lj_kernel(std::string_view name);

}  // namespace nanocarbon::airebo
