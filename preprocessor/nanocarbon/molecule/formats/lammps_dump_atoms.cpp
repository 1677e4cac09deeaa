// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/formats/lammps_dump_atoms.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "nanocarbon/core/error.h"

namespace nanocarbon::molecule {
namespace {

using Words = std::span<const std::string_view>;
using Column = std::optional<std::size_t>;

struct Columns {
  std::size_t count = 0;
  Column id, type, element, mass;
  std::size_t position[3] = {};
  bool scaled = false;
  Column image[3];
};

Columns parse_columns(const TextInput& input, Words names) {
  const auto column = [&](std::string_view name) -> Column {
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? Column() : Column(static_cast<std::size_t>(found - names.begin()));
  };
  Columns columns;
  columns.count = names.size();
  columns.id = column("id");
  columns.type = column("type");
  columns.element = column("element") ? column("element") : column("typelabel");
  columns.mass = column("mass");
  for (const std::string_view suffix : {"u", "", "su", "s"}) {
    Column found[3];
    for (std::size_t d = 0; d < 3; ++d) found[d] = column(std::string{"xyz"[d]} + std::string(suffix));
    if (!found[0] || !found[1] || !found[2]) continue;
    for (std::size_t d = 0; d < 3; ++d) {
      columns.position[d] = *found[d];
      if (!suffix.ends_with("u")) columns.image[d] = column(std::string{'i', "xyz"[d]});
    }
    columns.scaled = suffix.starts_with("s");
    if (!columns.image[0] || !columns.image[1] || !columns.image[2])
      for (Column& image : columns.image) image.reset();
    return columns;
  }
  input.fail("no columns hold positions (x y z, xu yu zu, xs ys zs or xsu ysu zsu)");
}

// The element of the atom on the current line, each type, name or mass worked out once.
class ElementColumn {
 public:
  ElementColumn(const TextInput& input, const Columns& columns, ReadSettings& settings)
      : columns_(columns), types_(settings.types), species_(settings.types) {
    if (!columns.element && !columns.mass && !columns.type)
      nothing_says(input, "write the dump again with a column element or type");
  }

  Element of(const TextInput& input, Words words) {
    if (columns_.type && !types_.empty())
      if (const auto said = said_of(input, words[*columns_.type])) return *said;
    if (columns_.element) {
      const std::string_view name = words[*columns_.element];
      if (columns_.type) note(words[*columns_.type], name);
      return species_.of_name(input, name);
    }
    if (columns_.mass) return of_mass(input, words[*columns_.mass]);
    const std::string_view type = words[*columns_.type];
    std::int64_t number = 0;
    if (!parse_integer(type, number)) return species_.of_name(input, type);  // dump_modify types labels
    if (types_.empty())
      nothing_says(input, "give the elements of the types, as in --types C (of type 1) or --types C H");
    throw UserError(Failure::unsuitable, fmt::format("{}:{}: --types does not say what type {} is",
                                                     input.name(), input.number(), shown(type)));
  }

  // LAMMPS calls every type C unless dump_modify element says otherwise.
  std::string doubt() const {
    if (name_of_type_.size() < 2) return {};
    for (const auto& [type, name] : name_of_type_)
      if (name != "C") return {};
    return fmt::format(
        "all {} atom types are called C, which is LAMMPS's default without dump_modify element; if some are "
        "not carbon, say so with --types",
        name_of_type_.size());
  }

 private:
  [[noreturn]] static void nothing_says(const TextInput& input, std::string_view remedy) {
    throw UserError(Failure::unsuitable,
                    fmt::format("{}:{}: no column says what the atoms are (element or mass): {}",
                                input.name(), input.number(), remedy));
  }

  void note(std::string_view type, std::string_view name) {
    if (type == noted_) return;
    noted_ = type;
    name_of_type_.try_emplace(noted_, name);
  }

  std::optional<Element> said_of(const TextInput& input, std::string_view type) {
    auto known = known_types_.find(type);
    if (known == known_types_.end()) {
      std::optional<Element> element;
      if (const auto z = types_.find(type))
        element = carbon_or_hydrogen(*z, fmt::format("{}:{}", input.name(), input.number()),
                                     fmt::format("atom type {} (by --types)", shown(type)));
      known = known_types_.emplace(type, element).first;
    }
    return known->second;
  }

  Element of_mass(const TextInput& input, std::string_view word) {
    auto known = known_masses_.find(word);
    if (known == known_masses_.end()) {
      const std::string where = fmt::format("{}:{}", input.name(), input.number());
      const auto z = atomic_number_of_mass(input.real(word, "a mass"));
      if (!z || word == "1")
        throw UserError(
            Failure::unsuitable,
            fmt::format(
                "{}: no element has a mass of {} g/mol: give the elements of the types, as in --types C H",
                where, shown(word)));
      known =
          known_masses_
              .emplace(word, carbon_or_hydrogen(*z, where, fmt::format("an atom of mass {}", shown(word))))
              .first;
    }
    return known->second;
  }

