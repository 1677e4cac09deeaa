// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>

namespace nanocarbon::cli {

//! What every long-running subcommand takes.
struct CommonOptions {
  bool quiet = false;      //!< no progress, no table
  unsigned threads = 1;    //!< threads to use; same seed and threads: same bytes out
  std::uint64_t seed = 1;  //!< of everything random
};

//! Adds --quiet, --threads and --seed. \p options must outlive the app.
void add_common_options(CLI::App& subcommand, CommonOptions& options);

}  // namespace nanocarbon::cli
