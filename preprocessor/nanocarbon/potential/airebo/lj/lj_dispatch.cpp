// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/airebo/lj/lj_dispatch.h"

#include <string>

#include "nanocarbon/core/error.h"
#include "nanocarbon/potential/airebo/lj/lj_kernels.h"

namespace nanocarbon::airebo {

namespace {

std::vector<const LjKernel*> find_usable() {
  std::vector<const LjKernel*> usable;
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (lj_kernel_avx512() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
    usable.push_back(lj_kernel_avx512());
  if (lj_kernel_avx2() && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    usable.push_back(lj_kernel_avx2());
#endif
  usable.push_back(lj_kernel_baseline());
  return usable;
}

}  // namespace

const std::vector<const LjKernel*>& usable_lj_kernels() {
  static const std::vector<const LjKernel*> usable = find_usable();
  return usable;
}

const LjKernel& find_lj_kernel(std::string_view name) {
  if (name.empty()) return *usable_lj_kernels().front();
  std::string known;
  for (const LjKernel* kernel : usable_lj_kernels()) {
    if (name == kernel->name) return *kernel;
    known.append(" ").append(kernel->name);
  }
  throw UserError(Failure::usage,
                  "no fast evaluation for instructions '" + std::string(name) + "' here; there are:" + known);
}

}  // namespace nanocarbon::airebo
