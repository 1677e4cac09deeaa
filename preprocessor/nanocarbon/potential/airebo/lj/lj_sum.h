// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <string_view>

#include "nanocarbon/potential/airebo/lj/lj_half_list.h"
#include "nanocarbon/potential/airebo/lj/lj_own_list.h"

namespace nanocarbon::airebo {

//! Does task(0) ... task(count - 1), each once, in any order and perhaps at the same time.
using LjParallel = std::function<void(std::size_t count, const std::function<void(std::size_t)>& task)>;

struct LjSumOptions {
  std::string_view instructions = {};  //!< "generic", "avx2" or "avx512"; empty for the best that runs here
  double inner_margin = 0.4;           //!< of the rows that are evaluated, Angstrom
  LjOwnListOptions own_lists;
  LjParallel parallel = {};  //!< empty: one after the other
};

struct LjResult {
  double energy = 0.0;         //!< eV; 0 unless asked for
  Mat3 virial = Mat3::Zero();  //!< sum of r (x) f over pairs, eV; 0 unless asked for
};

struct LjWanted {
  bool energy = true;
  bool virial = true;
};

//! \brief The sum of V(r) slw(r) over all pairs that are not excluded.
//! \details This is AIREBO's E_LJ as if every pair had C_ij = 1 and S_b = 1. How to use it: make lists, by
//! one of the two ways; then, for each set of positions, place(), which says whether the lists are still valid,
//! and evaluate(). Results do not depend on LjSumOptions::parallel, to the last bit.
class LjSum {
 public:
  //! \throw UserError (usage) where this processor or build does not have the instructions
  explicit LjSum(const LjParameters& parameters, const LjSumOptions& options = {});

  //! Takes a half list; see lists_from_half_list().
  void use_half_list(const LjHalfList& half, const double* positions, std::span<const Element> elements,
                     std::span<const std::array<std::uint32_t, 2>> exclusions);

  //! Finds the pairs itself; see find_lists().
  void find_pairs(std::span<const Vec3> positions, std::span<const Element> elements, const Cell* cell,
                  const NeighbourList& exclusions);

  //! \brief Sets new positions of the atoms that the lists were made for.
  //! \param positions x, y, z of each atom, Angstrom
  //! \param cell as for find_pairs(), but it may have changed its shape; nullptr for a half list
  //! \return whether the lists are still valid: if not, make new ones and place again
  //! \details Lists from a half list are assumed to be valid.
  bool place(const double* positions, const Cell* cell = nullptr);

  //! \brief Adds forces (eV/Angstrom) to those of all atoms in the lists, ghosts included.
  //! \param forces x, y, z of each atom
  //! \pre place() returned true
  LjResult evaluate(double* forces, LjWanted wanted = {});

  //! \brief Adds each atom's share: half of each of its pairs. Slow.
  //! \param energies eV, one for each atom; empty if not wanted
  //! \param virials eV, r (x) f; empty if not wanted
  //! \pre place() returned true
  void add_shares(std::span<double> energies, std::span<Mat3> virials) const;

  const LjLists& lists() const { return lists_; }
  const LjKernel& kernel() const { return *kernel_; }
  //! How often rows were searched, in all chunks together.
  std::size_t searches() const { return searches_; }

 private:
  void for_all(std::size_t count, const std::function<void(std::size_t)>& task) const;

  LjParameters parameters_;
  LjSumOptions options_;
  const LjKernel* kernel_;
  LjConstants constants_;
  LjLists lists_;
  std::vector<LjResult> chunk_results_;
  std::size_t searches_ = 0;
};

}  // namespace nanocarbon::airebo
