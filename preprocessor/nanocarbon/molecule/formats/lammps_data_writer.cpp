// SPDX-License-Identifier: GPL-2.0-or-later
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "nanocarbon/core/error.h"
#include "nanocarbon/core/output_file.h"
#include "nanocarbon/molecule/formats/lammps_box.h"
#include "nanocarbon/molecule/formats/lammps_data.h"
#include "nanocarbon/molecule/formats/text_output.h"
#include "nanocarbon/topology/connected_components.h"

namespace nanocarbon::molecule {
namespace {

int type_of(Element element) { return element == Element::carbon ? 1 : 2; }

void check_finite(const Molecule& molecule) {
  for (std::size_t i = 0; i < molecule.size(); ++i)
    if (!molecule.positions[i].allFinite())
      throw UserError(Failure::unsuitable,
                      fmt::format("atom {} is not at finite coordinates, so the molecule "
                                  "cannot be written as a LAMMPS data file",
                                  i + 1));
}

std::string single_line(std::string text) {
  for (char& c : text)
    if (c == '\n' || c == '\r') c = ' ';
  return text;
}

// LAMMPS knows no bond of an atom with its own image.
bool is_written(const Bond& bond) { return bond.first != bond.second; }

void print_header(TextOutput& text, const Molecule& molecule, const LammpsDataOptions& options,
                  const LammpsBox& box) {
  const auto boundary = [&](int d) { return box.cell.periodic[d] ? 'p' : 'f'; };
  text.print("# {}\n\n", options.comment.empty() ? "LAMMPS data file" : single_line(options.comment));
  text.print("# units metal\n# atom_style {}\n# boundary {} {} {}\n", name(options.atom_style), boundary(0),
             boundary(1), boundary(2));
  if (has_bonds(options.atom_style))
    text.print("# special_bonds lj/coul 1 1 1   (REBO needs bonded neighbours)\n");
  text.print("\n{} atoms\n2 atom types\n", molecule.size());
  if (has_bonds(options.atom_style))
    text.print("{} bonds\n1 bond types\n",
               std::count_if(molecule.bonds.begin(), molecule.bonds.end(), is_written));
  const Mat3& m = box.cell.vectors;
  const Vec3& low = box.cell.origin;
  const char axes[] = {'x', 'y', 'z'};
  text.print("\n");
  for (int d = 0; d < 3; ++d) text.print("{} {} {}lo {}hi\n", low[d], low[d] + m(d, d), axes[d], axes[d]);
  if (box.triclinic()) text.print("{} {} {} xy xz yz\n", m(0, 1), m(0, 2), m(1, 2));
  text.print("\nMasses\n\n");
  for (const Element element : {Element::carbon, Element::hydrogen})
    text.print("{} {}  # {}\n", type_of(element), mass(element), symbol(element));
}

void print_atoms(TextOutput& text, const Molecule& molecule, AtomStyle style, const LammpsBox& box) {
  const bool periodic = box.cell.periodic != std::array<bool, 3>{false, false, false};
  const bool turned = !box.rotation.isIdentity(0.0);
  const Mat3 to_fractional = box.cell.vectors.inverse();
  const topology::Components components =
      has_molecule_id(style) ? topology::connected_components(molecule.size(), molecule.bonds)
                             : topology::Components{};
  text.print("\nAtoms # {}\n\n", name(style));
  for (std::size_t i = 0; i < molecule.size(); ++i) {
    text.print("{} ", i + 1);
    if (has_molecule_id(style)) text.print("{} ", components.of_atom[i] + 1);
    text.print("{} ", type_of(molecule.elements[i]));
    if (has_charge(style)) text.print("0 ");
    Vec3 p = turned ? Vec3(box.rotation * molecule.positions[i]) : molecule.positions[i];
    if (!periodic) {
      text.print("{} {} {}\n", p[0], p[1], p[2]);
      continue;
    }
    const Vec3 f = to_fractional * (p - box.cell.origin);
    std::array<int, 3> image = {0, 0, 0};
    for (int d = 0; d < 3; ++d)
      if (box.cell.periodic[d]) image[d] = static_cast<int>(std::floor(f[d]));
    if (image != std::array<int, 3>{0, 0, 0}) p -= image_shift(box.cell, image);
    text.print("{} {} {} {} {} {}\n", p[0], p[1], p[2], image[0], image[1], image[2]);
  }
}

void print_bonds(TextOutput& text, const Molecule& molecule) {
  std::size_t id = 0;
  for (const Bond& bond : molecule.bonds) {
    if (!is_written(bond)) continue;
    if (id == 0) text.print("\nBonds\n\n");
    text.print("{} 1 {} {}\n", ++id, bond.first + 1, bond.second + 1);
  }
}

}  // namespace

void write_lammps_data(std::ostream& out, const Molecule& molecule, const LammpsDataOptions& options) {
  check_finite(molecule);
  const LammpsBox box = lammps_box(molecule, options.margin);
  TextOutput text(out);
  print_header(text, molecule, options, box);
  print_atoms(text, molecule, options.atom_style, box);
  if (has_bonds(options.atom_style)) print_bonds(text, molecule);
  text.flush();
}

void write_lammps_data(const std::filesystem::path& path, const Molecule& molecule,
                       const LammpsDataOptions& options) {
  write_file(path, [&](std::ostream& out) { write_lammps_data(out, molecule, options); });
}

}  // namespace nanocarbon::molecule
