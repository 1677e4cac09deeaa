// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "nanocarbon/mesh/parsing/byte_order.h"
#include "nanocarbon/mesh/parsing/xml_file.h"

namespace nanocarbon::mesh {

//! A VTK file of XML and the numbers in its arrays: as text, in base64 or in the data appended at its end, raw or in
//! base64, packed by zlib or not.
class VtkXml {
 public:
  //! \param contents have to stay as long as this
  //! \throw UserError (malformed)
  VtkXml(std::string_view contents, const std::string& file);

  const XmlFile& xml() const { return xml_; }
  //! \brief The numbers of a DataArray.
  //! \throw UserError (malformed) with the line of the array
  std::vector<double> numbers(const pugi::xml_node& array) const;

 private:
  std::string bytes_of_array(const pugi::xml_node& array) const;
  std::string unpacked(const pugi::xml_node& array, std::string_view source, bool base64) const;
  std::string decoded(const pugi::xml_node& array, std::string_view source, std::size_t bytes,
                      bool base64) const;
  std::size_t header_number(const std::string& header, std::size_t index) const;

  std::string text_;  // without the appended data
  XmlFile xml_;
  std::string_view appended_;
  bool appended_base64_ = false;
  ByteOrder order_ = ByteOrder::little;
  std::size_t header_bytes_ = 4;
  bool packed_ = false;
};

}  // namespace nanocarbon::mesh
