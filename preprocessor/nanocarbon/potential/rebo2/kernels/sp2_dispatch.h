// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "nanocarbon/potential/rebo2/kernels/sp2_kernel.h"

namespace nanocarbon::rebo2 {

//! The kernels that this processor can run, the fastest first; never empty.
const std::vector<const Sp2Kernel*>& usable_sp2_kernels();

}  // namespace nanocarbon::rebo2
