// SPDX-License-Identifier: GPL-2.0-or-later
//! \file
//! \brief What an object built for a LAMMPS of 2025 or later brings with it: there Error::all is inline and
//! calls a function that LAMMPS before does not have.

#include <string>

namespace LAMMPS_NS {

class Error {
 public:
  void all(const std::string& file, int line, const std::string& message);
  [[gnu::weak]] void all(const std::string& file, int line, int failed, const std::string& message);
};

void Error::all(const std::string& file, int line, const std::string& message) {
  all(file, line, -1, message);
}

}  // namespace LAMMPS_NS
