// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/formats/lammps_data_assembly.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "nanocarbon/core/error.h"

namespace nanocarbon::molecule {
namespace {

std::optional<Element> element_by_mass(double given) {
  for (const Element element : {Element::carbon, Element::hydrogen})
    if (std::abs(given - mass(element)) < 0.1) return element;
  return std::nullopt;
}

// The element of a type, by its number.
Element element_of_type(const TextInput& input, const LammpsFile& file, const LammpsReadOptions& options,
                        const std::string& type, std::size_t line) {
  const std::size_t index = type.find_first_not_of("0123456789") == std::string::npos && type.size() < 9
                                ? static_cast<std::size_t>(std::stoul("0" + type))
                                : 0;
  if (index == 0 || (file.type_count > 0 && index > file.type_count))
    input.fail_at(line, fmt::format("'{}' is not one of the file's {} atom types", type.substr(0, 40),
                                    file.type_count));
  if (index <= options.type_elements.size() && options.type_elements[index - 1])
    return *options.type_elements[index - 1];
  const auto known = file.types.find(type);
  if (known != file.types.end()) {
    if (known->second.element) return *known->second.element;
    if (known->second.mass)
      if (const auto element = element_by_mass(*known->second.mass)) return *element;
  }
  if (file.types.empty() && index <= 2) return index == 1 ? Element::carbon : Element::hydrogen;
  throw UserError(
      Failure::unsuitable,
      fmt::format("the atom on line {} is of type {}, which is neither carbon nor hydrogen by label or "
                  "mass{}; REBO2 knows only these",
                  line, index,
                  known != file.types.end() && known->second.mass
                      ? fmt::format(" ({} g/mol)", *known->second.mass)
                      : ""));
}

std::vector<Element> elements_of(const TextInput& input, const LammpsFile& file,
                                 const LammpsReadOptions& options) {
  std::vector<Element> elements;
  elements.reserve(file.atoms.size());
  std::map<std::string_view, Element> known;
  for (const LammpsAtom& atom : file.atoms) {
    auto found = known.find(atom.type);
    if (found == known.end()) {
      const auto label = file.type_of_label.find(std::string(atom.type));
      const std::string type = label != file.type_of_label.end() ? label->second : std::string(atom.type);
      found = known.emplace(atom.type, element_of_type(input, file, options, type, atom.line)).first;
    }
    elements.push_back(found->second);
  }
  return elements;
}

void check(const TextInput& input, LammpsFile& file) {
  const Mat3& m = file.box.vectors;
  const double inside = m.determinant(), size = m.colwise().norm().prod();
  if (!(inside > 1e-9 * size))
    input.fail_at(1, "the header does not give a box with a volume (xlo xhi, ylo yhi, zlo zhi)");
  if (file.atoms.size() != file.atom_count)
    input.fail(fmt::format("the header says {} atoms, the Atoms section has {}", file.atom_count,
                           file.atoms.size()));
  if (!file.bonds.empty() && file.bonds.size() != file.bond_count)
    input.fail(fmt::format("the header says {} bonds, the Bonds section has {}", file.bond_count,
                           file.bonds.size()));
  const auto by_id = [](const LammpsAtom& a, const LammpsAtom& b) { return a.id < b.id; };
  if (!std::is_sorted(file.atoms.begin(), file.atoms.end(), by_id))
    std::stable_sort(file.atoms.begin(), file.atoms.end(), by_id);
  for (std::size_t i = 1; i < file.atoms.size(); ++i)
    if (file.atoms[i].id == file.atoms[i - 1].id)
      input.fail_at(file.atoms[i].line, fmt::format("the atom-ID {} was already used on line {}",
                                                    file.atoms[i].id, file.atoms[i - 1].line));
}

AtomIndex index_of(const TextInput& input, const std::vector<std::int64_t>& ids, std::int64_t id,
                   std::size_t line) {
  const auto found = std::lower_bound(ids.begin(), ids.end(), id);
  if (found == ids.end() || *found != id)
    input.fail_at(line, fmt::format("the bond is with atom-ID {}, which is not in the Atoms section", id));
  return static_cast<AtomIndex>(found - ids.begin());
}

// The images of an atom that are nearest to another, nearest first: as many as asked for.
std::vector<std::array<std::int32_t, 3>> nearest_images(const Cell& cell, const Vec3& from, const Vec3& to,
                                                        std::size_t count) {
  const Vec3 fraction = cell.vectors.inverse() * (to - from);
  std::array<std::int32_t, 3> middle = {0, 0, 0}, reach = {0, 0, 0};
  for (std::size_t d = 0; d < 3; ++d)
    if (cell.periodic[d]) {
      middle[d] = -static_cast<std::int32_t>(std::lround(fraction[static_cast<int>(d)]));
      reach[d] = 2;
    }
  struct Image {
    double distance;
    std::array<std::int32_t, 3> image;
  };
  std::vector<Image> images;
  for (std::int32_t a = -reach[0]; a <= reach[0]; ++a)
    for (std::int32_t b = -reach[1]; b <= reach[1]; ++b)
      for (std::int32_t c = -reach[2]; c <= reach[2]; ++c) {
        const std::array<std::int32_t, 3> image = {middle[0] + a, middle[1] + b, middle[2] + c};
        images.push_back({(to - from + image_shift(cell, image)).norm(), image});
      }
  std::sort(images.begin(), images.end(), [](const Image& a, const Image& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.image < b.image;
  });
  std::vector<std::array<std::int32_t, 3>> nearest;
  for (std::size_t k = 0; k < std::min(count, images.size()); ++k) nearest.push_back(images[k].image);
  return nearest;
}

// Bonds of a pair that the file lists several times go to different images. Without a cell they are one bond.
std::vector<Bond> bonds_of(const TextInput& input, const LammpsFile& file, const LammpsData& data) {
  std::vector<Bond> bonds;
  bonds.reserve(file.bonds.size());
  for (const LammpsBond& bond : file.bonds) {
    AtomIndex first = index_of(input, data.ids, bond.first, bond.line);
    AtomIndex second = index_of(input, data.ids, bond.second, bond.line);
    if (first == second) input.fail_at(bond.line, fmt::format("atom-ID {} is bonded to itself", bond.first));
    if (first > second) std::swap(first, second);
    bonds.push_back({first, second, {0, 0, 0}});
  }
  std::sort(bonds.begin(), bonds.end());
  if (!data.molecule.cell) {
    bonds.erase(std::unique(bonds.begin(), bonds.end()), bonds.end());
    return bonds;
  }
  const std::vector<Vec3>& positions = data.molecule.positions;
  const double certain = 0.4 * face_distances(*data.molecule.cell).minCoeff();
  for (auto i = bonds.begin(); i != bonds.end();) {
    const auto end = std::upper_bound(i, bonds.end(), *i);
    const Vec3 &from = positions[i->first], &to = positions[i->second];
    if (end - i > 1 || (to - from).norm() >= certain) {
      const auto images = nearest_images(*data.molecule.cell, from, to, static_cast<std::size_t>(end - i));
      for (std::size_t k = 0; k < images.size(); ++k) (i + static_cast<long>(k))->image = images[k];
      std::sort(i, end);
    }
    i = end;
  }
  bonds.erase(std::unique(bonds.begin(), bonds.end()), bonds.end());
  return bonds;
}

}  // namespace

LammpsData assemble(const TextInput& input, LammpsFile file, const LammpsReadOptions& options) {
  check(input, file);
  LammpsData data;
  data.atom_style = file.atom_style;
  data.molecule.elements = elements_of(input, file, options);
  data.molecule.positions.reserve(file.atoms.size());
  data.ids.reserve(file.atoms.size());
  for (const LammpsAtom& atom : file.atoms) {
    const bool moved = atom.image != std::array<std::int32_t, 3>{0, 0, 0};
    data.molecule.positions.push_back(moved ? Vec3(atom.position + image_shift(file.box, atom.image))
                                            : atom.position);
    data.ids.push_back(atom.id);
  }
  file.box.periodic =
      options.periodic ? *options.periodic : file.boundary.value_or(std::array{true, true, true});
  if (file.box.periodic != std::array<bool, 3>{false, false, false}) data.molecule.cell = file.box;
  data.molecule.bonds = bonds_of(input, file, data);
  return data;
}

}  // namespace nanocarbon::molecule
