// SPDX-License-Identifier: GPL-2.0-or-later
// What element an atom is, by what its file calls it and what the user says. Nothing is guessed.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nanocarbon/core/element.h"
#include "nanocarbon/core/periodic_table.h"
#include "nanocarbon/molecule/formats/text_input.h"

namespace nanocarbon::molecule {

//! \brief The element that an atom's name leaves no doubt about.
//! \details A symbol in its own case (C, Au), a single letter in any (c), an element's English name (carbon),
//! or one of the first two followed by what is no letter (C60, c_3, Au1). Not CA, ca or CT: calcium, or a
//! force field's name for carbon; nor numbers.
std::optional<AtomicNumber> atomic_number_of_label(std::string_view label);

//! \brief Names of types that the user gave elements: `--types C H` (of types 1, 2, ...) or `1=C CA=C`.
//! \details Any element may be said, since a file may have types that no atom is of.
class TypeNames {
 public:
  TypeNames() = default;
  //! \param words as above; commas separate as blanks do
  //! \throw UserError (usage)
  explicit TypeNames(const std::vector<std::string>& words);

  bool empty() const { return elements_.empty(); }
  //! The number of types when they were said in order, else nothing.
  std::optional<std::size_t> in_order() const { return in_order_; }
  //! What was said of a type, which counts as used then.
  std::optional<AtomicNumber> find(std::string_view type);
  //! The types that were never asked for.
  std::vector<std::string> unused() const;

 private:
  struct Said {
    AtomicNumber element;
    bool used = false;
  };
  std::map<std::string, Said, std::less<>> elements_;
  std::optional<std::size_t> in_order_;
};

//! Elements of names as they come from a file's lines, each worked out once.
class SpeciesReader {
 public:
  explicit SpeciesReader(TypeNames& types) : types_(types) {}

  //! \brief The element of the atom on the current line.
  //! \throw UserError (unsuitable) for names that leave doubt, and for other elements
  Element of_name(const TextInput& input, std::string_view name);
  //! The same where the file says an atomic number.
  Element of_atomic_number(const TextInput& input, std::string_view number);

 private:
  Element look_up(const TextInput& input, std::string_view name);

  TypeNames& types_;
  std::map<std::string, Element, std::less<>> known_;
  std::string last_;
  Element last_element_ = Element::carbon;
};

//! \brief Carbon and hydrogen as they are; others are refused.
//! \param what for the message: "atom 3" or "type 2 (mass 196.97 g/mol)"
//! \throw UserError (unsuitable) "where: what is gold (Au); ..."
Element carbon_or_hydrogen(AtomicNumber z, const std::string& where, const std::string& what);

}  // namespace nanocarbon::molecule
