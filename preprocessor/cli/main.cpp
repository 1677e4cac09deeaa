// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "analyse.h"
#include "build.h"
#include "energy.h"
#include "inspect.h"
#include "make.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/core/version.h"
#include "nanocarbon/mesh/solid/cgal_version.h"

namespace {

// CLI11 says only that a subcommand is missing.
void require_known_subcommand(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::vector<std::string> names;
  for (const CLI::App* subcommand : app.get_subcommands({})) names.push_back(subcommand->get_name());
  if (std::find(names.begin(), names.end(), argv[1]) != names.end()) return;
  throw nanocarbon::UserError(
      nanocarbon::Failure::usage,
      fmt::format("there is no subcommand '{}'; the subcommands are {}", argv[1], fmt::join(names, ", ")));
}

std::string version_text() {
  const std::string cgal = nanocarbon::mesh::cgal_version();
  return fmt::format(
      "nanocarbon {}\n{}", nanocarbon::version,
      cgal.empty() ? std::string("without CGAL: no --wrap, --unite and --untangle; licence GPL-2.0-or-later")
                   : fmt::format("with CGAL {}: licence GPL-3.0-or-later", cgal));
}

int run(int argc, char** argv) {
  CLI::App app("Carbon molecules from triangle meshes, ready for LAMMPS.", "nanocarbon");
  app.set_version_flag("--version", version_text());
  app.require_subcommand(1);
  app.footer("Each subcommand has its own --help. Exit codes: README.md.");
  // The work of a subcommand is done by its callback, which parse() runs.
  nanocarbon::cli::add_inspect(app);
  nanocarbon::cli::add_build(app);
  nanocarbon::cli::add_make(app);
  nanocarbon::cli::add_energy(app);
  nanocarbon::cli::add_analyse(app);
  app.failure_message([](const CLI::App*, const CLI::Error& error) {
    return fmt::format("nanocarbon: error: {}\nRun with --help for more information.\n", error.what());
  });
  if (argc < 2) {
    fmt::print("{}", app.help());
    return 0;
  }
  require_known_subcommand(app, argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::RuntimeError& error) {
    return error.get_exit_code();  // a subcommand that has said what there was to say
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : static_cast<int>(nanocarbon::Failure::usage);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on the size of files is a write error like a full disk
  try {
    return run(argc, argv);
  } catch (const nanocarbon::UserError& error) {
    fmt::print(stderr, "nanocarbon: error: {}\n", error.what());
    return static_cast<int>(error.failure());
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "nanocarbon: error: there is not enough memory; ask for fewer atoms\n");
    return static_cast<int>(nanocarbon::Failure::size);
  } catch (const std::exception& error) {
    fmt::print(stderr, "nanocarbon: internal error: {} (please report this)\n", error.what());
    return 70;
  }
}
