// SPDX-License-Identifier: GPL-2.0-or-later
// Everything that can be read off a structure of carbon and hydrogen.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "nanocarbon/analysis/atom_geometry.h"
#include "nanocarbon/analysis/components.h"
#include "nanocarbon/analysis/defects.h"
#include "nanocarbon/analysis/distributions.h"
#include "nanocarbon/analysis/frame_comparison.h"
#include "nanocarbon/potential/potential.h"

namespace nanocarbon::analysis {

struct AnalyseOptions {
  ComponentOptions components;
  //! Evaluates energies; nullptr: they are left out.
  potential::Potential* potential = nullptr;
};

//! The rings that pass each atom, in compressed rows.
struct RingsOfAtoms {
  std::vector<std::uint32_t> offsets;  //!< size atoms + 1
  std::vector<std::uint32_t> rings;    //!< indices into MoleculeComponents::rings, by size and then index
  std::span<const std::uint32_t> of(AtomIndex atom) const {
    return {rings.data() + offsets[atom], rings.data() + offsets[atom + 1]};
  }
};

RingsOfAtoms rings_of_atoms(std::size_t atoms, const Rings& rings);

//! What there is to say of one frame.
struct Analysis {
  MoleculeComponents components;
  BondDistributions bonds;
  BondRows rows;  //!< of all bonds
  RingsOfAtoms rings_of_atoms;
  AtomGeometry geometry;
  Distribution pyramidalisation, mean_curvature, gaussian_curvature;  //!< bins of 1, 0.005, 0.0005
  std::vector<Defect> defects;
  std::optional<double> energy;       //!< eV; nothing where it was not asked for
  std::vector<double> atom_energies;  //!< eV
  std::string potential;              //!< its name
};

//! \param molecule with its bonds (frame_bonds)
//! \param ids of its atoms, for messages
Analysis analyse(const Molecule& molecule, std::span<const std::int64_t> ids, const AnalyseOptions& options);

}  // namespace nanocarbon::analysis
