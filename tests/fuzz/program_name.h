// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace nanocarbon::test {

//! \brief What a fuzzer reads, by the name that it was called by: "off" where that is build/fuzz_mesh_off.
//! \details Readers of one kind share a program that has a name for each.
inline std::string fuzzed_by(std::string_view program) {
  constexpr std::string_view begin = "fuzz_";
  program.remove_prefix(program.rfind(begin) + begin.size());
  return std::string(program.substr(program.find('_') + 1));
}

}  // namespace nanocarbon::test
