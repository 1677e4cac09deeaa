// SPDX-License-Identifier: GPL-2.0-or-later
// For libFuzzer, built with clang and -DNANOCARBON_FUZZERS=ON:
//   cmake -B build/fuzz -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Debug -DNANOCARBON_FUZZERS=ON
//   cmake --build build/fuzz --target fuzz_mesh fuzz_molecule fuzz_potential
//   build/fuzz/tests/fuzz/fuzz_mesh -rss_limit_mb=512 -timeout=5 -runs=1000000 CORPUS_FOLDER [a folder of meshes to start from]
// The first byte of the input chooses the extension, the rest is the file.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "fuzz/check_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  constexpr const char* files[] = {"a.off", "a.obj", "a.ply", "a.stl", "a"};
  const std::string_view contents(reinterpret_cast<const char*>(data) + 1, size - 1);
  const std::string broken = nanocarbon::test::broken_promise(contents, files[data[0] % 5]);
  if (!broken.empty()) {
    std::fprintf(stderr, "%s\n", broken.c_str());
    std::abort();
  }
  return 0;
}
