// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "nanocarbon/potential/rebo2/parameters.h"

namespace nanocarbon::rebo2 {

//! Reads the numbers of a potential file in the format of LAMMPS's CH.rebo in order, keeping the place for messages.
class PotentialFile {
 public:
  //! \throw UserError (unreadable)
  explicit PotentialFile(const std::filesystem::path& path);

  //! \brief Checks the second line, which names the model after a '#'.
  //! \param example name of such a file, for the message
  //! \throw UserError (malformed), as do the next two
  void require_header(const std::string& model, const char* example);
  //! The first number of the next line that has one, finite; the rest of the line names it.
  double labelled(const char* name);
  //! The next number, be it on this line or a later one.
  double plain(const char* name);
  //! The last number as it stands in the file.
  const std::string& word() const { return word_; }

  //! \throw UserError (malformed) that names the file and the line
  [[noreturn]] void fail(const std::string& what) const;

 private:
  void next_line(const char* name);
  double number(const char* name);

  std::filesystem::path path_;
  std::ifstream file_;
  std::istringstream words_;
  std::string word_;
  std::size_t line_ = 0;
};

//! Reads the beginning of the files of REBO2 and AIREBO: the two-body parameters and the switches.
void read_bond_parameters(PotentialFile& file, Rebo2Parameters& parameters);
//! Reads what follows in both, the angular splines.
void read_angular_splines(PotentialFile& file, Rebo2Parameters& parameters);

}  // namespace nanocarbon::rebo2
