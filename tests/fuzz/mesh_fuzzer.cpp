// SPDX-License-Identifier: GPL-2.0-or-later
// For libFuzzer, run by run.sh: fuzz_mesh_off, fuzz_mesh_obj, ..., one for each extension.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "fuzz/check_mesh.h"
#include "fuzz/program_name.h"

namespace {

using nanocarbon::test::Depth;

std::string file;

// Repair takes up to a hundred times as long as reading: of most inputs it is left out, always of the same ones.
Depth depth_for(std::string_view contents) {
  std::uint32_t hash = 2166136261u;  // FNV-1a
  for (const char c : contents) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
  return (hash >> 8) % 64 == 0 ? Depth::repair : Depth::reading;
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char*** arguments) {
  file = "a." + nanocarbon::test::fuzzed_by(**arguments);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view contents(reinterpret_cast<const char*>(data), size);
  const std::string broken = nanocarbon::test::broken_promise(contents, file, depth_for(contents));
  if (!broken.empty()) {
    std::fprintf(stderr, "%s\n", broken.c_str());
    std::abort();
  }
  return 0;
}
