// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

#include "nanocarbon/core/quality.h"
#include "nanocarbon/mesh/triangle_mesh.h"
#include "nanocarbon/minimisation/cell_minimum.h"

namespace nanocarbon::building {

//! Makes a triangulation of a surface with about the given number of faces, in the surface's unit.
using Triangulator =
    std::function<TriangleMesh(const TriangleMesh& surface, std::size_t faces, std::uint64_t seed)>;

//! The surface with its thin parts and gaps made wide enough for carbon, Angstrom; nothing where they are.
using RoomMaker = std::function<std::optional<TriangleMesh>(const TriangleMesh& surface)>;

//! Stiff enough that bond switches feel within their reach what bends the sheet away from the surface:
//! (1.4 eV, graphene's bending rigidity, over the tether for each area)^(1/4) is 3 Angstrom. eV/Angstrom^2.
inline constexpr double default_tether = 0.05;
//! Where the surface's size is meant: a narrow tube's bending presses it outwards by 0.01 eV/Angstrom an
//! atom.
inline constexpr double default_tether_of_size = 0.2;

struct AnnealOptions {
  Quality quality = Quality::good;
  double tether = default_tether;  //!< to the surface while annealing, eV/Angstrom^2
  double force_tolerance = 1e-3;   //!< eV/Angstrom, of the last minimisation
  std::uint64_t seed = 1;
  unsigned threads = 1;
  //! Keep the surface's size. Otherwise, as the number of atoms is what is asked for, it becomes what fits
  //! best.
  bool keep_size = false;
  //! Strains of a periodic cell that the last minimisation frees.
  minimisation::CellRelaxation relax_cell = minimisation::CellRelaxation::none;
  long largest_ring = 7;     //!< atoms in a ring that annealing makes
  RoomMaker make_room = {};  //!< empty: there is room
  std::function<void(std::string_view stage, double share)> progress = {};
};

}  // namespace nanocarbon::building
