// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "nanocarbon/potential/rebo2/bond_order.h"

namespace nanocarbon::rebo2 {

//! What the general evaluation keeps from step to step to avoid allocating.
struct GeneralWorkspace {
  HalfEdges edges;
  std::vector<AngleTerm> angles;
};

//! \brief The bond-order energy of any carbon and hydrogen atoms, straight from the formulas: the reference for everything
//! faster.
//! \param forces x, y, z of every atom, copies included; added to, eV/Angstrom
//! \param shares where energies and virials of single atoms are added to, if wanted
//! \return the energy of the own atoms' terms; bonds between an own atom and a copy count half
EnergyParts evaluate_general(const potential::AtomsView& atoms, const potential::NearPairs& near,
                             const Model& model, GeneralWorkspace& workspace, double* forces,
                             const potential::AtomShares& shares);

}  // namespace nanocarbon::rebo2
