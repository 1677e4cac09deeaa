// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/formats/type_elements.h"

#include <fmt/format.h>

#include <algorithm>

#include "nanocarbon/core/error.h"

namespace nanocarbon::molecule {
namespace {

bool is_carbon_or_hydrogen(std::optional<AtomicNumber> z) { return z == 6 || z == 1; }

// Programs that know no masses write 1.
bool stands_for_no_mass(double mass, const LammpsTypes& types) {
  return mass == 1.0 && std::none_of(types.begin(), types.end(), [](const auto& type) {
           return type.second.mass && atomic_number_of_mass(*type.second.mass) == 6;
         });
}

std::string described(std::int64_t number, const LammpsType& type) {
  std::string text = fmt::format("atom type {}", number);
  if (!type.label.empty()) text += fmt::format(" '{}'", shown(type.label));
  if (type.mass) text += fmt::format(" (mass {} g/mol)", *type.mass);
  return text;
}

class Elements {
 public:
  Elements(const TextInput& input, const LammpsTypes& types, std::size_t count, ReadSettings& settings,
           std::vector<std::string>& warnings)
      : input_(input), types_(types), count_(count), settings_(settings), warnings_(warnings) {}

  Element of(std::int64_t number, std::uint32_t line) {
    const auto found = types_.find(number);
    const LammpsType type = found == types_.end() ? LammpsType{} : found->second;
    const std::string where = fmt::format("{}:{}", input_.name(), line), what = described(number, type);
    std::optional<AtomicNumber> by_mass;
    const bool has_mass = type.mass && !stands_for_no_mass(*type.mass, types_);
    if (has_mass) by_mass = atomic_number_of_mass(*type.mass);

    std::optional<AtomicNumber> said = settings_.types.find(fmt::format("{}", number));
    if (!said && !type.label.empty()) said = settings_.types.find(type.label);
    if (said) {
      if (by_mass && by_mass != said)
        warnings_.push_back(fmt::format("{} has the mass of {}, but --types says {}", what,
                                        element_name(*by_mass), element_name(*said)));
      return carbon_or_hydrogen(*said, where, what + " (by --types)");
    }
    const auto by_label = atomic_number_of_label(type.label),
               by_comment = atomic_number_of_label(type.comment);
    for (const auto by_name : {by_label, by_comment})
      if (is_carbon_or_hydrogen(by_mass) && is_carbon_or_hydrogen(by_name) && by_mass != by_name)
        refuse(where, fmt::format("{} has the mass of {}, but is called {}", what, element_name(*by_mass),
                                  element_name(*by_name)));
    // A bead of a coarse model may be called C1; its mass tells that it is no atom.
    if (has_mass && !by_mass) refuse(where, fmt::format("{} has a mass that no element has", what));
    for (const auto z : {by_mass, by_label, by_comment})
      if (z) return carbon_or_hydrogen(*z, where, what);
    refuse(where, fmt::format("nothing in the file says what {} is (no mass, label or name)", what));
  }

 private:
  [[noreturn]] void refuse(const std::string& where, const std::string& problem) const {
    throw UserError(
        Failure::unsuitable,
        fmt::format(
            "{}: {}: give the elements of the file's {} types with --types, as in --types{} or --types 1=C",
            where, problem, count_, suggestion()));
  }
  std::string suggestion() const {
    std::string words;
    for (std::size_t k = 0; k < std::min<std::size_t>(count_, 4); ++k) words += " C";
    return count_ > 4 ? words + " ..." : words;
  }

  const TextInput& input_;
  const LammpsTypes& types_;
  std::size_t count_;
  ReadSettings& settings_;
  std::vector<std::string>& warnings_;
};

}  // namespace

std::map<std::int64_t, Element> elements_of_types(const TextInput& input, const LammpsTypes& types,
                                                  std::size_t count, const std::vector<LammpsAtom>& atoms,
                                                  ReadSettings& settings,
                                                  std::vector<std::string>& warnings) {
  if (settings.types.in_order().value_or(0) > count)
    throw UserError(Failure::usage, fmt::format("--types gives {} types, but {} has {}",
                                                *settings.types.in_order(), input.name(), count));
  Elements elements(input, types, count, settings, warnings);
  std::map<std::int64_t, Element> result;
  std::int64_t last = 0;
  for (const LammpsAtom& atom : atoms) {
    if (atom.type == last) continue;
    last = atom.type;
    if (!result.contains(last)) result.emplace(last, elements.of(last, atom.line));
  }
  return result;
}

}  // namespace nanocarbon::molecule
