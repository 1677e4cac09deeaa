// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/formats/ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "nanocarbon/mesh/parsing/text_scanner.h"

namespace nanocarbon::mesh {
namespace {

using enum PlyType;

constexpr std::array<std::pair<std::string_view, PlyType>, 22> type_names = {
    {{"char", int8},      {"int8", int8},        {"uchar", uint8},    {"uint8", uint8},
     {"short", int16},    {"int16", int16},      {"ushort", uint16},  {"uint16", uint16},
     {"int", int32},      {"int32", int32},      {"uint", uint32},    {"uint32", uint32},
     {"int64", int64},    {"long", int64},       {"longlong", int64}, {"uint64", uint64},
     {"ulong", uint64},   {"ulonglong", uint64}, {"float", float32},  {"float32", float32},
     {"double", float64}, {"float64", float64}}};

PlyType read_type(TextScanner& scanner) {
  const std::string_view word = scanner.word();
  const auto found =
      std::find_if(type_names.begin(), type_names.end(), [&](const auto& t) { return t.first == word; });
  if (found == type_names.end())
    scanner.fail(fmt::format("{} is not a type of a PLY property", quoted(word)));
  return found->second;
}

PlyProperty read_property(TextScanner& scanner) {
  PlyProperty property{{}, float32, std::nullopt};
  TextScanner ahead = scanner;
  if (ahead.word() == "list") {
    scanner.word();
    property.list_count_type = read_type(scanner);
  }
  property.type = read_type(scanner);
  property.name = scanner.word();
  if (property.name.empty()) scanner.fail("the property has no name");
  return property;
}

PlyEncoding read_format(TextScanner& scanner) {
  const std::string_view encoding = scanner.word();
  const std::string_view version = scanner.word();
  if (version != "1.0")
    scanner.fail(fmt::format("PLY version {} is not supported", quoted(version)), "export as 1.0");
  if (encoding == "ascii") return PlyEncoding::text;
  if (encoding == "binary_little_endian") return PlyEncoding::little_endian;
  if (encoding == "binary_big_endian") return PlyEncoding::big_endian;
  scanner.fail(fmt::format("{} is not a PLY format", quoted(encoding)));
}

// Where the header ends. A binary body may hold any bytes, so that the line end is the one of the first line.
std::string_view header_text(std::string_view contents, const std::string& file) {
  if (!contents.starts_with("ply")) fail_at_line(file, 1, "a PLY file must begin with 'ply'");
  const std::size_t first_end = contents.find_first_of("\r\n");
  const bool lone_cr =
      first_end != contents.npos && contents[first_end] == '\r' && contents.substr(first_end, 2) != "\r\n";
  const char line_end = lone_cr ? '\r' : '\n';
  std::size_t begin = 0;
  std::size_t line = 1;
  while (begin < contents.size()) {
    const std::size_t end = contents.find(line_end, begin);
    if (end == contents.npos) {
      if (contents.substr(begin, 10) == "end_header") return contents;
      break;
    }
    std::string_view text = contents.substr(begin, end - begin);
    text = text.substr(0, text.find_last_not_of(" \t\r") + 1);
    if (text == "end_header") return contents.substr(0, end + 1);
    begin = end + 1;
    ++line;
  }
  fail_at_line(file, line, "the file ends before end_header");
}

}  // namespace

std::size_t size_of(PlyType type) {
  switch (type) {
    case int8:
    case uint8:
      return 1;
    case int16:
    case uint16:
      return 2;
    case int32:
    case uint32:
    case float32:
      return 4;
    case int64:
    case uint64:
    case float64:
      break;
  }
  return 8;
}

std::optional<std::size_t> PlyElement::find(std::string_view name_a, std::string_view name_b) const {
  for (std::size_t i = 0; i < properties.size(); ++i)
    if (properties[i].name == name_a || properties[i].name == name_b) return i;
  return std::nullopt;
}

PlyHeader read_ply_header(std::string_view contents, const std::string& file) {
  const std::string_view text = header_text(contents, file);
  TextScanner scanner(text, file, {'\0', false});
  scanner.next_line();
  if (scanner.word() != "ply" || !scanner.at_line_end()) scanner.fail("a PLY file must begin with 'ply'");
  PlyHeader header{PlyEncoding::text, {}, text.size(), 0};
  bool has_format = false;
  while (scanner.next_line()) {
    const std::string_view keyword = scanner.word();
    if (keyword == "format") {
      header.encoding = read_format(scanner);
      has_format = true;
    } else if (keyword == "element") {
      PlyElement element;
      element.name = scanner.word();
      element.count = scanner.count("number of elements");
      header.elements.push_back(std::move(element));
    } else if (keyword == "property") {
      if (header.elements.empty()) scanner.fail("a property comes before the first element");
      header.elements.back().properties.push_back(read_property(scanner));
    } else if (keyword != "comment" && keyword != "obj_info" && keyword != "end_header") {
      scanner.fail(fmt::format("{} is not a keyword of a PLY header", quoted(keyword)));
    }
  }
  if (!has_format) scanner.fail("the header has no 'format' line");
  header.lines = scanner.line_number();
  return header;
}

}  // namespace nanocarbon::mesh
