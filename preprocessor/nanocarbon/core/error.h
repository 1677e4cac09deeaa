// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace nanocarbon {

//! Why a run failed; the value is the program's exit code. Documented in README.md, never renumbered.
enum class Failure : int {
  usage = 2,       //!< the command line is wrong
  unreadable = 3,  //!< a file is missing or cannot be opened
  malformed = 4,   //!< a file's contents break its format
  unsuitable = 5,  //!< the file is sound, but what it describes cannot be used (not a 2-manifold, ...)
  size = 6,        //!< the size asked for does not fit the shape
  unwritable = 7,  //!< an output could not be written
  failed = 8       //!< the input was fine, but no good result was reached
};

//! What a user can cause and mend. The message names the file and the place, what is wrong and what to do.
class UserError : public std::runtime_error {
 public:
  UserError(Failure failure, const std::string& message);
  Failure failure() const { return failure_; }

 private:
  Failure failure_;
};

}  // namespace nanocarbon
