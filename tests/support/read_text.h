// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "nanocarbon/core/error.h"
#include "nanocarbon/molecule/formats/read_molecule.h"

namespace nanocarbon::test {

//! The frame of a file with this text, as a user's file would be read.
inline molecule::MoleculeFrame read_text(const std::string& text, const std::string& file,
                                         const molecule::MoleculeReadOptions& options = {},
                                         std::optional<std::int64_t> frame = {}) {
  molecule::MoleculeFile opened(text, file, options);
  return molecule::read_molecule(opened, file, frame);
}

inline std::vector<molecule::MoleculeFrame> read_frames(const std::string& text, const std::string& file,
                                                        const molecule::MoleculeReadOptions& options = {}) {
  molecule::MoleculeFile opened(text, file, options);
  std::vector<molecule::MoleculeFrame> frames;
  while (auto frame = opened.next()) frames.push_back(std::move(*frame));
  return frames;
}

//! What a user is told who has such a file read, or that nothing was.
inline std::string error_of_text(const std::string& text, const std::string& file,
                                 const molecule::MoleculeReadOptions& options = {}) {
  try {
    read_frames(text, file, options);
  } catch (const UserError& error) {
    return error.what();
  }
  return "nothing was thrown";
}

}  // namespace nanocarbon::test
