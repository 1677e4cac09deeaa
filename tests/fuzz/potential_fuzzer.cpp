// SPDX-License-Identifier: GPL-2.0-or-later
// For libFuzzer, run by run.sh: fuzz_potential_rebo, fuzz_potential_airebo, fuzz_potential_airebo_m, for parameter
// files of LAMMPS.
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "fuzz/memory_file.h"
#include "fuzz/program_name.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/potential/airebo/parameter_file.h"
#include "nanocarbon/potential/rebo2/parameter_file.h"

namespace {

// Of a struct or array that is made of doubles alone.
template <class T>
void require_finite(const T& numbers) {
  std::array<double, sizeof(T) / sizeof(double)> values;
  std::memcpy(values.data(), &numbers, sizeof(T));
  for (const double value : values)
    if (!std::isfinite(value)) {
      std::fprintf(stderr, "a parameter is not finite\n");
      std::abort();
    }
}

void require_finite(const nanocarbon::rebo2::Rebo2Parameters& parameters) {
  require_finite(parameters.pairs);
  require_finite(parameters.carbon);
  require_finite(parameters.hydrogen);
}

void read_rebo(const std::string& path) { require_finite(nanocarbon::rebo2::read_rebo2_parameters(path)); }

void read_airebo(const std::string& path, nanocarbon::airebo::LjForm form) {
  const nanocarbon::airebo::AireboParameters parameters =
      nanocarbon::airebo::read_airebo_parameters(path, form);
  require_finite(parameters.rebo);
  require_finite(parameters.long_range);
  require_finite(parameters.torsion);
}

std::string potential;

void read(const std::string& path) {
  using nanocarbon::airebo::LjForm;
  if (potential == "rebo") return read_rebo(path);
  read_airebo(path, potential == "airebo" ? LjForm::lennard_jones : LjForm::morse);
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char*** arguments) {
  potential = nanocarbon::test::fuzzed_by(**arguments);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const nanocarbon::test::MemoryFile file(data, size);
  try {
    read(file.path());
  } catch (const nanocarbon::UserError& error) {
    if (std::string(error.what()).find(file.path()) == std::string::npos) {
      std::fprintf(stderr, "the message does not name the file: %s\n", error.what());
      std::abort();
    }
  }
  return 0;
}
