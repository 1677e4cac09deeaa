// SPDX-License-Identifier: GPL-2.0-or-later
// Small valid files of every format and variant that is read: what damaged files begin with.
#pragma once

#include <string>
#include <vector>

namespace nanocarbon::test {

struct Seed {
  std::string file;  //!< its name
  std::string contents;
};

std::vector<Seed> mesh_seeds();
std::vector<Seed> molecule_seeds();

}  // namespace nanocarbon::test
