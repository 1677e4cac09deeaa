// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/formats/atom_style.h"

#include <array>

namespace nanocarbon::molecule {
namespace {

constexpr std::array<std::string_view, 6> names = {"atomic", "charge", "bond", "angle", "molecular", "full"};

}  // namespace

std::string_view name(AtomStyle style) { return names[static_cast<std::size_t>(style)]; }

std::optional<AtomStyle> atom_style_from_name(std::string_view name) {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == name) return static_cast<AtomStyle>(i);
  return std::nullopt;
}

}  // namespace nanocarbon::molecule
