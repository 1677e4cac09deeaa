// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/formats/distance_warnings.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "nanocarbon/core/bond_cutoffs.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/core/space.h"

namespace nanocarbon::molecule {
namespace {

constexpr double too_close = 0.5;          // Angstrom: no two atoms of carbon or hydrogen are bonded at that
constexpr double bonded_to_itself = 1.15;  // Angstrom: no two carbon atoms are

//! An atom, or an image of one that is near the cell.
struct Point {
  Vec3 position;
  AtomIndex atom;
  bool image;
};

// The atoms wrapped into the cell, and the images of those near its faces that are within the distance of it.
std::vector<Point> points_of(const Molecule& molecule, double distance) {
  std::vector<Point> points;
  points.reserve(molecule.size() + molecule.size() / 8);
  if (!molecule.cell) {
    for (std::size_t i = 0; i < molecule.size(); ++i)
      points.push_back({molecule.positions[i], static_cast<AtomIndex>(i), false});
    return points;
  }
  const Cell& cell = *molecule.cell;
  const Mat3 to_fraction = cell.vectors.inverse();
  const Vec3 faces = face_distances(cell);
  constexpr double most = 4.0;  // images each way, of a cell thinner than the distance
  for (std::size_t i = 0; i < molecule.size(); ++i) {
    Vec3 fraction = to_fraction * (molecule.positions[i] - cell.origin);
    int low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
    for (int d = 0; d < 3; ++d) {
      if (!cell.periodic[static_cast<std::size_t>(d)]) continue;
      fraction[d] -= std::floor(fraction[d]);
      const double reach = distance / faces[d];
      low[d] = -static_cast<int>(std::min(most, std::floor(fraction[d] + reach)));
      high[d] = static_cast<int>(std::min(most, std::floor(1.0 - fraction[d] + reach)));
    }
    for (int a = low[0]; a <= high[0]; ++a)
      for (int b = low[1]; b <= high[1]; ++b)
        for (int c = low[2]; c <= high[2]; ++c)
          points.push_back({cell.origin + cell.vectors * (fraction + Vec3(a, b, c)),
                            static_cast<AtomIndex>(i), a != 0 || b != 0 || c != 0});
  }
  return points;
}

struct Entry {
  std::uint64_t box;
  std::uint32_t point;
};

// Boxes of space and the points whose cube of that edge reaches into them: two points within the distance of each
// other are in one box at least. Different boxes of the same number do no harm.
std::vector<Entry> sorted_into_boxes(const std::vector<Point>& points, double distance) {
  const double width = 8.0 * distance;
  std::vector<Entry> entries;
  entries.reserve(points.size() + points.size() / 2);
  for (std::size_t p = 0; p < points.size(); ++p) {
    std::int64_t low[3], high[3];
    for (int d = 0; d < 3; ++d) {
      low[d] = static_cast<std::int64_t>(std::floor((points[p].position[d] - 0.5 * distance) / width));
      high[d] = static_cast<std::int64_t>(std::floor((points[p].position[d] + 0.5 * distance) / width));
    }
    for (std::int64_t a = low[0]; a <= high[0]; ++a)
      for (std::int64_t b = low[1]; b <= high[1]; ++b)
        for (std::int64_t c = low[2]; c <= high[2]; ++c) {
          std::uint64_t box = static_cast<std::uint64_t>(a) * 0x9e3779b97f4a7c15u;
          box = (box ^ (box >> 29) ^ static_cast<std::uint64_t>(b)) * 0xbf58476d1ce4e5b9u;
          box = (box ^ (box >> 32) ^ static_cast<std::uint64_t>(c)) * 0x94d049bb133111ebu;
          entries.push_back({box, static_cast<std::uint32_t>(p)});
        }
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return a.box != b.box ? a.box < b.box : a.point < b.point;
  });
  return entries;
}

}  // namespace

