// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/structures/schwarzite_family.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "nanocarbon/core/error.h"
#include "nanocarbon/molecule/dual.h"
#include "nanocarbon/shapes/goldberg_coxeter.h"
#include "nanocarbon/structures/close_bonds.h"
#include "nanocarbon/structures/schwarzite.h"
#include "nanocarbon/structures/spring_relaxation.h"

namespace nanocarbon::structures {
namespace {

constexpr std::size_t most_atoms = 1'000'000;
constexpr double off_symmetry = 0.02;  // Angstrom

//! D688 in the least cell that has two sides.
Molecule d688_of_two_sides() {
  Molecule molecule = schwarzite_d688(1, 1, 1);
  const double edge = molecule.cell->vectors(0, 0);
  for (std::size_t i = 0, half = molecule.size(); i < half; ++i)
    molecule.positions.push_back(molecule.positions[i] + Vec3(edge, 0, 0));
  molecule.elements.assign(molecule.size(), Element::carbon);
  molecule.cell->vectors << 0, edge, edge, edge, 0, edge, edge, edge, 0;
  add_bonds(molecule);
  add_rings(molecule, 8);
  return molecule;
}

struct Family {
  char letter;
  std::size_t atoms;  // of the network that is subdivided
  Molecule (*network)();
};

const Family families[] = {{'p', 48, [] { return schwarzite_p688(1, 1, 1); }},
                           {'d', 48, d688_of_two_sides},
                           {'d', 56, [] { return schwarzite_d56(1, 1, 1); }},
                           {'g', 96, [] { return schwarzite_g688(1, 1, 1); }}};

struct Step {
  int h = 1, k = 0;
};

//! The Goldberg-Coxeter pair of so many triangles for one, if there is any.
std::optional<Step> step_of(std::size_t triangles) {
  const auto wanted = static_cast<long>(triangles);
  for (long h = std::lround(std::floor(std::sqrt(static_cast<double>(triangles)))); h > 0; --h)
    for (long k = 0; k <= h && h * h + h * k + k * k <= wanted; ++k)
      if (h * h + h * k + k * k == wanted) return Step{static_cast<int>(h), static_cast<int>(k)};
  return {};
}

//! The atoms of the members of a surface's families, the first few of each.
std::string sizes(char letter) {
  std::string text;
  for (const Family& family : families) {
    if (family.letter != letter) continue;
    int listed = 0;
    for (std::size_t t = 1; listed < 7; ++t)
      if (step_of(t)) text += fmt::format("{}{}", text.empty() ? "" : ", ", family.atoms * t), ++listed;
    text += ", ...";
  }
  return text;
}

[[noreturn]] void refuse(const std::string& name) {
  constexpr const char* what =
      "a letter for its surface (p, d or g) and the number of atoms in its cell, such as p192, d168 or g384";
  const char letter = name.empty() ? ' ' : name.front();
  std::string known;
  for (const Family& family : families)
    if (family.letter == letter && known.empty())
      known = fmt::format("; {} comes with {} atoms", letter, sizes(letter));
  throw UserError(Failure::usage,
                  fmt::format("'{}' is no schwarzite known here: give {}{}", name, what, known));
}

//! The triangulation whose dual a network of rings is, all of which run the same way round.
TriangleMesh triangulation_of(const Molecule& molecule) {
  struct Corner {
    VertexIndex ring;
    AtomIndex before, after;
  };
  TriangleMesh mesh;
  mesh.space = Space(molecule.cell);
  std::vector<std::vector<Corner>> corners(molecule.size());
  for (std::size_t r = 0; r < molecule.rings.size(); ++r) {
    const auto ring = molecule.rings[r];
    const std::size_t size = ring.size();
    Vec3 at = molecule.positions[ring[0]], sum = Vec3::Zero();
    for (std::size_t i = 0; i < size; ++i) {
      at = mesh.space.beside(molecule.positions[ring[i]], at);
      sum += at;
      corners[ring[i]].push_back(
          {static_cast<VertexIndex>(r), ring[(i + size - 1) % size], ring[(i + 1) % size]});
    }
    mesh.points.push_back(sum / static_cast<double>(size));
  }
  // Counter-clockwise around an atom the next ring begins with the bond that the last one came by.
  for (const std::vector<Corner>& around : corners) {
    const Corner& first = around.at(0);
    const bool second_next = around.at(1).after == first.before;
    mesh.triangles.push_back(
        {first.ring, around.at(second_next ? 1 : 2).ring, around.at(second_next ? 2 : 1).ring});
  }
  return mesh;
}

void move_off_symmetry(Molecule& molecule) {
  std::mt19937_64 random(1);
  const auto share = [&] { return static_cast<double>(random() >> 11) * 0x1p-52 - 1.0; };  // from -1 to 1
  for (Vec3& p : molecule.positions)
    for (int d = 0; d < 3; ++d) p[d] += off_symmetry / std::sqrt(3.0) * share();
}

}  // namespace

Molecule schwarzite(const std::string& name) {
  std::size_t atoms = 0;
  const char* end = name.data() + name.size();
  if (name.size() < 2 || std::from_chars(name.data() + 1, end, atoms).ptr != end) refuse(name);
  if (atoms > most_atoms)
    throw UserError(Failure::usage,
                    fmt::format("schwarzite {}: a cell may have {} atoms at most", name, most_atoms));
  for (const Family& family : families) {
    if (family.letter != name.front() || atoms % family.atoms != 0) continue;
    const std::optional<Step> step = step_of(atoms / family.atoms);
    if (!step) continue;
    Molecule network = family.network();
    if (atoms == family.atoms) return network;
    TriangleMesh triangulation = shapes::goldberg_coxeter(triangulation_of(network), step->h, step->k);
    rescale(triangulation, std::sqrt(static_cast<double>(atoms) / static_cast<double>(family.atoms)));
    Molecule molecule = molecule::dual(triangulation);
    relax_by_springs(molecule, {});
    move_off_symmetry(molecule);
    return molecule;
  }
  refuse(name);
}

Molecule repeated(const Molecule& molecule, const std::array<int, 3>& cells) {
  if (cells == std::array<int, 3>{1, 1, 1}) return molecule;
  Molecule result;
  result.cell = molecule.cell;
  for (int d = 0; d < 3; ++d) result.cell->vectors.col(d) *= cells[static_cast<std::size_t>(d)];
  for (int k = 0; k < cells[2]; ++k)
    for (int j = 0; j < cells[1]; ++j)
      for (int i = 0; i < cells[0]; ++i) {
        const Vec3 shift = image_shift(*molecule.cell, {i, j, k});
        for (const Vec3& p : molecule.positions) result.positions.push_back(p + shift);
        result.elements.insert(result.elements.end(), molecule.elements.begin(), molecule.elements.end());
      }
  add_bonds(result);
  add_rings(result, 8);
  return result;
}

}  // namespace nanocarbon::structures
