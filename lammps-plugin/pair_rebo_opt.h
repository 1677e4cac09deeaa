// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "nanocarbon/potential/near_pairs.h"
#include "nanocarbon/potential/rebo2/mixed_evaluation.h"
#include "pair.h"

namespace nanocarbon {

//! \brief pair_style rebo/opt: what pair_style rebo computes, by room rebo2.
//! \details Takes the arguments of rebo and gives its results, so that `suffix opt` speeds up a script as it
//! is. From LAMMPS it asks for a list that is only as long as a bond and the skin. Out of that it keeps the
//! pairs near enough to become bonds soon, and looks for them anew when an atom has moved by half of that
//! margin.
class PairReboOpt : public LAMMPS_NS::Pair {
 public:
  explicit PairReboOpt(LAMMPS_NS::LAMMPS* lmp);
  ~PairReboOpt() override;

  void compute(int eflag, int vflag) override;
  void settings(int narg, char** arg) override;
  void coeff(int narg, char** arg) override;
  void init_style() override;
  double init_one(int i, int j) override;
  double memory_usage() override;

 private:
  void allocate();
  rebo2::Rebo2Parameters read_parameters(const char* file) const;
  bool near_pairs_are_good() const;
  void find_near_pairs();
  void refuse_missing_neighbours() const;
  void add_virials();

  std::vector<int> element_of_type_;  // Element, or -1 for NULL
  rebo2::Rebo2Parameters parameters_;
  double longest_bond_ = 0.0;  // Angstrom
  std::unique_ptr<rebo2::MixedEvaluation> evaluation_;

  potential::NearPairs near_;
  std::vector<Element> elements_;         // own and ghost atoms
  std::vector<double> listed_positions_;  // where these were when near_ was made
  std::vector<potential::Virial> virials_;
};

}  // namespace nanocarbon
