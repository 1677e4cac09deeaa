// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/formats/lammps_data_assembly.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "nanocarbon/core/error.h"

namespace nanocarbon::molecule {
namespace {

void check(const TextInput& input, LammpsFile& file) {
  const Mat3& m = file.box.vectors;
  const double inside = m.determinant(), size = m.colwise().norm().prod();
  if (!(inside > 1e-9 * size))
    input.fail_at(1, "the header does not give a box with a volume (xlo xhi, ylo yhi, zlo zhi)");
  if (file.atoms.size() != file.atom_count)
    input.fail_at(input.number(), fmt::format("the header says {} atoms, the Atoms section has {}",
                                              file.atom_count, file.atoms.size()));
  if (!file.bonds.empty() && file.bonds.size() != file.bond_count)
    input.fail_at(input.number(), fmt::format("the header says {} bonds, the Bonds section has {}",
                                              file.bond_count, file.bonds.size()));
  const auto by_id = [](const LammpsAtom& a, const LammpsAtom& b) { return a.id < b.id; };
  if (!std::is_sorted(file.atoms.begin(), file.atoms.end(), by_id))
    std::stable_sort(file.atoms.begin(), file.atoms.end(), by_id);
  for (std::size_t i = 1; i < file.atoms.size(); ++i)
    if (file.atoms[i].id == file.atoms[i - 1].id)
      input.fail_at(file.atoms[i].line, fmt::format("the atom ID {} was already used on line {}",
                                                    file.atoms[i].id, file.atoms[i - 1].line));
}

AtomIndex index_of(const TextInput& input, const std::vector<std::int64_t>& ids, std::int64_t id,
                   std::size_t line) {
  const auto found = std::lower_bound(ids.begin(), ids.end(), id);
  if (found == ids.end() || *found != id)
    input.fail_at(line, fmt::format("the bond is with atom ID {}, which is not in the Atoms section", id));
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
std::vector<Bond> bonds_of(const TextInput& input, const LammpsFile& file, const MoleculeFrame& data) {
  std::vector<Bond> bonds;
  bonds.reserve(file.bonds.size());
  for (const LammpsBond& bond : file.bonds) {
    AtomIndex first = index_of(input, data.ids, bond.first, bond.line);
    AtomIndex second = index_of(input, data.ids, bond.second, bond.line);
    if (first == second) input.fail_at(bond.line, fmt::format("atom ID {} is bonded to itself", bond.first));
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

MoleculeFrame assemble(const TextInput& input, LammpsFile file, ReadSettings& settings) {
  check(input, file);
  MoleculeFrame frame;
  const auto elements =
      elements_of_types(input, file.types, file.type_count, file.atoms, settings, frame.warnings);
  frame.molecule.elements.reserve(file.atoms.size());
  frame.molecule.positions.reserve(file.atoms.size());
  frame.ids.reserve(file.atoms.size());
  auto element = elements.begin();
  for (const LammpsAtom& atom : file.atoms) {
    if (element == elements.end() || element->first != atom.type) element = elements.find(atom.type);
    frame.molecule.elements.push_back(element->second);
    const bool moved = atom.image != std::array<std::int32_t, 3>{0, 0, 0};
    frame.molecule.positions.push_back(moved ? Vec3(atom.position + image_shift(file.box, atom.image))
                                             : atom.position);
    frame.ids.push_back(atom.id);
  }
  file.box.periodic =
      settings.periodic ? *settings.periodic : file.boundary.value_or(std::array{true, true, true});
  if (file.box.periodic != std::array<bool, 3>{false, false, false}) frame.molecule.cell = file.box;
  frame.molecule.bonds = bonds_of(input, file, frame);
  return frame;
}

}  // namespace nanocarbon::molecule
