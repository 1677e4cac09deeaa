// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/rebo2/parameter_file.h"

#include "nanocarbon/potential/rebo2/potential_file.h"

namespace nanocarbon::rebo2 {

Rebo2Parameters read_rebo2_parameters(const std::filesystem::path& path) {
  PotentialFile file(path);
  file.require_header("REBO2", "CH.rebo");
  Rebo2Parameters parameters = rebo2_parameters();
  read_bond_parameters(file, parameters);
  for (const char* unused : {"rcLJmin", "rcLJmax", "bLJmin", "bLJmax", "epsilon", "sigma", "epsilonT"})
    for (int pair = 0; pair < 3; ++pair) file.labelled(unused);
  read_angular_splines(file, parameters);
  return parameters;
}

}  // namespace nanocarbon::rebo2
