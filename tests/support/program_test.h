// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "support/temporary_folder.h"

namespace nanocarbon::test {

//! Runs the program, NANOCARBON_PROGRAM, as a user does: exit codes, messages, files in a folder of the test's own.
class ProgramTest : public testing::Test {
 protected:
  struct Outcome {
    int exit_code;
    std::string out;
    std::string err;
  };

  Outcome run(const std::string& arguments) const {
    const std::string out = path(".out"), err = path(".err");
    const std::string line = NANOCARBON_PROGRAM " " + arguments + " >" + out + " 2>" + err + " </dev/null";
    const int status = std::system(line.c_str());
    const Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(".out"), contents(".err")};
    std::filesystem::remove(out);
    std::filesystem::remove(err);
    return outcome;
  }

  //! A path in the test's folder.
  std::string path(const std::string& name) const { return (folder / name).string(); }
  //! Writes a file in the test's folder and returns its path.
  std::string file(const std::string& name, const std::string& text) const {
    return folder.file(name, text).string();
  }
  bool exists(const std::string& name) const { return std::filesystem::exists(folder / name); }
  //! The bytes of a file in the test's folder.
  std::string contents(const std::string& name) const { return contents_of(folder / name); }

  //! A mesh in the test's folder: 6 vertices, 8 faces.
  std::string octahedron() const {
    return file("octahedron.off",
                "OFF\n6 8 0\n1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\n"
                "3 0 2 4\n3 2 1 4\n3 1 3 4\n3 3 0 4\n3 2 0 5\n3 1 2 5\n3 3 1 5\n3 0 3 5\n");
  }

  TemporaryFolder folder;
};

}  // namespace nanocarbon::test