CloseAtoms find_close_atoms(const Molecule& molecule, double distance) {
  const std::vector<Point> points = points_of(molecule, distance);
  const std::vector<Entry> entries = sorted_into_boxes(points, distance);
  const std::size_t most = std::max<std::size_t>(8 * molecule.size(), 64);  // a pair can be met in 8 boxes
  CloseAtoms found;
  for (std::size_t begin = 0, end = 0; begin < entries.size() && found.all; begin = end) {
    while (end < entries.size() && entries[end].box == entries[begin].box) ++end;
    for (std::size_t i = begin; i < end && found.all; ++i)
      for (std::size_t j = i + 1; j < end && found.all; ++j) {
        const Point &a = points[entries[i].point], &b = points[entries[j].point];
        const double squared = (a.position - b.position).squaredNorm();
        if (!(squared < distance * distance) || (a.image && b.image)) continue;
        found.pairs.push_back({std::min(a.atom, b.atom), std::max(a.atom, b.atom), std::sqrt(squared)});
        found.all = found.pairs.size() < most;
      }
  }
  const auto same = [](const ClosePair& a, const ClosePair& b) {
    return a.first == b.first && a.second == b.second;
  };
  std::vector<ClosePair>& pairs = found.pairs;
  std::sort(pairs.begin(), pairs.end(), [](const ClosePair& a, const ClosePair& b) {
    return a.first != b.first     ? a.first < b.first
           : a.second != b.second ? a.second < b.second
                                  : a.distance < b.distance;
  });
  pairs.erase(std::unique(pairs.begin(), pairs.end(), same), pairs.end());
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const ClosePair& a, const ClosePair& b) { return a.distance < b.distance; });
  return found;
}

