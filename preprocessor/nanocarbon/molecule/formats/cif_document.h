// SPDX-License-Identifier: GPL-2.0-or-later
// What a CIF file says, as tables of plain text. gemmi parses it, behind this header alone.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace nanocarbon::molecule {

//! A loop of a block; or the values outside of loops, as a table of one row.
struct CifTable {
  std::vector<std::string> tags;    //!< in lower case
  std::vector<std::string> values;  //!< row by row, without quotes; empty where the file says `?` or `.`

  std::size_t rows() const { return tags.empty() ? 0 : values.size() / tags.size(); }
  const std::string& at(std::size_t row, std::size_t column) const {
    return values[row * tags.size() + column];
  }
  //! The column of a tag, in lower case.
  std::optional<std::size_t> column(const std::string& tag) const;
};

//! A data block. Each tag is in one of its tables at most.
struct CifBlock {
  std::string name;
  std::vector<CifTable> tables;

  //! The table that has a tag (in lower case), or null.
  const CifTable* table_with(const std::string& tag) const;
  //! The first value of a tag; empty where there is none.
  std::string value(const std::string& tag) const;
};

//! \param name of the file, for messages
//! \throw std::exception naming the file and the place
std::vector<CifBlock> parse_cif(const std::string& text, const std::string& name);

//! A number as CIF has it: 1.23 or 1.23(4), whose uncertainty is dropped. NaN for anything else.
double cif_number(const std::string& text);

}  // namespace nanocarbon::molecule
