// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <mpi.h>

#include <string>
#include <type_traits>
#include <vector>

#include "comm.h"
#include "error.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/potential/atom_shares.h"
#include "nanocarbon/potential/near_pairs.h"
#include "nanocarbon/potential/rebo2/mixed_evaluation.h"
#include "nanocarbon/potential/rebo2/parameters.h"
#include "pair.h"

namespace nanocarbon {

//! \brief What the pair styles of bond-order potentials have in common: elements, near pairs, and checks.
//! \details From LAMMPS they ask for a list that is only as long as a bond and the skin. Out of that they keep
//! the pairs near enough to become bonds soon, and look for them anew when an atom has moved by half of that
//! margin.
class PairBondOrder : public LAMMPS_NS::Pair {
 public:
  //! \param style its name, for messages
  PairBondOrder(LAMMPS_NS::LAMMPS* lmp, std::string style);
  ~PairBondOrder() override;

  void coeff(int narg, char** arg) override;
  //! "nanocarbon/elements": an int for each type from 1, of Element, or -1 for NULL. For fix bond/topology.
  void* extract(const char* name, int& dimension) override;

 protected:
  //! Pairs that are further apart than a bond by up to this are kept when they are next looked for, Angstrom.
  double margin = 0.4;
  //! Whether ghosts that are more than two bonds away from own atoms need near pairs.
  bool all_ghosts_have_bonds = true;

  //! Reads the potential file.
  //! \return where bonds end
  virtual const std::array<rebo2::PairParameters, 3>& take_file(const char* file) = 0;
  //! Reads a file on the first rank and gives what it says to all.
  template <class Parameters, class Read>
  Parameters read_for_all(const char* file, Parameters parameters, const Read& read) const;

  //! Checks what init_style() has to check, and asks for the list of near pairs.
  void request_near_list();
  //! How far bonds of two types reach, for init_one().
  void set_bond_cutoff(int i, int j);

  enum class Lists { good, near_changed, all_changed };
  //! \brief Brings near() up to date.
  //! \return all_changed where LAMMPS's lists are new, or atoms have become other elements
  Lists update_near();
  const potential::NearPairs& near() const { return near_; }
  potential::AtomsView atoms() const;
  //! \brief Has all ranks take the same loops of REBO2, by all their atoms. To be called on all ranks after
  //! update_near(); does nothing unless LAMMPS's lists are new.
  void choose_loops(rebo2::MixedEvaluation& evaluation) const;
  std::size_t lists_memory() const;

  Element element(int type) const { return static_cast<Element>(element_of_type_[type]); }
  bool has_element(int type) const { return element_of_type_[type] >= 0; }
  double longest_bond() const { return longest_bond_; }

  //! Empty virials of all atoms, for add_virials().
  potential::Virial* start_virials();
  void add_virials();

 private:
  void allocate();
  [[noreturn]] void stop(const std::string& message) const;
  std::string read_path(const char* file) const;
  void find_near_pairs();
  void add_near_row(int i, const std::vector<char>& is_listed, std::vector<std::uint32_t>& to) const;
  void refuse_missing_neighbours() const;
  bool elements_are_same() const;
  bool moved_far() const;

  std::string style_;
  std::vector<int> element_of_type_;  // Element, or -1 for NULL
  std::array<double, 3> bond_cutoff_ = {};
  double longest_bond_ = 0.0;  // Angstrom

  potential::NearPairs near_;
  std::vector<Element> elements_;         // own and ghost atoms
  std::vector<double> listed_positions_;  // where these were when near_ was made
  double listed_margin_ = 0.0;
  std::vector<potential::Virial> virials_;
};

template <class Parameters, class Read>
Parameters PairBondOrder::read_for_all(const char* file, Parameters parameters, const Read& read) const {
  static_assert(std::is_trivially_copyable_v<Parameters>);
  if (comm->me == 0) {
    try {
      parameters = read(read_path(file));
    } catch (const UserError& failure) {
      error->one(FLERR, "pair_coeff " + style_ + ": " + failure.what());
    }
  }
  MPI_Bcast(&parameters, sizeof parameters, MPI_BYTE, 0, world);
  return parameters;
}

}  // namespace nanocarbon
