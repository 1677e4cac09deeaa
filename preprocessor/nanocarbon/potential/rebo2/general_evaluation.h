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

//! Finds the bonds of the own atoms, their neighbours and the neighbours' neighbours: all that own terms
//! depend on.
void collect_bonds(const potential::AtomsView& atoms, const potential::NearPairs& near,
                   const Rebo2Parameters& parameters, HalfEdges& edges);

//! Adds the terms of the own atoms, and derivatives to their half-edges, which collect_bonds() has found.
EnergyParts add_general_terms(const potential::AtomsView& atoms, const Model& model,
                              GeneralWorkspace& workspace, const potential::AtomShares& shares);

//! \brief The bond-order energy of any carbon and hydrogen atoms, straight from the formulas: the reference
//! for everything faster.
//! \param forces x, y, z of every atom, copies included; added to, eV/Angstrom
//! \param shares where energies and virials of single atoms are added to, if wanted
//! \return the energy of the own atoms' terms; bonds between an own atom and a copy count half
EnergyParts evaluate_general(const potential::AtomsView& atoms, const potential::NearPairs& near,
                             const Model& model, GeneralWorkspace& workspace, double* forces,
                             const potential::AtomShares& shares);

}  // namespace nanocarbon::rebo2
