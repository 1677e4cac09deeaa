// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace nanocarbon::mesh {

//! The scalar types of PLY properties, by both their old and new names.
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

std::size_t size_of(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type;                            //!< of the values
  std::optional<PlyType> list_count_type;  //!< set for a list
};

struct PlyElement {
  std::string name;
  std::uint64_t count;  //!< as promised
  std::vector<PlyProperty> properties;

  //! Index of the first property of one of two names, or nothing.
  std::optional<std::size_t> find(std::string_view name_a, std::string_view name_b) const;
};

enum class PlyEncoding { text, little_endian, big_endian };

struct PlyHeader {
  PlyEncoding encoding;
  std::vector<PlyElement> elements;
  std::size_t bytes;  //!< length of the header with the line end of end_header
  std::size_t lines;
};

//! \throw UserError (malformed) with the line
PlyHeader read_ply_header(std::string_view contents, const std::string& file);

}  // namespace nanocarbon::mesh