  const Columns& columns_;
  TypeNames& types_;
  SpeciesReader species_;
  std::map<std::string, std::optional<Element>, std::less<>> known_types_;
  std::map<std::string, Element, std::less<>> known_masses_;
  std::map<std::string, std::string> name_of_type_;
  std::string noted_;
};

}  // namespace

void take_boundary(const TextInput& input, Words letters, DumpBox& box) {
  if (letters.size() != 3) input.fail("expected a boundary each way, such as pp pp ff");
  box.says_boundary = true;
  for (std::size_t d = 0; d < 3; ++d) {
    if (letters[d].find_first_not_of("pfsm") != std::string_view::npos)
      input.fail(fmt::format("'{}' is not a LAMMPS boundary (pp, ff, ss, ...)", shown(letters[d])));
    box.cell.periodic[d] = letters[d] == "pp" || letters[d] == "p";
  }
}

void take_bounds(const TextInput& input, const double (&bounds)[3][2], const Vec3& tilts, DumpBox& box) {
  const double xy = tilts[0], xz = tilts[1], yz = tilts[2];
  const double low[] = {bounds[0][0] - std::min({0.0, xy, xz, xy + xz}), bounds[1][0] - std::min(0.0, yz),
                        bounds[2][0]};
  const double high[] = {bounds[0][1] - std::max({0.0, xy, xz, xy + xz}), bounds[1][1] - std::max(0.0, yz),
                         bounds[2][1]};
  Mat3& m = box.cell.vectors;
  m.setZero();
  for (int d = 0; d < 3; ++d) {
    if (!(high[d] > low[d]))
      input.fail(fmt::format("the box has no extent along {}: {} to {}", "xyz"[d], low[d], high[d]));
    box.cell.origin[d] = low[d];
    m(d, d) = high[d] - low[d];
  }
  m(0, 1) = xy;
  m(0, 2) = xz;
  m(1, 2) = yz;
}

struct DumpAtoms::Parts {
  Parts(const TextInput& input, Words names, std::size_t count, const DumpBox& box, ReadSettings& settings,
        MoleculeFrame& into)
      : frame(into),
        vectors(box.cell.vectors),
        origin(box.cell.origin),
        columns(parse_columns(input, names)),
        elements(input, columns, settings),
        atoms(count) {}

  MoleculeFrame& frame;
  Mat3 vectors;
  Vec3 origin;
  Columns columns;
  ElementColumn elements;
  std::size_t atoms;
};

DumpAtoms::DumpAtoms(const TextInput& input, Words names, std::size_t atoms, const DumpBox& box,
                     ReadSettings& settings, MoleculeFrame& frame)
    : parts_(std::make_unique<Parts>(input, names, atoms, box, settings, frame)) {
  frame.molecule.cell = cell_as_read(input, box.cell, settings);
  frame.has_ids = parts_->columns.id.has_value();
  if (!box.says_boundary && !settings.periodic)
    frame.warnings.push_back(
        "the dump does not say which directions are periodic; all are taken to be (if not, give them, as in "
        "--boundary 'p p f')");
  frame.molecule.positions.reserve(room_for(atoms));
  frame.molecule.elements.reserve(room_for(atoms));
  frame.ids.reserve(room_for(atoms));
}

DumpAtoms::~DumpAtoms() = default;

void DumpAtoms::add(const TextInput& input, Words words) {
  MoleculeFrame& frame = parts_->frame;
  const Columns& columns = parts_->columns;
  const std::size_t i = frame.molecule.size();
  if (words.size() != columns.count)
    input.fail(fmt::format("expected {} columns for atom {} of {}, found {}", columns.count, i + 1,
                           parts_->atoms, words.size()));
  Vec3 position;
  for (std::size_t d = 0; d < 3; ++d)
    position[static_cast<int>(d)] = input.coordinate(words[columns.position[d]], "a coordinate");
  if (columns.scaled) position = parts_->origin + parts_->vectors * position;
  for (std::size_t d = 0; d < 3; ++d) {
    if (!columns.image[d]) continue;
    const std::int64_t image = input.integer(words[*columns.image[d]], "an image flag");
    if (image < -1000000 || image > 1000000)
      input.fail(fmt::format("the image flag {} is out of bounds", image));
    if (image != 0) position += static_cast<double>(image) * parts_->vectors.col(static_cast<int>(d));
  }
  frame.molecule.elements.push_back(parts_->elements.of(input, words));
  frame.molecule.positions.push_back(position);
  frame.ids.push_back(columns.id ? input.integer(words[*columns.id], "an atom-ID")
                                 : static_cast<std::int64_t>(i) + 1);
}

void DumpAtoms::finish(const TextInput& input) {
  if (const auto twice = sort_by_id(parts_->frame))
    input.fail_at(input.number(),
                  fmt::format("of the atoms that end on this line, more than one has the ID {}", *twice));
  if (const std::string doubt = parts_->elements.doubt(); !doubt.empty())
    parts_->frame.warnings.push_back(doubt);
}

}  // namespace nanocarbon::molecule
