// SPDX-License-Identifier: GPL-2.0-or-later
#include "number_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace nanocarbon::cli {
namespace {

template <class Test>
CLI::Validator number_that(const std::string& rule, Test test) {
  return CLI::Validator(
      [=](std::string& text) {
        double number = 0.0;
        const bool is_number = CLI::detail::lexical_cast(text, number) && std::isfinite(number);
        return is_number && test(number) ? std::string() : fmt::format("'{}' is not a number {}", text, rule);
      },
      rule);
}

bool is_digits(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

}  // namespace

CLI::Validator whole_number() {
  return CLI::Validator(
      [](std::string& text) {
        constexpr double exact = 9007199254740992.0;  // 2^53; larger ones must come in digits
        double number = 0.0;
        if (!CLI::detail::lexical_cast(text, number) || number != std::floor(number))
          return fmt::format("'{}' is not a whole number, such as 10000 or 1e4", text);
        if (is_digits(text)) {
          // CLI11 reads digits after a leading zero as octal, and cuts what does not fit.
          text.erase(0, std::min(text.find_first_not_of('0'), text.size() - 1));
          std::uint64_t whole = 0;
          if (std::from_chars(text.data(), text.data() + text.size(), whole).ec == std::errc())
            return std::string();
        }
        if (!(std::abs(number) <= exact)) return fmt::format("'{}' is too large", text);
        text = fmt::format("{:.0f}", number);
        return std::string();
      },
      "");
}

CLI::Validator above_zero() {
  return number_that("above 0", [](double number) { return number > 0.0; });
}

CLI::Validator zero_or_more() {
  return number_that("of 0 or more", [](double number) { return number >= 0.0; });
}

CLI::Validator between(double low, double high) {
  return number_that(fmt::format("from {} to {}", low, high),
                     [=](double number) { return low <= number && number <= high; });
}

}  // namespace nanocarbon::cli
