// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>

namespace nanocarbon::test {

//! The largest number of bytes that a single `new` has asked for since the last reset. A program that links
//! allocation_watch.cpp has its operator new replaced to keep count.
std::size_t largest_allocation();
void reset_largest_allocation();

}  // namespace nanocarbon::test