namespace {

// "atoms 3 and 17", by the file's IDs.
std::string named(const MoleculeFrame& frame, const ClosePair& pair) {
  if (pair.first == pair.second) return fmt::format("atom {} and its own image", frame.ids[pair.first]);
  return fmt::format("atoms {} and {}", frame.ids[pair.first], frame.ids[pair.second]);
}

std::optional<std::string> atoms_on_top(const MoleculeFrame& frame, const std::string& name) {
  const CloseAtoms close = find_close_atoms(frame.molecule, too_close);
  if (close.pairs.empty()) return std::nullopt;
  const ClosePair& nearest = close.pairs.front();
  const std::string gist =
      fmt::format("{} are {:.3g} Angstrom from each other", named(frame, nearest), nearest.distance);
  if (!close.all)
    throw UserError(
        Failure::unsuitable,
        fmt::format("{}: nearly all atoms lie on top of others ({}); are the lengths, and those of "
                    "the cell, in Angstrom?",
                    name, gist));
  std::string others;
  for (std::size_t k = 1; k < std::min<std::size_t>(close.pairs.size(), 4); ++k)
    others += fmt::format("{}{} ({:.3g})", k == 1 ? "; so are " : ", ", named(frame, close.pairs[k]),
                          close.pairs[k].distance);
  if (close.pairs.size() > 4) others += fmt::format(", and {} pairs more", close.pairs.size() - 4);
  const bool across =
      frame.molecule.cell &&
      (frame.molecule.positions[nearest.first] - frame.molecule.positions[nearest.second]).norm() > too_close;
  return fmt::format("{}{}{}: atoms on top of each other", gist,
                     across ? " across the periodic boundary (does the box end where its atoms do?)" : "",
                     others);
}

std::optional<std::string> thin_cell(const Molecule& molecule) {
  if (!molecule.cell) return std::nullopt;
  const Cell& cell = *molecule.cell;
  double shortest = std::numeric_limits<double>::infinity();
  const auto reach = [&](std::size_t d) { return cell.periodic[d] ? 1 : 0; };
  for (int a = -reach(0); a <= reach(0); ++a)
    for (int b = -reach(1); b <= reach(1); ++b)
      for (int c = -reach(2); c <= reach(2); ++c)
        if (a != 0 || b != 0 || c != 0) shortest = std::min(shortest, (cell.vectors * Vec3(a, b, c)).norm());
  if (shortest < too_close || shortest > bonded_to_itself) return std::nullopt;
  return fmt::format(
      "each atom is {:.3g} Angstrom from its own image: the cell is too thin, or not periodic that way (flat "
      "sheets are read with --boundary 'p p f')",
      shortest);
}

bool can_be_bonded(const Molecule& m, std::size_t i, std::size_t j, double distance) {
  return distance < rebo_bond_cutoffs.of(m.elements[i], m.elements[j]).end;
}

bool has_neighbour(const Molecule& m, const Space& space, std::size_t atom) {
  for (std::size_t j = 0; j < m.size(); ++j)
    if (j != atom && can_be_bonded(m, atom, j, space.displacement(m.positions[atom], m.positions[j]).norm()))
      return true;
  return false;
}

// Some atoms tell that all is well; only where they do not are all looked at.
std::optional<std::string> far_apart(const Molecule& molecule) {
  constexpr std::size_t sample = 24, fewest = 8;
  if (molecule.size() < fewest) return std::nullopt;
  const Space space(molecule.cell);
  const std::size_t looked_at = std::min(sample, molecule.size());
  std::size_t bonded = 0;
  for (std::size_t k = 0; k < looked_at; ++k)
    bonded += has_neighbour(molecule, space, k * molecule.size() / looked_at);
  if (4 * bonded > looked_at) return std::nullopt;
  std::vector<char> near(molecule.size(), 0);
  for (const ClosePair& pair : find_close_atoms(molecule, rebo_bond_cutoffs.carbon_carbon.end).pairs)
    if (can_be_bonded(molecule, pair.first, pair.second, pair.distance))
      near[pair.first] = near[pair.second] = 1;
  const auto count = static_cast<std::size_t>(std::count(near.begin(), near.end(), 1));
  if (10 * count > molecule.size()) return std::nullopt;
  return fmt::format(
      "{} of {} atoms are near enough to another for a bond: are the lengths in Angstrom (1 Bohr is "
      "0.529177)?",
      count == 0 ? "none" : fmt::format("only {}", count), molecule.size());
}

// Of atoms in the cell, how many pairs have a bond through the two faces that the edge leads between, and no other.
std::size_t bonds_through(const Molecule& molecule, const Cell& cell, std::size_t edge) {
  constexpr double outside = 0.6, longest = rebo_bond_cutoffs.carbon_carbon.begin;
  const auto d = static_cast<int>(edge);
  const double width = face_distances(cell)[d];
  if (width < 2.0 * longest) return 0;
  const Mat3 to_fraction = cell.vectors.inverse();
  Molecule near;
  for (std::size_t i = 0; i < molecule.size(); ++i) {
    const double fraction = (to_fraction * (molecule.positions[i] - cell.origin))[d];
    if (width * std::max(-fraction, fraction - 1.0) > outside) return 0;
    if (width * std::min(fraction, 1.0 - fraction) > longest) continue;
    near.positions.push_back(molecule.positions[i]);
    near.elements.push_back(molecule.elements[i]);
  }
  near.cell = cell;
  near.cell->periodic[edge] = true;
  const Space open(cell);
  std::size_t bonds = 0;
  for (const ClosePair& pair : find_close_atoms(near, longest).pairs) {
    const double bound = rebo_bond_cutoffs.of(near.elements[pair.first], near.elements[pair.second]).begin;
    bonds += pair.distance > too_close && pair.distance < bound &&
             open.displacement(near.positions[pair.first], near.positions[pair.second]).norm() > longest;
  }
  return bonds;
}

}  // namespace

std::optional<std::string> bonds_through_open_faces(const Molecule& molecule, const Cell& cell) {
  std::array<bool, 3> periodic = cell.periodic;
  std::size_t bonds = 0;
  for (std::size_t d = 0; d < 3; ++d) {
    if (cell.periodic[d]) continue;
    const std::size_t found = bonds_through(molecule, cell, d);
    periodic[d] = found > 0;
    bonds += found;
  }
  if (bonds == 0) return std::nullopt;
  const auto letter = [&](std::size_t d) { return periodic[d] ? 'p' : 'f'; };
  return fmt::format(
      "the file says that the cell is open where {} bonds would lead through its faces: if it is periodic, "
      "say "
      "so with --boundary '{} {} {}'",
      bonds, letter(0), letter(1), letter(2));
}

std::vector<std::string> distance_warnings(const MoleculeFrame& frame, const std::string& name) {
  std::vector<std::string> warnings;
  for (const auto& warning :
       {atoms_on_top(frame, name), thin_cell(frame.molecule), far_apart(frame.molecule)})
    if (warning) warnings.push_back(*warning);
  return warnings;
}

}  // namespace nanocarbon::molecule
