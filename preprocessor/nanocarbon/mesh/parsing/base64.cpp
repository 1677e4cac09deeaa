// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/parsing/base64.h"

#include <cstdint>

namespace nanocarbon::mesh {
namespace {

// Six bits, or -1 for what is no digit.
int digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+' || c == '-') return 62;
  if (c == '/' || c == '_') return 63;
  return -1;
}

}  // namespace

std::optional<std::string> from_base64(std::string_view text) {
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t bits = 0;
  int digits = 0, padding = 0;
  const auto flush = [&] {
    for (int byte = 0; byte < digits - 1; ++byte)
      bytes.push_back(static_cast<char>(bits << 6 * (4 - digits) >> (16 - 8 * byte) & 0xff));
    bits = 0;
    digits = padding = 0;
  };
  for (const char c : text) {
    if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
    if (c == '=') {
      if (digits < 2) return std::nullopt;
      if (++padding + digits == 4) flush();
      continue;
    }
    const int value = digit(c);
    if (value < 0 || padding > 0) return std::nullopt;
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    if (++digits == 4) flush();
  }
  if (padding > 0 || digits == 1) return std::nullopt;
  flush();
  return bytes;
}

}  // namespace nanocarbon::mesh
