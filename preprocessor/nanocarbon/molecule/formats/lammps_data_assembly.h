// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nanocarbon/molecule/formats/lammps_data.h"
#include "nanocarbon/molecule/formats/text_input.h"

namespace nanocarbon::molecule {

// The inner parts of read_lammps_data: what the lines of a data file say, before it makes a molecule.

struct LammpsAtom {
  std::int64_t id;
  std::string_view type;  //!< a number or a label
  Vec3 position;          //!< Angstrom, wrapped
  std::array<std::int32_t, 3> image;
  std::size_t line;
};

struct LammpsBond {
  std::int64_t first, second;  //!< atom-IDs
  std::size_t line;
};

struct LammpsType {
  std::optional<double> mass = {};
  std::optional<Element> element = {};  //!< by label or comment
};

struct LammpsFile {
  std::size_t atom_count = 0, type_count = 0, bond_count = 0;  //!< as the header says
  Cell box{Mat3::Zero(), Vec3::Zero(), {true, true, true}};
  std::optional<std::array<bool, 3>> boundary;
  std::map<std::string, LammpsType> types;           //!< by number
  std::map<std::string, std::string> type_of_label;  //!< number
  std::vector<LammpsAtom> atoms;
  std::vector<LammpsBond> bonds;
  AtomStyle atom_style = AtomStyle::atomic;
};

//! The columns of an Atoms section: of a known style, or of the one that the first line's columns leave no
//! doubt about.
class AtomColumns {
 public:
  //! \param comment what follows "Atoms #"
  //! \throw UserError (malformed) where the comment names a style that is not supported
  AtomColumns(const TextInput& input, std::string_view comment, std::optional<AtomStyle> given);

  //! \throw UserError (malformed) where the line is not one of an atom
  LammpsAtom parse(const TextInput& input, const std::vector<std::string_view>& words);
  AtomStyle style() const { return style_.value_or(AtomStyle::atomic); }

 private:
  std::optional<AtomStyle> style_;
};

//! Makes the molecule.
//! \throw UserError as read_lammps_data
LammpsData assemble(const TextInput& input, LammpsFile file, const LammpsReadOptions& options);

}  // namespace nanocarbon::molecule
