// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/formats/species.h"

#include <fmt/format.h>

#include <algorithm>

#include "nanocarbon/core/error.h"

namespace nanocarbon::molecule {
namespace {

bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
bool is_number(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}
std::string upper_initial(std::string_view letters) {
  std::string symbol = lower_case(letters);
  symbol[0] = static_cast<char>(symbol[0] - 'a' + 'A');
  return symbol;
}

[[noreturn]] void misused(const std::string& problem) {
  throw UserError(Failure::usage,
                  fmt::format("--types: {}; it takes the elements of types 1, 2, ... (--types C "
                              "H) or of types by name (--types 1=C CA=C)",
                              problem));
}

AtomicNumber said_element(const std::string& word) {
  const std::size_t equals = word.find('=');
  const std::string name = equals == std::string::npos ? word : word.substr(equals + 1);
  if (name.size() == 1 && is_letter(name[0]))
    if (const auto z = atomic_number_of_symbol(upper_initial(name))) return *z;
  const auto z = atomic_number_of_symbol(name);
  if (!z) misused(fmt::format("'{}' does not name an element", shown(word)));
  return *z;
}

// C2H6, H2O: united atoms and beads. C1A and C12B are labels of crystals.
bool is_formula(std::string_view name) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  if (name == "H2O") return true;
  std::size_t i = 1;
  while (i < name.size() && is_digit(name[i])) ++i;
  return name[0] == 'C' && i > 1 && i + 1 < name.size() && name[i] == 'H' && is_digit(name[i + 1]);
}

// What a name could stand for, for the message that refuses it.
std::string why_doubtful(std::string_view name) {
  if (!name.empty() && is_formula(name)) return "could be a group of atoms";
  if (is_number(name)) return "is a number, which could be a type or an element";
  if (name.size() >= 2 && is_letter(name[0]) && is_letter(name[1])) {
    const auto two = atomic_number_of_symbol(upper_initial(name.substr(0, 2)));
    if (two && (name.size() == 2 || !is_letter(name[2])))
      return fmt::format("could be {} or an arbitrary name", element_name(*two));
  }
  return "names no element";
}

}  // namespace

std::optional<AtomicNumber> atomic_number_of_label(std::string_view label) {
  const auto end = std::find_if_not(label.begin(), label.end(), is_letter);
  const std::string_view letters = label.substr(0, static_cast<std::size_t>(end - label.begin()));
  if (letters.empty() || is_formula(label)) return std::nullopt;
  if (letters.size() == 1) {
    if (label == "D") return AtomicNumber{1};  // deuterium
    return atomic_number_of_symbol(upper_initial(letters));
  }
  if (letters.size() == 2) return atomic_number_of_symbol(letters);
  return letters.size() == label.size() ? atomic_number_of_name(lower_case(letters)) : std::nullopt;
}

TypeNames::TypeNames(const std::vector<std::string>& words) {
  std::vector<std::string> parts;
  for (const std::string& word : words) {
    std::string separated = word;
    std::replace(separated.begin(), separated.end(), ',', ' ');
    std::vector<std::string_view> found;
    split_words(separated, found);
    parts.insert(parts.end(), found.begin(), found.end());
  }
  const auto named = static_cast<std::size_t>(
      std::count_if(parts.begin(), parts.end(), [](const std::string& p) { return p.find('=') != p.npos; }));
  if (named != 0 && named != parts.size()) misused("some types have names and some do not");
  if (named == 0 && !parts.empty()) in_order_ = parts.size();
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const std::string name = in_order_ ? fmt::format("{}", k + 1) : parts[k].substr(0, parts[k].find('='));
    if (name.empty()) misused(fmt::format("'{}' does not name a type", shown(parts[k])));
    if (!elements_.emplace(name, Said{said_element(parts[k]), false}).second)
      misused(fmt::format("type {} is named twice", shown(name)));
  }
}

std::optional<AtomicNumber> TypeNames::find(std::string_view type) {
  const auto found = elements_.find(type);
  if (found == elements_.end()) return std::nullopt;
  found->second.used = true;
  return found->second.element;
}

std::vector<std::string> TypeNames::unused() const {
  std::vector<std::string> types;
  for (const auto& [name, said] : elements_)
    if (!said.used) types.push_back(name);
  return types;
}

Element SpeciesReader::of_name(const TextInput& input, std::string_view name) {
  if (name == last_ && !last_.empty()) return last_element_;
  auto known = known_.find(name);
  if (known == known_.end()) known = known_.emplace(name, look_up(input, name)).first;
  last_ = name;
  return last_element_ = known->second;
}

Element SpeciesReader::look_up(const TextInput& input, std::string_view name) {
  // CIF is not read by lines.
  const std::string where =
      input.number() == 0 ? input.name() : fmt::format("{}:{}", input.name(), input.number());
  const std::string quoted = shown(name);
  const std::string line =
      input.number() == 0 ? "" : fmt::format("; the line is \"{}\"", shown(trimmed(input.line())));
  if (const auto said = types_.find(name))
    return carbon_or_hydrogen(*said, where, fmt::format("'{}' (by --types)", quoted));
  const auto z = is_number(name) ? std::nullopt : atomic_number_of_label(name);
  if (!z)
    throw UserError(Failure::unsuitable,
                    fmt::format("{}: the atom's name '{}' {}: say what it is with "
                                "--types {}=C or --types {}=H{}",
                                where, quoted, why_doubtful(name), quoted, quoted, line));
  return carbon_or_hydrogen(*z, where, fmt::format("'{}'", quoted));
}

Element SpeciesReader::of_atomic_number(const TextInput& input, std::string_view number) {
  const std::int64_t z = input.integer(number, "an atomic number");
  if (z < 1 || z > 118) input.fail(fmt::format("there is no element with the atomic number {}", z));
  return carbon_or_hydrogen(static_cast<AtomicNumber>(z), fmt::format("{}:{}", input.name(), input.number()),
                            fmt::format("the atom with the atomic number {}", z));
}

Element carbon_or_hydrogen(AtomicNumber z, const std::string& where, const std::string& what) {
  if (z == 6) return Element::carbon;
  if (z == 1) return Element::hydrogen;
  throw UserError(Failure::unsuitable,
                  fmt::format("{}: {} is {} ({}); the potentials here are for carbon and hydrogen only",
                              where, what, element_name(z), element_symbol(z)));
}

}  // namespace nanocarbon::molecule
