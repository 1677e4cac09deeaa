// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysed_xyz.h"

#include <fmt/format.h>

#include "nanocarbon/molecule/formats/text_output.h"

namespace nanocarbon::cli {
namespace {

std::string sizes_of_rings(const analysis::Analysis& analysis, AtomIndex atom) {
  std::string text;
  for (const std::uint32_t r : analysis.rings_of_atoms.of(atom))
    text += fmt::format("{}{}", text.empty() ? "" : "-", analysis.components.rings[r].size());
  return text.empty() ? "-" : text;
}

std::size_t smallest_ring(const analysis::Analysis& analysis, AtomIndex atom) {
  const auto rings = analysis.rings_of_atoms.of(atom);
  return rings.empty() ? 0 : analysis.components.rings[rings.front()].size();
}

std::string comment(const Molecule& molecule, bool energies, const std::string& generator) {
  std::string text;
  if (molecule.cell) {
    const Cell& cell = *molecule.cell;
    std::string numbers;
    for (int edge = 0; edge < 3; ++edge)
      for (int d = 0; d < 3; ++d)
        numbers += fmt::format("{}{}", numbers.empty() ? "" : " ", cell.vectors(d, edge));
    text += fmt::format("Lattice=\"{}\" Origin=\"{} {} {}\" ", numbers, cell.origin.x(), cell.origin.y(),
                        cell.origin.z());
  }
  text +=
      "Properties=species:S:1:pos:R:3:id:I:1:coordination:I:1:smallest_ring:I:1:rings:S:1:piece:I:1:state:I:"
      "1:"
      "defect:I:1:pyramidalisation:R:1:mean_curvature:R:1:gaussian_curvature:R:1";
  if (energies) text += ":atom_energy:R:1";
  const auto letter = [&](int d) { return molecule.cell && molecule.cell->periodic[d] ? 'T' : 'F'; };
  text += fmt::format(" pbc=\"{} {} {}\"", letter(0), letter(1), letter(2));
  std::string plain;  // a quotation mark would end the value
  for (const char c : generator) plain += c == '"' ? '\'' : c;
  return text + fmt::format(" generator=\"{}\"", plain);
}

}  // namespace

void write_analysed_xyz(std::ostream& out, const Molecule& molecule, std::span<const std::int64_t> ids,
                        const analysis::Analysis& analysis, std::span<const analysis::AtomFate> fates,
                        const std::string& generator) {
  std::vector<std::uint32_t> defect(molecule.size(), 0);
  for (std::size_t d = analysis.defects.size(); d-- > 0;)
    for (const AtomIndex a : analysis.defects[d].atoms) defect[a] = static_cast<std::uint32_t>(d) + 1;
  const bool energies = !analysis.atom_energies.empty();
  molecule::TextOutput text(out);
  text.print("{}\n{}\n", molecule.size(), comment(molecule, energies, generator));
  for (AtomIndex a = 0; a < molecule.size(); ++a) {
    const Vec3& p = molecule.positions[a];
    const analysis::AtomGeometry& g = analysis.geometry;
    text.print("{} {} {} {} {} {} {} {} {} {} {} {:.4f} {:.6f} {:.7f}", symbol(molecule.elements[a]), p.x(),
               p.y(), p.z(), ids[a], analysis.rows.degree(a), smallest_ring(analysis, a),
               sizes_of_rings(analysis, a), analysis.components.of_atom[a] + 1, static_cast<int>(fates[a]),
               defect[a], g.pyramidalisation[a], g.mean_curvature[a], g.gaussian_curvature[a]);
    if (energies) text.print(" {:.8f}", analysis.atom_energies[a]);
    text.print("\n");
  }
  text.flush();
}

}  // namespace nanocarbon::cli
