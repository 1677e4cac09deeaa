// SPDX-License-Identifier: GPL-2.0-or-later
#include "bond_topology/options.h"

#include <cctype>

#include "atom.h"
#include "error.h"
#include "utils.h"

using namespace LAMMPS_NS;

namespace nanocarbon {
namespace {

[[noreturn]] void stop(LAMMPS* lmp, const std::string& problem) {
  lmp->error->all(FLERR, "Illegal fix bond/topology command: " + problem);
}

// element E1 E2 ... EN, one for each atom type.
std::vector<std::optional<Element>> read_elements(LAMMPS* lmp, int count, char** names) {
  const int types = lmp->atom->ntypes;
  if (count < types)
    stop(lmp, "element needs C, H or NULL for each of the " + std::to_string(types) + " atom types");
  std::vector<std::optional<Element>> elements(static_cast<std::size_t>(types) + 1);
  for (int type = 1; type <= types; ++type) {
    const std::string name = names[type - 1];
    const auto element = element_from_symbol(name);
    if (!element && name != "NULL") stop(lmp, "element must be C, H or NULL, not " + name);
    elements[static_cast<std::size_t>(type)] = element;
  }
  return elements;
}

}  // namespace

bool read_yes_or_no(LAMMPS* lmp, const std::string& keyword, const std::string& value) {
  if (value != "yes" && value != "no") stop(lmp, keyword + " must be yes or no, not " + value);
  return value == "yes";
}

BondTopologyOptions read_options(LAMMPS* lmp, int narg, char** arg) {
  BondTopologyOptions options;
  if (narg < 4) stop(lmp, "the number of steps between looks is missing");
  options.every = utils::inumeric(FLERR, arg[3], false, lmp);
  if (options.every <= 0)
    stop(lmp, std::string("the number of steps between looks must be above 0, not ") + arg[3]);
  topology::BondWindow& carbon = options.distances.carbon_carbon;
  for (int k = 4; k < narg; k += 2) {
    const std::string keyword = arg[k];
    if (k + 1 == narg) stop(lmp, "the value of " + keyword + " is missing");
    if (keyword == "form") {
      carbon.form = utils::numeric(FLERR, arg[k + 1], false, lmp);
    } else if (keyword == "break") {
      carbon.breaking = utils::numeric(FLERR, arg[k + 1], false, lmp);
    } else if (keyword == "maxring") {
      options.topology.max_ring = utils::inumeric(FLERR, arg[k + 1], false, lmp);
    } else if (keyword == "file" || keyword == "append") {
      options.file = arg[k + 1];
      options.append = keyword == "append";
    } else if (keyword == "element") {
      options.elements = read_elements(lmp, narg - k - 1, arg + k + 1);
      k += lmp->atom->ntypes - 1;
    } else if (keyword == "halt") {
      options.halt = read_yes_or_no(lmp, keyword, arg[k + 1]);
    } else {
      stop(lmp, "unknown keyword " + keyword);
    }
  }
  if (!(carbon.form > 0.0)) stop(lmp, "form must be above 0");
  if (carbon.breaking < carbon.form) stop(lmp, "break must not be below form");
  if (options.topology.max_ring < 3 || options.topology.max_ring > 255)
    stop(lmp, "maxring must be from 3 to 255");
  return options;
}

}  // namespace nanocarbon
