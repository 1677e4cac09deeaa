// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/potential/airebo/lj/lj_kernel.h"

namespace nanocarbon::airebo {

//! The loops for any processor of this architecture (SSE2 on x86-64, NEON on ARM), for AVX2 with FMA, and for
//! AVX-512. The latter two are nullptr where the compiler did not make them; the processor must be asked
//! before they are run.
const LjKernel* lj_kernel_baseline();
const LjKernel* lj_kernel_avx2();
const LjKernel* lj_kernel_avx512();

}  // namespace nanocarbon::airebo
