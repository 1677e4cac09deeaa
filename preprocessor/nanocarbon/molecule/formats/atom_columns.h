// SPDX-License-Identifier: GPL-2.0-or-later
// The columns of a LAMMPS data file's Atoms section.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nanocarbon/core/vec3.h"
#include "nanocarbon/molecule/formats/text_input.h"

namespace nanocarbon::molecule {

//! Numbers of the atom types that have labels.
using TypeLabels = std::map<std::string, std::int64_t, std::less<>>;

//! One line of the Atoms section.
struct LammpsAtom {
  std::int64_t id;
  std::int64_t type;  //!< its number
  Vec3 position;      //!< Angstrom, wrapped
  std::array<std::int32_t, 3> image;
  std::uint32_t line;
};

//! \brief Reads atoms of a known style, or of the one that the columns of all atoms leave no doubt about.
//! \details Without a style, 5 columns are atomic, 7 full, and 6 molecular where the third is an atom type in
//! every line (as a charge it would be 1 e or more on every atom), charge else; three image flags may follow.
class AtomColumns {
 public:
  //! \param comment what follows "Atoms #"; a style only where its first word is one of LAMMPS's
  //! \param given LAMMPS's name of the style, which goes before the comment; empty for none
  //! \param types how many there are
  //! \throw UserError (usage) where the given style is none of LAMMPS's
  AtomColumns(std::string_view comment, std::string_view given, std::size_t types, const TypeLabels& labels);

  //! \throw UserError (malformed) where the line is not one of an atom
  LammpsAtom parse(const TextInput& input, const std::vector<std::string_view>& words);

  //! To be called after the last atom: settles what could not be known before.
  void finish(const TextInput& input, std::vector<LammpsAtom>& atoms) const;

 private:
  struct Style {
    std::string_view name;
    std::size_t type, x;  //!< columns, from 0
    std::size_t columns;  //!< without image flags; the least where more may follow
    bool more = false;    //!< an unknown number of columns follows
  };
  static std::optional<Style> style_named(std::string_view name);
  Style guess(const TextInput& input, const std::vector<std::string_view>& words);
  std::int64_t type_of(const TextInput& input, std::string_view word) const;
  //! The number of an atom type, or nothing where the word is none.
  std::optional<std::int64_t> find_type(std::string_view word) const;

  std::optional<Style> style_;
  std::size_t types_;
  const TypeLabels& labels_;
  bool third_in_doubt_ = false;
  std::vector<std::int64_t> third_as_type_;  // while all of them are types
};

}  // namespace nanocarbon::molecule
