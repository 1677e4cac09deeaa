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
