// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "nanocarbon/annealing/surface_tether.h"
#include "nanocarbon/annealing/switching_patch.h"
#include "nanocarbon/building/start_choice.h"
#include "nanocarbon/minimisation/cell_minimum.h"

namespace nanocarbon::building {

//! \brief Releases a copy of the molecule from its tether and measures how far it moves from the surface.
//! \details The energy is that of fixed-bond REBO2 alone; the distance is measured after the motion that fits the copy to
//! the surface best.
//! \param with_scale whether the size of the molecule may differ from the surface's
Released spring_back(const annealing::SwitchingState& state, const annealing::TetherSurface& surface,
                     bool with_scale);

//! \brief The same in a periodic cell, whose strains are let go as well: otherwise the choice would be one between
//! stresses.
//! \details Minimises REBO2, where it sees the bonds; else as above, in the cell as it is.
//! \param surface of the state's positions; it is strained along
//! \param deformation of the cell is set
Released spring_back_in_cell(const annealing::SwitchingState& state, const TriangleMesh& surface,
                             minimisation::CellRelaxation strains, Mat3& deformation);

//! \brief Where a molecule that was let go in a periodic cell lies, once moved to where it fits the strained surface best.
//! \param positions after that; it may have drifted as a whole, as minimisation lets 2,000 atoms and more
//! \param held where they were before
//! \param energy eV for each atom, handed on
Released released_in_cell(const annealing::TrivalentNetwork& network, std::vector<Vec3> positions,
                          std::vector<Vec3> held, TriangleMesh surface, const Mat3& deformation,
                          double energy);

}  // namespace nanocarbon::building
