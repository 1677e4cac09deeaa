// SPDX-License-Identifier: GPL-2.0-or-later
#include "fuzz/check_molecule.h"

#include <algorithm>

#include "nanocarbon/core/error.h"
#include "nanocarbon/molecule/formats/distance_warnings.h"
#include "nanocarbon/molecule/formats/read_molecule.h"

namespace nanocarbon::test {

std::string broken_by(const molecule::MoleculeFrame& frame) {
  const Molecule& m = frame.molecule;
  if (m.elements.size() != m.size() || frame.ids.size() != m.size())
    return "atoms, elements and IDs differ in number";
  if (!std::all_of(m.positions.begin(), m.positions.end(), [](const Vec3& p) { return p.allFinite(); }))
    return "a position is not finite";
  if (std::adjacent_find(frame.ids.begin(), frame.ids.end(), std::greater_equal<>()) != frame.ids.end())
    return "IDs do not ascend";
  for (std::size_t b = 0; b < m.bonds.size(); ++b) {
    if (m.bonds[b].first > m.bonds[b].second || m.bonds[b].second >= m.size())
      return "a bond is out of range";
    if (b > 0 && !(m.bonds[b - 1] < m.bonds[b])) return "bonds are not sorted and unique";
  }
  if (m.cell && !(volume(*m.cell) > 0.0)) return "the cell has no volume";
  if (m.cell && m.cell->periodic == std::array{false, false, false}) return "a cell that is periodic nowhere";
  return {};
}

std::size_t atoms_read(std::string_view contents, const std::string& file,
                       const molecule::MoleculeReadOptions& options) {
  molecule::MoleculeFile molecules(contents, file, options);
  std::size_t atoms = 0;
  while (const auto frame = molecules.next()) atoms += frame->molecule.size();
  return atoms;
}

std::string broken_promise(std::string_view contents, const std::string& file,
                           const molecule::MoleculeReadOptions& options) {
  try {
    molecule::MoleculeFile molecules(contents, file, options);
    for (int frames = 0; frames < 100; ++frames) {
      const auto frame = molecules.next();
      if (!frame) break;
      if (const std::string broken = broken_by(*frame); !broken.empty()) return broken;
      for (const molecule::ClosePair& pair : molecule::find_close_atoms(frame->molecule, 0.5).pairs)
        if (pair.first > pair.second || pair.second >= frame->molecule.size() || !(pair.distance < 0.5))
          return "a pair of close atoms is none";
      molecule::distance_warnings(*frame, file);
    }
    molecules.unused_types();
    return {};
  } catch (const UserError& error) {
    const bool usage = error.failure() == Failure::usage;
    return !usage && std::string_view(error.what()).find(file) == std::string_view::npos
               ? "the message does not name the file: " + std::string(error.what())
               : "";
  }
}

}  // namespace nanocarbon::test
