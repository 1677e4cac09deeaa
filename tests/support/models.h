// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace nanocarbon::test {

//! The folder of real meshes that the variable NANOCARBON_MODELS names, or an empty path.
inline std::filesystem::path models_folder() {
  const char* folder = std::getenv("NANOCARBON_MODELS");
  return folder && *folder ? std::filesystem::path(folder) : std::filesystem::path();
}

}  // namespace nanocarbon::test

//! Skips the test, saying so, where no folder of real meshes was named.
#define NANOCARBON_NEEDS_MODELS()                \
  if (nanocarbon::test::models_folder().empty()) \
  GTEST_SKIP() << "set NANOCARBON_MODELS to a folder of meshes to run this test"
