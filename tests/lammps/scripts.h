// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

namespace nanocarbon::test {

struct ScriptResult {
  int exit_code;
  std::string output;  //!< screen output and errors
};

//! \brief Runs a LAMMPS program in a process of its own on an input script, as a user does.
//! \param program its path, or a whole command such as mpirun -n 2 lmp
//! \param script its lines; runs in an empty folder of its own
//! \param environment variables set for it, NAME=VALUE with spaces between
//! \param arguments further ones on the command line
ScriptResult run_script(const std::string& program, const std::string& script,
                        const std::string& environment = "", const std::string& arguments = "");

}  // namespace nanocarbon::test
