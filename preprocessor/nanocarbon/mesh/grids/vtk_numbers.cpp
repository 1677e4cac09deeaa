// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/grids/vtk_numbers.h"

#include <array>
#include <cmath>
#include <utility>

namespace nanocarbon::mesh {
namespace {

template <typename Number>
void append(std::vector<double>& to, std::string_view bytes, ByteOrder order) {
  to.reserve(bytes.size() / sizeof(Number));
  for (std::size_t at = 0; at + sizeof(Number) <= bytes.size(); at += sizeof(Number))
    to.push_back(static_cast<double>(load<Number>(bytes.data() + at, order)));
}

}  // namespace

std::optional<VtkType> vtk_type(std::string_view name) {
  using enum VtkType;
  static constexpr std::array<std::pair<std::string_view, VtkType>, 22> names = {
      {{"Int8", int8},       {"UInt8", uint8},           {"Int16", int16},        {"UInt16", uint16},
       {"Int32", int32},     {"UInt32", uint32},         {"Int64", int64},        {"UInt64", uint64},
       {"Float32", float32}, {"Float64", float64},       {"char", int8},          {"unsigned_char", uint8},
       {"short", int16},     {"unsigned_short", uint16}, {"int", int32},          {"unsigned_int", uint32},
       {"long", int64},      {"unsigned_long", uint64},  {"vtktypeint64", int64}, {"vtkIdType", int32},
       {"float", float32},   {"double", float64}}};
  for (const auto& [known, type] : names)
    if (known == name) return type;
  return std::nullopt;
}

std::size_t size_of(VtkType type) {
  static constexpr std::array<std::size_t, 10> sizes = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

std::vector<double> vtk_numbers(std::string_view bytes, VtkType type, ByteOrder order) {
  std::vector<double> numbers;
  switch (type) {
    case VtkType::int8:
      append<std::int8_t>(numbers, bytes, order);
      break;
    case VtkType::uint8:
      append<std::uint8_t>(numbers, bytes, order);
      break;
    case VtkType::int16:
      append<std::int16_t>(numbers, bytes, order);
      break;
    case VtkType::uint16:
      append<std::uint16_t>(numbers, bytes, order);
      break;
    case VtkType::int32:
      append<std::int32_t>(numbers, bytes, order);
      break;
    case VtkType::uint32:
      append<std::uint32_t>(numbers, bytes, order);
      break;
    case VtkType::int64:
      append<std::int64_t>(numbers, bytes, order);
      break;
    case VtkType::uint64:
      append<std::uint64_t>(numbers, bytes, order);
      break;
    case VtkType::float32:
      append<float>(numbers, bytes, order);
      break;
    case VtkType::float64:
      append<double>(numbers, bytes, order);
      break;
  }
  return numbers;
}

std::optional<VertexIndex> point_index(double number, std::size_t points) {
  if (!(number >= 0.0 && number < static_cast<double>(points)) || number != std::floor(number))
    return std::nullopt;
  return static_cast<VertexIndex>(number);
}

}  // namespace nanocarbon::mesh
