// SPDX-License-Identifier: GPL-2.0-or-later
// What searches for rings by shortest paths share: the surroundings of an atom, unfolded, and how all atoms are
// gone through.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "nanocarbon/analysis/bond_rows.h"
#include "nanocarbon/topology/rings.h"

namespace nanocarbon::analysis {

//! \brief The surroundings of an atom with the periodic images taken apart: places are numbered as they are met.
//! \details A small cell holds the same atom at several places, and a path that leaves it and comes back to another
//! image closes no ring. Made to be used for one atom after the other.
class UnfoldedSurroundings {
 public:
  explicit UnfoldedSurroundings(const BondRows& rows);

  //! Forgets everything and puts an atom at place 0.
  void start(AtomIndex atom);
  AtomIndex atom(std::uint32_t place) const { return places_[place].atom; }
  //! The places bonded to one; valid until the next call that meets new places.
  std::span<const std::uint32_t> neighbours(std::uint32_t place);
  //! How many places have been met.
  std::size_t size() const { return places_.size(); }

  //! \brief Whether a path of fewer than `bonds` bonds leads from one place to another.
  //! \param avoided a place that it may not pass; none: any may be passed
  bool is_nearer(std::uint32_t from, std::uint32_t to, int bonds, std::uint32_t avoided = none);

  static constexpr std::uint32_t none = 0xffffffffu;

 private:
  struct Place {
    AtomIndex atom;
    std::array<std::int32_t, 3> image;
    std::uint32_t first, last;  // its neighbours in links_; first is none before they were asked for
  };
  std::uint32_t place_of(AtomIndex atom, const std::array<std::int32_t, 3>& image);
  void grow_table();

  const BondRows& rows_;
  std::vector<Place> places_;
  std::vector<std::uint32_t> links_;
  std::vector<std::uint32_t> table_;  // open addressing; none where empty
  // Of is_nearer: which places were reached, from which side and in which call.
  std::vector<std::uint64_t> reached_;
  std::uint64_t call_ = 0;
  std::vector<std::uint32_t> front_[2], after_;
};

//! Rings found by a search, and how many there are of each size.
struct RingStatistics {
  std::vector<std::uint64_t> counts;  //!< by size; size max_ring + 1
  Rings rings;                        //!< each starts at its lowest atom; sorted by that atom
};

struct RingSearchOptions {
  int max_ring = 12;     //!< longer rings are not looked for; 3 to 64
  unsigned threads = 1;  //!< the result does not depend on it
};

//! The rings that were found at one atom, as places.
class FoundRings {
 public:
  //! \brief Takes a ring in, unless this atom has it already through another image.
  //! \pre the first place is 0, the atom that the search started at
  void add(UnfoldedSurroundings& surroundings, std::span<const std::uint32_t> ring);
  void clear() { offsets = {0}, atoms.clear(), repeated_.clear(); }

  std::vector<std::uint32_t> offsets = {0};
  std::vector<AtomIndex> atoms;

 private:
  std::vector<std::vector<std::uint32_t>> repeated_;
};

using RingsAtAtom = std::function<void(UnfoldedSurroundings&, FoundRings&)>;

//! \brief Calls a search at every atom and collects what it finds, in the order of the atoms.
//! \param make_search makes a search of its own for each thread
RingStatistics search_at_all_atoms(const BondRows& rows, const RingSearchOptions& options,
                                   const std::function<RingsAtAtom()>& make_search);

//! \brief Why rings are not searched for, or nothing.
//! \details Paths multiply with bonds: where an atom has more than twelve the file's lengths are hardly Angstrom.
//! \return the first atom with more than twelve bonds
std::optional<AtomIndex> crowded_atom(const BondRows& rows);

}  // namespace nanocarbon::analysis
