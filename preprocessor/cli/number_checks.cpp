#include "number_checks.h"

#include <fmt/format.h>

#include <cmath>

namespace nanocarbon {
namespace {

template <class Test>
CLI::Validator number_that(const std::string& rule, Test test) {
  return CLI::Validator(
      [=](std::string& text) {
        double number = 0.0;
        const bool is_number = CLI::detail::lexical_cast(text, number) && std::isfinite(number);
        return is_number && test(number) ? std::string() : fmt::format("'{}' is no number {}", text, rule);
      },
      rule);
}

}  // namespace

CLI::Validator whole_number() {
  return CLI::Validator(
      [](std::string& text) {
        constexpr double exact = 9007199254740992.0;  // 2^53; larger ones must come in digits
        if (!text.empty() && text.find_first_not_of("0123456789") == std::string::npos) return std::string();
        double number = 0.0;
        if (!CLI::detail::lexical_cast(text, number) || !(std::abs(number) <= exact) ||
            number != std::floor(number))
          return fmt::format("'{}' is no whole number, such as 10000 or 1e4", text);
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

}  // namespace nanocarbon
