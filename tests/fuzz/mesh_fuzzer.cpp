// SPDX-License-Identifier: GPL-2.0-or-later
// For libFuzzer, run by run.sh: fuzz_mesh_off, fuzz_mesh_obj, ..., one for each extension (FUZZED_FILE).
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "fuzz/check_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view contents(reinterpret_cast<const char*>(data), size);
  const std::string broken = nanocarbon::test::broken_promise(contents, FUZZED_FILE);
  if (!broken.empty()) {
    std::fprintf(stderr, "%s\n", broken.c_str());
    std::abort();
  }
  return 0;
}
