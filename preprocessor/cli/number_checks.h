#pragma once

#include <CLI/CLI.hpp>

namespace nanocarbon {

//! \name Checks of an option's number
//! CLI11's own let "nan" through, and name the largest double there is, digit by digit, where they refuse.
//! @{
CLI::Validator above_zero();
CLI::Validator zero_or_more();
CLI::Validator between(double low, double high);
//! @}

}  // namespace nanocarbon
