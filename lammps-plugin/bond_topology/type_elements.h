// SPDX-License-Identifier: GPL-2.0-or-later
// Which atom types are carbon and which hydrogen.
#pragma once

#include <mpi.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "nanocarbon/core/element.h"

namespace nanocarbon {

//! Watched atoms of one type, on all ranks.
struct WatchedType {
  int type;                   //!< from 1
  double lightest, heaviest;  //!< mass units, g/mol
};

//! \brief The types that watched atoms are of, with their masses. Collective.
//! \param types of this rank's watched atoms, and their masses
std::vector<WatchedType> watched_types(MPI_Comm world, int all_types, std::span<const int> types,
                                       std::span<const double> masses);

//! What the user or the pair style says of each type, from 1; nothing for those of which it says nothing.
struct SaidElements {
  std::vector<std::optional<Element>> of_type;
  std::string by;  //!< "element" or "pair_coeff", for messages; empty where nothing was said
};

struct TypeElements {
  std::vector<Element> of_type;  //!< from 1; carbon for types that no watched atom is of
  std::string summary;           //!< "type 1 (mass 12.011) is carbon, type 2 (mass 1.008) is hydrogen"
  std::string problem;           //!< what is wrong and what to do; empty where each type has an element
};

//! \brief The elements of watched types: as said, else by mass (core/periodic_table.h).
TypeElements type_elements(int all_types, const std::vector<WatchedType>& types, const SaidElements& said);

}  // namespace nanocarbon
