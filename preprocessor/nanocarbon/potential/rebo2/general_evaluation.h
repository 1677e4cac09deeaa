// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "nanocarbon/potential/rebo2/bond_order.h"

namespace nanocarbon::rebo2 {

//! Memory that the general evaluation keeps from call to call.
struct GeneralWorkspace {
  HalfEdges edges;
  std::vector<AngleTerm> angles;
};

//! Finds the bonds of the own atoms, their neighbours and the neighbours' neighbours: all that the terms of own
//! atoms depend on.
void collect_bonds(const potential::AtomsView& atoms, const potential::NearPairs& near,
                   const Rebo2Parameters& parameters, HalfEdges& edges);

//! Adds the terms of the own atoms, and their derivatives to the half-edges that collect_bonds() has found.
EnergyParts add_general_terms(const potential::AtomsView& atoms, const Model& model,
                              GeneralWorkspace& workspace, const potential::AtomShares& shares);

//! \brief The bond-order energy of any carbon and hydrogen atoms, straight from the formulas: the reference
//! for everything faster.
//! \param forces x, y, z of every atom, copies included; added to, eV/Angstrom
//! \param shares where energies and virials of single atoms are added, if wanted
//! \return the energy of the own atoms' terms; bonds between an own atom and a copy count half
EnergyParts evaluate_general(const potential::AtomsView& atoms, const potential::NearPairs& near,
                             const Model& model, GeneralWorkspace& workspace, double* forces,
                             const potential::AtomShares& shares);

}  // namespace nanocarbon::rebo2
