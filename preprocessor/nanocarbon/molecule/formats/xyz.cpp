// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <string_view>
#include <vector>

#include "nanocarbon/core/output_file.h"
#include "nanocarbon/molecule/formats/text_output.h"
#include "nanocarbon/molecule/formats/xyz.h"

namespace nanocarbon::molecule {
namespace {

std::string_view flag(bool periodic) { return periodic ? "T" : "F"; }

// Quotes and line ends cannot be part of a quoted value that every reader understands.
std::string as_value(std::string text) {
  for (char& c : text)
    if (c == '"' || c == '\n' || c == '\r') c = ' ';
  return text;
}

//! The atoms bonded to each, by ID from 1: a row of `width` columns for each atom, 0 where there are no more.
struct BondedAtoms {
  std::size_t width = 0;  // none without bonds
  std::vector<std::size_t> ids;
};

BondedAtoms bonded_atoms(const Molecule& molecule) {
  std::vector<std::size_t> count(molecule.size(), 0);
  for (const Bond& bond : molecule.bonds) ++count[bond.first], ++count[bond.second];
  BondedAtoms bonded;
  if (!molecule.bonds.empty()) bonded.width = *std::max_element(count.begin(), count.end());
  bonded.ids.assign(bonded.width * molecule.size(), 0);
  std::fill(count.begin(), count.end(), 0);
  const auto add = [&](AtomIndex atom, AtomIndex other) {
    bonded.ids[bonded.width * atom + count[atom]++] = std::size_t{other} + 1;
  };
  for (const Bond& bond : molecule.bonds) {
    add(bond.first, bond.second);
    add(bond.second, bond.first);
  }
  return bonded;
}

}  // namespace

void write_xyz(std::ostream& out, const Molecule& molecule, const std::string& generator) {
  TextOutput text(out);
  text.print("{}\n", molecule.size());
  std::array<bool, 3> periodic = {false, false, false};
  if (molecule.cell) {
    periodic = molecule.cell->periodic;
    const Mat3& m = molecule.cell->vectors;
    text.print("Lattice=\"{} {} {} {} {} {} {} {} {}\" ", m(0, 0), m(1, 0), m(2, 0), m(0, 1), m(1, 1),
               m(2, 1), m(0, 2), m(1, 2), m(2, 2));
    const Vec3& o = molecule.cell->origin;
    if (!o.isZero(0.0)) text.print("Origin=\"{} {} {}\" ", o[0], o[1], o[2]);
  }
  const BondedAtoms bonded = bonded_atoms(molecule);
  text.print("Properties=species:S:1:pos:R:3");
  if (bonded.width > 0) text.print(":bonded:I:{}", bonded.width);
  text.print(" pbc=\"{} {} {}\"", flag(periodic[0]), flag(periodic[1]), flag(periodic[2]));
  if (!generator.empty()) text.print(" generator=\"{}\"", as_value(generator));
  text.print("\n");
  for (std::size_t i = 0; i < molecule.size(); ++i) {
    const Vec3& p = molecule.positions[i];
    text.print("{} {} {} {}", symbol(molecule.elements[i]), p[0], p[1], p[2]);
    for (std::size_t b = 0; b < bonded.width; ++b) text.print(" {}", bonded.ids[bonded.width * i + b]);
    text.print("\n");
  }
  text.flush();
}

void write_xyz(const std::filesystem::path& path, const Molecule& molecule, const std::string& generator) {
  write_file(path, [&](std::ostream& out) { write_xyz(out, molecule, generator); });
}

}  // namespace nanocarbon::molecule
