// SPDX-License-Identifier: GPL-2.0-or-later
#include "common_options.h"

#include <algorithm>
#include <thread>

#include "number_checks.h"

namespace nanocarbon::cli {
namespace {

constexpr unsigned most_threads = 1024;

}  // namespace

unsigned available_cores() { return std::clamp(std::thread::hardware_concurrency(), 1u, most_threads); }

void add_common_options(CLI::App& subcommand, CommonOptions& options) {
  subcommand.add_flag("-q,--quiet", options.quiet, "Print nothing but errors");
  subcommand.add_option("--threads", options.threads, "Number of threads; by default one per core")
      ->transform(whole_number())
      ->check(between(1, most_threads))
      ->default_str("cores");
  subcommand.add_option("--seed", options.seed, "Seed of everything random")
      ->transform(whole_number())
      ->check(zero_or_more())
      ->capture_default_str();
}

}  // namespace nanocarbon::cli
