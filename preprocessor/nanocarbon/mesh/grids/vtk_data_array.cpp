// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/grids/vtk_data_array.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "nanocarbon/core/text_numbers.h"
#include "nanocarbon/mesh/grids/vtk_numbers.h"
#include "nanocarbon/mesh/parsing/base64.h"
#include "nanocarbon/mesh/parsing/inflate.h"
#include "nanocarbon/mesh/parsing/text_scanner.h"
#include "nanocarbon/mesh/parsing/value_cursor.h"

namespace nanocarbon::mesh {
namespace {

constexpr std::size_t largest_array = std::size_t{4} << 30;

// Raw data is no XML: what stands before it, made whole.
std::string without_appended(std::string_view contents) {
  const std::size_t begin = contents.find("<AppendedData");
  if (begin == contents.npos) return std::string(contents);
  const std::size_t end = contents.find('>', begin);
  if (end == contents.npos) return std::string(contents);
  return std::string(contents.substr(0, end + 1)) + "</AppendedData></VTKFile>";
}

std::string without_blanks(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (const char c : text)
    if (c != ' ' && c != '\n' && c != '\r' && c != '\t') result.push_back(c);
  return result;
}

}  // namespace

VtkXml::VtkXml(std::string_view contents, const std::string& file)
    : text_(without_appended(contents)), xml_(text_, file) {
  const pugi::xml_node root = xml_.root();
  if (local_name(root.name()) != "VTKFile") xml_.fail(root, "the file is no VTK file");
  if (attribute_of(root, "byte_order") == "BigEndian") order_ = ByteOrder::big;
  if (attribute_of(root, "header_type") == "UInt64") header_bytes_ = 8;
  const std::string_view compressor = attribute_of(root, "compressor");
  packed_ = !compressor.empty();
  if (packed_ && compressor != "vtkZLibDataCompressor")
    xml_.fail(root, fmt::format("its arrays are packed by {}", mesh::quoted(compressor)),
              "save it with the compressor ZLib, or without one");
  const pugi::xml_node appended = child_of(root, "AppendedData");
  if (!appended) return;
  appended_base64_ = attribute_of(appended, "encoding") == "base64";
  const std::size_t tag = contents.find('>', contents.find("<AppendedData"));
  const std::size_t begin = contents.find('_', tag);
  if (begin == contents.npos) xml_.fail(appended, "the appended data does not begin with an underscore");
  appended_ = contents.substr(begin + 1);
  const std::size_t end = appended_.rfind("</AppendedData");
  if (end != appended_.npos) appended_ = appended_.substr(0, end);
}

std::vector<double> VtkXml::numbers(const pugi::xml_node& array) const {
  const std::string_view type_name = attribute_of(array, "type");
  const std::optional<VtkType> type = vtk_type(type_name);
  if (!type) xml_.fail(array, fmt::format("its type {} is none of numbers", mesh::quoted(type_name)));
  if (attribute_of(array, "format") == "ascii") {
    std::vector<double> result;
    ValueCursor words(array.child_value(), xml_.file());
    for (std::string_view word = words.word(); !word.empty(); word = words.word())
      if (read_real(word, result.emplace_back()) != NumberToken::number)
        xml_.fail(array, fmt::format("the array {} has {} for a number",
                                     mesh::quoted(attribute_of(array, "Name")), mesh::quoted(word)));
    return result;
  }
  return vtk_numbers(bytes_of_array(array), *type, order_);
}

std::string VtkXml::bytes_of_array(const pugi::xml_node& array) const {
  const std::string_view format = attribute_of(array, "format");
  if (format == "binary") return unpacked(array, without_blanks(array.child_value()), true);
  if (format != "appended") xml_.fail(array, fmt::format("its format {} is not known", mesh::quoted(format)));
  const std::uint64_t offset = xml_.count(array, "offset");
  if (offset > appended_.size())
    xml_.fail(array, fmt::format("its data begins at byte {} of {} appended ones", offset, appended_.size()));
  return unpacked(array, appended_.substr(offset), appended_base64_);
}

// The first bytes of a source; of base64, what a stream of so many bytes takes.
std::string VtkXml::decoded(const pugi::xml_node& array, std::string_view source, std::size_t bytes,
                            bool base64) const {
  const std::size_t characters = base64 ? base64_length(bytes) : bytes;
  if (bytes > largest_array || characters > source.size())
    xml_.fail(array, fmt::format("the data of the array {} ends too early",
                                 mesh::quoted(attribute_of(array, "Name"))));
  if (!base64) return std::string(source.substr(0, bytes));
  const std::optional<std::string> result = from_base64(source.substr(0, characters));
  if (!result || result->size() < bytes)
    xml_.fail(array, fmt::format("the array {} is not in base64", mesh::quoted(attribute_of(array, "Name"))));
  return result->substr(0, bytes);
}

std::size_t VtkXml::header_number(const std::string& header, std::size_t index) const {
  const char* at = header.data() + index * header_bytes_;
  return header_bytes_ == 8 ? load<std::uint64_t>(at, order_) : load<std::uint32_t>(at, order_);
}

// Before the data stands its size; before packed data the number of blocks, the size of all but the last unpacked, that
// of the last, and the size of each as packed.
std::string VtkXml::unpacked(const pugi::xml_node& array, std::string_view source, bool base64) const {
  if (!packed_) {
    const std::size_t size = header_number(decoded(array, source, header_bytes_, base64), 0);
    if (size > largest_array) xml_.fail(array, fmt::format("the array has {} bytes", size));
    return decoded(array, source, header_bytes_ + size, base64).substr(header_bytes_);
  }
  // Without blocks, some versions write nothing but their number.
  const std::size_t blocks = header_number(decoded(array, source, header_bytes_, base64), 0);
  if (blocks == 0) return {};
  if (blocks > source.size()) xml_.fail(array, fmt::format("the array has {} blocks", blocks));
  const std::size_t header_size = (3 + blocks) * header_bytes_;
  const std::string header = decoded(array, source, header_size, base64);
  const std::size_t size = header_number(header, 1), last = header_number(header, 2);
  std::size_t packed_size = 0;
  for (std::size_t block = 0; block < blocks; ++block) {
    packed_size += std::min(header_number(header, 3 + block), largest_array);
    if (packed_size > source.size()) xml_.fail(array, "the blocks of the array are larger than the file");
  }
  const std::string data =
      decoded(array, source.substr(base64 ? base64_length(header_size) : header_size), packed_size, base64);
  std::string result;
  for (std::size_t block = 0, at = 0; block < blocks; ++block) {
    const std::size_t taken = header_number(header, 3 + block);
    const std::size_t expected = block + 1 == blocks && last > 0 ? last : size;
    const std::optional<std::string> part =
        inflated(std::string_view(data).substr(at, taken), Packing::zlib, std::min(expected, largest_array));
    if (!part || part->size() != expected)
      xml_.fail(array, fmt::format("block {} of the array {} is damaged", block,
                                   mesh::quoted(attribute_of(array, "Name"))));
    result += *part;
    at += taken;
  }
  return result;
}

}  // namespace nanocarbon::mesh
