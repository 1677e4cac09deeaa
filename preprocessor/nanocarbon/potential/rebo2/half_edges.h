// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "nanocarbon/core/vec3.h"
#include "nanocarbon/potential/near_pairs.h"
#include "nanocarbon/potential/rebo2/parameters.h"

namespace nanocarbon::rebo2 {

//! \brief A bond seen from one of its ends, with the derivatives of the energy by its geometry.
//! \details Energy terms depend on positions only through direction, length and weight of half-edges. A term
//! adds to the derivatives; HalfEdges::add_forces() applies the chain rule once for all of them.
struct HalfEdge {
  std::uint32_t to;
  Element element;      //!< of the atom at the other end
  double length;        //!< Angstrom
  double weight;        //!< 1 for a whole bond, 0 at the cut-off
  double weight_slope;  //!< by length
  Vec3 direction;       //!< unit vector from the centre to the other end

  double by_length = 0.0;            //!< dE/d length at fixed weight, eV/Angstrom
  double by_weight = 0.0;            //!< dE/d weight, eV
  Vec3 by_direction = Vec3::Zero();  //!< dE/d direction, eV; its component along the direction has no meaning
};

//! An atom and its bonds: a range of the half-edges.
struct Centre {
  std::uint32_t atom;
  Element element;
  std::uint32_t first;
  std::uint32_t count;
  double carbons;    //!< N^C: sum of the weights of its bonds to carbon
  double hydrogens;  //!< N^H
  double coordination() const { return carbons + hydrogens; }
};

//! The force on the centre that a half-edge's derivatives amount to, and minus that on its far end.
inline Vec3 half_edge_pull(const HalfEdge& edge, double by_length, const Vec3& by_direction) {
  return by_length * edge.direction +
         (by_direction - by_direction.dot(edge.direction) * edge.direction) / edge.length;
}

//! The bonds of some of the atoms, found among their near pairs. Keeps its memory from call to call.
class HalfEdges {
 public:
  static constexpr std::uint32_t absent = std::numeric_limits<std::uint32_t>::max();

  //! Removes all centres and prepares for atoms 0 to atoms - 1.
  void clear(std::uint32_t atoms);
  //! Finds the bonds of an atom, unless it has been added already. Invalidates spans.
  void add(std::uint32_t atom, const potential::AtomsView& atoms, const potential::NearPairs& near,
           const Rebo2Parameters& parameters);

  bool has(std::uint32_t atom) const { return place_[atom] != absent; }
  //! Number of bonds of an atom, counted by weight. Atoms that were not added are those of the fast evaluation, with
  //! three bonds.
  double coordination(std::uint32_t atom) const { return has(atom) ? centre(atom).coordination() : 3.0; }
  const Centre& centre(std::uint32_t atom) const { return centres_[place_[atom]]; }
  std::span<HalfEdge> of(const Centre& centre) { return {edges_.data() + centre.first, centre.count}; }
  //! A half-edge by its number, Centre::first plus its place among the bonds, which stays valid as centres are added.
  HalfEdge& operator[](std::uint32_t edge) { return edges_[edge]; }

  //! Adds the forces that follow from the derivatives; forces has x, y, z of every atom.
  void add_forces(double* forces) const;

 private:
  std::vector<std::uint32_t> place_;  //!< of an atom in centres_
  std::vector<Centre> centres_;
  std::vector<HalfEdge> edges_;
};

}  // namespace nanocarbon::rebo2
