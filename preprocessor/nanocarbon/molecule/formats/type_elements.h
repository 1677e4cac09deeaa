// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "nanocarbon/core/element.h"
#include "nanocarbon/molecule/formats/atom_columns.h"
#include "nanocarbon/molecule/formats/read_settings.h"

namespace nanocarbon::molecule {

//! What a LAMMPS data file says of an atom type.
struct LammpsType {
  std::optional<double> mass = {};
  std::string label = {};    //!< in Atom Type Labels
  std::string comment = {};  //!< on its mass, where that is a single word
};

using LammpsTypes = std::map<std::int64_t, LammpsType>;

//! \brief The elements of the types that atoms are of.
//! \details By the options; else by mass (core/periodic_table.h); else by label, else by comment (species.h). A mass
//! of exactly 1 is hydrogen's only in a file with carbon's mass too: else it stands for no mass.
//! \param count how many types the file says it has
//! \throw UserError (unsuitable) naming the atom's line, the type and what it is, or how to say what it is;
//! also where mass and label take carbon for hydrogen or the other way round
//! \throw UserError (usage) where the options name more types than there are
std::map<std::int64_t, Element> elements_of_types(const TextInput& input, const LammpsTypes& types,
                                                  std::size_t count, const std::vector<LammpsAtom>& atoms,
                                                  ReadSettings& settings, std::vector<std::string>& warnings);

}  // namespace nanocarbon::molecule
