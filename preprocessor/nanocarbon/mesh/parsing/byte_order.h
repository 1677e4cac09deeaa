// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace nanocarbon::mesh {

enum class ByteOrder { little, big };

constexpr bool is_native(ByteOrder order) {
  return (order == ByteOrder::little) == (std::endian::native == std::endian::little);
}

//! The number that begins at an address of any alignment.
template <typename Number>
Number load(const char* at, ByteOrder order) {
  std::array<char, sizeof(Number)> bytes;
  std::memcpy(bytes.data(), at, bytes.size());
  if (!is_native(order)) std::reverse(bytes.begin(), bytes.end());
  return std::bit_cast<Number>(bytes);
}

//! The bytes of a number in the given order.
template <typename Number>
std::array<char, sizeof(Number)> bytes_of(Number number, ByteOrder order) {
  auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  if (!is_native(order)) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

}  // namespace nanocarbon::mesh
