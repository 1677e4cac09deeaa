// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace nanocarbon::cli {

//! \name Checks of an option's number
//! CLI11's own let "nan" through, and name the largest double there is, digit by digit, where they refuse.
//! @{
CLI::Validator above_zero();
CLI::Validator zero_or_more();
CLI::Validator between(double low, double high);
//! @}

//! \brief Lets whole numbers through, as 10000, 1e4 or 10000.0, and writes them in digits for the option to
//! read.
//! \details Refuses those that 64 bits do not hold. Goes to transform(), not to check().
CLI::Validator whole_number();

}  // namespace nanocarbon::cli
