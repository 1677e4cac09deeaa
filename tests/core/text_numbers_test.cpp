// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/core/text_numbers.h"

#include <gtest/gtest.h>

#include <limits>

namespace nanocarbon {
namespace {

TEST(TextNumbers, RealsAreExactAndStandAlone) {
  double value = 0;
  for (const auto& [text, expected] :
       {std::pair("0.1", 0.1), {"+2.5e-3", 2.5e-3}, {"-7", -7.0}, {"1E5", 1e5}, {".5", 0.5}}) {
    EXPECT_EQ(read_real(text, value), NumberToken::number) << text;
    EXPECT_EQ(value, expected) << text;
  }
  for (const char* text : {"", "+", "+-1", "1,5", "1.5x", " 1", "1 ", "e5", "0x10"})
    EXPECT_EQ(read_real(text, value), NumberToken::not_a_number) << text;
}

TEST(TextNumbers, WhatIsTooSmallIsZeroAndWhatIsTooLargeIsToldApart) {
  double value = 1;
  for (const std::string& text :
       {std::string("1e-400"), std::string("-1E-999"), "0." + std::string(400, '0') + "1"}) {
    EXPECT_EQ(read_real(text, value), NumberToken::number) << text;
    EXPECT_EQ(value, 0) << text;
  }
  for (const std::string& text : {std::string("1e400"), std::string(400, '9')})
    EXPECT_EQ(read_real(text, value), NumberToken::too_large) << text;
}

TEST(TextNumbers, WholeNumbersDoNotOverflow) {
  std::int64_t value = 0;
  EXPECT_EQ(read_integer("9223372036854775807", value), NumberToken::number);
  EXPECT_EQ(value, std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(read_integer("+12", value), NumberToken::number);
  EXPECT_EQ(value, 12);
  EXPECT_EQ(read_integer("9223372036854775808", value), NumberToken::too_large);
  for (const char* text : {"", "1.0", "1e3", "12a", "--1"})
    EXPECT_EQ(read_integer(text, value), NumberToken::not_a_number) << text;
}

TEST(TextNumbers, MessagesShowTextShortAndHarmless) {
  EXPECT_EQ(shown("a\tb\x1b[31m\xff"), "a b?[31m?");
  EXPECT_EQ(shown("0123456789", 4), "0123...");
  EXPECT_EQ(shown("0123", 4), "0123");
}

}  // namespace
}  // namespace nanocarbon
