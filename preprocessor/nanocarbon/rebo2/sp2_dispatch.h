#pragma once

#include <vector>

#include "nanocarbon/rebo2/sp2_kernel.h"

namespace nanocarbon {

//! The kernels that this processor can run, the fastest first; never empty.
const std::vector<const Sp2Kernel*>& usable_sp2_kernels();

}  // namespace nanocarbon
