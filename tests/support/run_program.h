// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string>

namespace nanocarbon::test {

struct ProgramOutcome {
  int exit_code;
  std::string output;  //!< and errors, as they came
};

//! Runs a shell command as a user does.
inline ProgramOutcome run_command(const std::string& command) {
  ProgramOutcome outcome{-1, {}};
  FILE* pipe = popen((command + " 2>&1 </dev/null").c_str(), "r");
  if (!pipe) return outcome;
  std::array<char, 4096> buffer;
  while (const std::size_t n = fread(buffer.data(), 1, buffer.size(), pipe))
    outcome.output.append(buffer.data(), n);
  const int status = pclose(pipe);
  if (WIFEXITED(status)) outcome.exit_code = WEXITSTATUS(status);
  return outcome;
}

}  // namespace nanocarbon::test
