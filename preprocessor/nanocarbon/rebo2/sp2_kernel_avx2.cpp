// Compiled with the options for AVX2 and FMA; empty where the compiler does not make these instructions.
#include "nanocarbon/rebo2/sp2_kernels.h"

#if defined(__AVX2__) && defined(__FMA__)
#include <immintrin.h>

#define NANOCARBON_LANES 4

namespace nanocarbon {

namespace {
#include "nanocarbon/rebo2/sp2_kernel_body.h"
}  // namespace

const Sp2Kernel* sp2_kernel_avx2() {
  static const Sp2Kernel kernel = {"avx2", first, second};
  return &kernel;
}

}  // namespace nanocarbon

#else

namespace nanocarbon {
const Sp2Kernel* sp2_kernel_avx2() { return nullptr; }
}  // namespace nanocarbon

#endif
