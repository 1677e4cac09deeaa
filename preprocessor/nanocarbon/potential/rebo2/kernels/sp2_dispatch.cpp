// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/rebo2/kernels/sp2_dispatch.h"

#include "nanocarbon/potential/rebo2/kernels/sp2_kernel.h"

namespace nanocarbon::rebo2 {

namespace {

std::vector<const Sp2Kernel*> find_usable() {
  std::vector<const Sp2Kernel*> usable;
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (sp2_kernel_avx512() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
    usable.push_back(sp2_kernel_avx512());
  if (sp2_kernel_avx2() && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    usable.push_back(sp2_kernel_avx2());
#endif
  usable.push_back(sp2_kernel_baseline());
  return usable;
}

}  // namespace

const std::vector<const Sp2Kernel*>& usable_sp2_kernels() {
  static const std::vector<const Sp2Kernel*> usable = find_usable();
  return usable;
}

}  // namespace nanocarbon::rebo2
