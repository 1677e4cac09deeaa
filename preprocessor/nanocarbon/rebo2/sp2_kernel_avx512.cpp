// Compiled with the options for AVX-512; empty where the compiler does not make these instructions.
#include "nanocarbon/rebo2/sp2_kernels.h"

#if defined(__AVX512F__) && defined(__AVX512DQ__)
#include <immintrin.h>

#define NANOCARBON_LANES 8

namespace nanocarbon {

namespace {
#include "nanocarbon/rebo2/sp2_kernel_body.h"
}  // namespace

const Sp2Kernel* sp2_kernel_avx512() {
  static const Sp2Kernel kernel = {"avx512", first, second};
  return &kernel;
}

}  // namespace nanocarbon

#else

namespace nanocarbon {
const Sp2Kernel* sp2_kernel_avx512() { return nullptr; }
}  // namespace nanocarbon

#endif
