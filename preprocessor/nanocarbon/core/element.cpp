// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/core/element.h"

namespace nanocarbon {

std::string_view symbol(Element element) { return element == Element::carbon ? "C" : "H"; }

double mass(Element element) { return element == Element::carbon ? 12.011 : 1.008; }

std::optional<Element> element_from_symbol(std::string_view symbol) {
  if (symbol == "C") return Element::carbon;
  if (symbol == "H") return Element::hydrogen;
  return std::nullopt;
}

}  // namespace nanocarbon
