// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>

namespace nanocarbon::mesh {

//! The name of an element or attribute without its namespace's prefix.
std::string_view local_name(std::string_view name);

//! The first child with a local name; an empty node where there is none.
pugi::xml_node child_of(const pugi::xml_node& node, std::string_view name);
//! The value of an attribute by its local name; empty where there is none.
std::string_view attribute_of(const pugi::xml_node& node, std::string_view name);

//! A file of XML (parsed by pugixml), and where in it what is wrong.
class XmlFile {
 public:
  //! \param text has to stay as long as this
  //! \param file name for messages
  //! \throw UserError (malformed) with the line
  XmlFile(std::string_view text, std::string file);

  pugi::xml_node root() const { return document_.document_element(); }
  const std::string& file() const { return file_; }

  //! \brief An attribute as a finite number that is small enough for a coordinate.
  //! \throw UserError (malformed) where it is missing or none
  double coordinate(const pugi::xml_node& node, std::string_view name) const;
  //! The same for a whole number from 0 on.
  std::uint64_t count(const pugi::xml_node& node, std::string_view name) const;

  //! \throw UserError (malformed) with the element's line
  [[noreturn]] void fail(const pugi::xml_node& node, const std::string& what) const;
  [[noreturn]] void fail(const pugi::xml_node& node, const std::string& what,
                         const std::string& remedy) const;

 private:
  [[noreturn]] void fail_at(std::ptrdiff_t offset, const std::string& what, const std::string& remedy) const;

  std::string_view text_;
  std::string file_;
  pugi::xml_document document_;
};

}  // namespace nanocarbon::mesh
