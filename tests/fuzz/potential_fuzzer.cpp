// SPDX-License-Identifier: GPL-2.0-or-later
// For libFuzzer, built as mesh_fuzzer.cpp says: fuzz_potential, for parameter files of LAMMPS.
// The first byte of the input chooses the potential, the rest is the file.
#include <sys/mman.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "nanocarbon/core/error.h"
#include "nanocarbon/potential/airebo/parameter_file.h"
#include "nanocarbon/potential/rebo2/parameter_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const int file = memfd_create("parameters", 0);
  if (file < 0) return 0;
  if (::write(file, data + 1, size - 1) == static_cast<ssize_t>(size - 1)) {
    const std::string path = "/proc/self/fd/" + std::to_string(file);
    try {
      if (data[0] % 3 == 0)
        nanocarbon::rebo2::read_rebo2_parameters(path);
      else
        nanocarbon::airebo::read_airebo_parameters(path, data[0] % 3 == 1
                                                             ? nanocarbon::airebo::LjForm::lennard_jones
                                                             : nanocarbon::airebo::LjForm::morse);
    } catch (const nanocarbon::UserError& error) {
      if (std::string(error.what()).find(path) == std::string::npos) {
        std::fprintf(stderr, "the message does not name the file: %s\n", error.what());
        std::abort();
      }
    }
  }
  ::close(file);
  return 0;
}
