// SPDX-License-Identifier: GPL-2.0-or-later
// What the readers of all formats share: the options as checked, and cells as files give them.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "nanocarbon/molecule/formats/molecule_frame.h"
#include "nanocarbon/molecule/formats/species.h"
#include "nanocarbon/molecule/formats/text_input.h"

namespace nanocarbon::molecule {

struct ReadSettings {
  TypeNames types;
  std::string atom_style;
  std::optional<std::array<bool, 3>> periodic;
  std::optional<Cell> cell;  // of files that give none
};

//! \brief The cell of a structure, or none where no direction is periodic.
//! \details The options' directions go before the file's. A direction that is not periodic may lack its vector,
//! as ASE's sheets and tubes have it: it becomes a unit vector perpendicular to the others. Left-handed vectors
//! become right-handed by reversing one; they span the same box.
//! \throw UserError (malformed) at the current line where the vectors do not span a volume
std::optional<Cell> cell_as_read(const TextInput& input, Cell cell, const ReadSettings& settings);

//! \brief Checks what the options say of the periodicity of a structure that has no cell.
//! \throw UserError (unsuitable) where a direction is to be periodic
void require_free_space(const TextInput& input, const ReadSettings& settings);

//! \brief Atoms and their IDs in ascending order of the latter. There are no bonds yet.
//! \return an ID that more than one atom has, if any
std::optional<std::int64_t> sort_by_id(MoleculeFrame& frame);

//! How many atoms to make room for at once, whatever number a file promises.
inline std::size_t room_for(std::size_t atoms) { return std::min<std::size_t>(atoms, 1u << 16); }

}  // namespace nanocarbon::molecule
