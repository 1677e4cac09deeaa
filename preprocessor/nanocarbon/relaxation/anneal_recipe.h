#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

#include "nanocarbon/mesh/triangle_mesh.h"
#include "nanocarbon/molecule/molecule.h"
#include "nanocarbon/relaxation/trivalent_network.h"

namespace nanocarbon {

//! How much time may be spent on a molecule. CPU on one core, for each atom.
enum class AnnealQuality {
  draft,  //!< dual relaxation alone, below 1 ms
  good,   //!< defects annealed, 8 to 20 ms, up to 40 below 500 atoms
  best    //!< several attempts and slower cooling, below 100 ms
};

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
  AnnealQuality quality = AnnealQuality::good;
  double tether = default_tether;  //!< to the surface while annealing, eV/Angstrom^2
  double force_tolerance = 1e-3;   //!< eV/Angstrom, of the last minimisation
  std::uint64_t seed = 1;
  unsigned threads = 1;
  //! Keep the surface's size. Otherwise, as the number of atoms is what is asked for, it becomes what fits
  //! best.
  bool keep_size = false;
  RoomMaker make_room = {};  //!< empty: there is room
  std::function<void(std::string_view stage, double share)> progress = {};
};

struct AnnealResult {
  Molecule molecule;             //!< with rings; at a minimum of the full REBO2 energy
  TrivalentNetwork network;      //!< of the molecule, with what it has on borders
  double unannealed_energy = 0;  //!< eV for each atom, of dual relaxation alone
  double energy = 0;             //!< eV for each atom
  double max_force = 0;          //!< eV/Angstrom
  double mean_distance = 0;      //!< of the atoms to the surface, Angstrom
  double growth = 1;             //!< the surface times this fits the molecule
  double shortest_bond = 0;      //!< Angstrom
  double longest_bond = 0;       //!< Angstrom
  double closest_unbonded = 0;   //!< Angstrom, at most 2.2 (geometry_check.h)
  bool intact = false;           //!< REBO2 sees exactly the molecule's bonds
  int refinements = 0;           //!< times the triangulation was cut in four
  std::size_t accepted = 0;      //!< bond switches made
};

//! \brief The default recipe: from a surface to a molecule at a minimum of REBO2.
//!
//! Triangulates the surface and relaxes the dual. Anneals at a sixteenth and a quarter of the atoms and
//! refines step by step, where the shape still shows with so few; anneals at full size, too, where that may
//! be better. Takes the molecule with the least energy once it is let go of those within 1 Angstrom of the
//! surface in the mean; where there is none, at a price for distance (start_choice.h). Then minimises the
//! full potential without a tether; where REBO2 would see other bonds than the molecule's, mends the place
//! first. In the end the molecule is moved to where it fits the surface best.
//!
//! \param surface Angstrom; a sound oriented 2-manifold, with or without border
//! \param atoms wanted; met within one percent where the surface allows
//! \throw UserError as the triangulator does
AnnealResult anneal(const TriangleMesh& surface, std::size_t atoms, const Triangulator& triangulate,
                    const AnnealOptions& options);

}  // namespace nanocarbon
