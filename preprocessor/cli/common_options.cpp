// SPDX-License-Identifier: GPL-2.0-or-later
#include "common_options.h"

#include "number_checks.h"

namespace nanocarbon::cli {

void add_common_options(CLI::App& subcommand, CommonOptions& options) {
  subcommand.add_flag("-q,--quiet", options.quiet, "Print nothing but errors");
  subcommand.add_option("--threads", options.threads, "Threads to use")
      ->transform(whole_number())
      ->check(between(1, 1024))
      ->capture_default_str();
  subcommand.add_option("--seed", options.seed, "Seed of everything random")
      ->transform(whole_number())
      ->check(zero_or_more())
      ->capture_default_str();
}

}  // namespace nanocarbon::cli
