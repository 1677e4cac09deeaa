// SPDX-License-Identifier: GPL-2.0-or-later
#include "lammps/scripts.h"

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace nanocarbon::test {

ScriptResult run_script(const std::string& program, const std::string& script, const std::string& environment,
                        const std::string& arguments) {
  std::string folder = (std::filesystem::temp_directory_path() / "nanocarbon-test-XXXXXX").string();
  if (mkdtemp(folder.data()) == nullptr) throw std::runtime_error("no temporary folder " + folder);
  std::ofstream(folder + "/in.script") << script;
  // Leaks: MPI has some of its own; those of the plugin are looked for by valgrind.
  const std::string line = "cd '" + folder + "' && " + environment + " ASAN_OPTIONS=detect_leaks=0 " +
                           program + " -in in.script -log none -nocite " + arguments + " 2>&1";
  ScriptResult result;
  std::FILE* const pipe = popen(line.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run " + line);
  std::array<char, 4096> text;
  for (std::size_t got; (got = std::fread(text.data(), 1, text.size(), pipe)) > 0;)
    result.output.append(text.data(), got);
  const int status = pclose(pipe);
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  std::filesystem::remove_all(folder);
  return result;
}

}  // namespace nanocarbon::test
