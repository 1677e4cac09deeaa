// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "nanocarbon/core/error.h"

namespace nanocarbon::test {

//! The message of a UserError that the action must throw.
template <typename Action>
std::string refusal(Failure expected, const Action& action) {
  try {
    action();
  } catch (const UserError& error) {
    EXPECT_EQ(error.failure(), expected) << error.what();
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return {};
}

}  // namespace nanocarbon::test
