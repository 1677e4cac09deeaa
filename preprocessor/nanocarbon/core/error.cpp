// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/core/error.h"

namespace nanocarbon {

UserError::UserError(Failure failure, const std::string& message)
    : std::runtime_error(message), failure_(failure) {}

}  // namespace nanocarbon
