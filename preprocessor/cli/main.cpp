#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "build.h"
#include "energy.h"
#include "inspect.h"
#include "make.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/core/version.h"

namespace {

int run(int argc, char** argv) {
  CLI::App app("Carbon molecules from triangle meshes, ready for LAMMPS.", "nanocarbon");
  app.set_version_flag("--version", std::string("nanocarbon ") + nanocarbon::version);
  app.require_subcommand(1);
  app.footer("Each subcommand has its own --help. Exit codes: README.md.");
  // The work of a subcommand is done by its callback, which parse() runs.
  nanocarbon::add_inspect(app);
  nanocarbon::add_build(app);
  nanocarbon::add_make(app);
  nanocarbon::add_energy(app);
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
  try {
    return run(argc, argv);
  } catch (const nanocarbon::UserError& error) {
    fmt::print(stderr, "nanocarbon: error: {}\n", error.what());
    return static_cast<int>(error.failure());
  } catch (const std::exception& error) {
    fmt::print(stderr, "nanocarbon: internal error: {} (please report this)\n", error.what());
    return 70;
  }
}
