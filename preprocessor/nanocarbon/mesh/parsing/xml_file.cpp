// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/parsing/xml_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "nanocarbon/core/text_numbers.h"
#include "nanocarbon/mesh/parsing/text_scanner.h"

namespace nanocarbon::mesh {
namespace {

constexpr const char* mend = "repair the file or export it again";

}  // namespace

std::string_view local_name(std::string_view name) { return name.substr(name.find(':') + 1); }

pugi::xml_node child_of(const pugi::xml_node& node, std::string_view name) {
  return node.find_child([&](const pugi::xml_node& child) { return local_name(child.name()) == name; });
}

std::string_view attribute_of(const pugi::xml_node& node, std::string_view name) {
  return node.find_attribute([&](const pugi::xml_attribute& a) { return local_name(a.name()) == name; })
      .value();
}

XmlFile::XmlFile(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {
  const pugi::xml_parse_result result = document_.load_buffer(text.data(), text.size());
  if (!result) fail_at(result.offset, fmt::format("the file is not XML: {}", result.description()), mend);
  if (!root()) fail_at(0, "the file has no element", "give a whole file");
}

double XmlFile::coordinate(const pugi::xml_node& node, std::string_view name) const {
  const std::string_view text = attribute_of(node, name);
  double value = 0.0;
  if (read_real(text, value) != NumberToken::number)
    fail(node, fmt::format("the element '{}' has no number in its attribute '{}', but {}", node.name(), name,
                           mesh::quoted(text)));
  if (const char* fault = coordinate_fault(value))
    fail(node,
         fmt::format("the attribute '{}' of '{}', {}, {}", name, node.name(), mesh::quoted(text), fault));
  return value;
}

std::uint64_t XmlFile::count(const pugi::xml_node& node, std::string_view name) const {
  const std::string_view text = attribute_of(node, name);
  std::int64_t value = 0;
  if (read_integer(text, value) != NumberToken::number || value < 0)
    fail(node, fmt::format("the element '{}' has no whole number from 0 on in its attribute '{}', but {}",
                           node.name(), name, mesh::quoted(text)));
  return static_cast<std::uint64_t>(value);
}

void XmlFile::fail(const pugi::xml_node& node, const std::string& what) const { fail(node, what, mend); }

void XmlFile::fail(const pugi::xml_node& node, const std::string& what, const std::string& remedy) const {
  fail_at(node.offset_debug(), what, remedy);
}

void XmlFile::fail_at(std::ptrdiff_t offset, const std::string& what, const std::string& remedy) const {
  const std::size_t at =
      std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0)), text_.size());
  const std::string_view before = text_.substr(0, at);
  const auto line = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) + 1;
  fail_at_line(file_, line, what, remedy);
}

}  // namespace nanocarbon::mesh
