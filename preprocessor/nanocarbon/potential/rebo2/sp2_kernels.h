// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/potential/rebo2/sp2_kernel.h"

namespace nanocarbon::rebo2 {

//! The loops for any processor of this architecture (SSE2 on x86-64, NEON on ARM), for AVX2 with FMA, and for
//! AVX-512. The latter two are nullptr where the compiler did not make them; the processor must be asked
//! before they are run.
const Sp2Kernel* sp2_kernel_baseline();
const Sp2Kernel* sp2_kernel_avx2();
const Sp2Kernel* sp2_kernel_avx512();

}  // namespace nanocarbon::rebo2
