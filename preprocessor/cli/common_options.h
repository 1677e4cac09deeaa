// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>

namespace nanocarbon::cli {

//! The cores that this process may run on, which can be fewer than the machine has; at least 1.
unsigned available_cores();

//! What every long-running subcommand takes.
struct CommonOptions {
  bool quiet = false;                    //!< no progress, no table
  unsigned threads = available_cores();  //!< to use; the outputs do not depend on it
  std::uint64_t seed = 1;                //!< of everything random
};

//! Adds --quiet, --threads and --seed. \p options must outlive the app.
void add_common_options(CLI::App& subcommand, CommonOptions& options);

}  // namespace nanocarbon::cli
