// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>

#include "nanocarbon/potential/rebo2/mixed_evaluation.h"
#include "pair_bond_order.h"

namespace nanocarbon {

//! \brief pair_style rebo/opt: what pair_style rebo computes, by room rebo2.
//! \details Takes the arguments of rebo and gives its results, so that `suffix opt` speeds up a script as it
//! is.
class PairReboOpt : public PairBondOrder {
 public:
  explicit PairReboOpt(LAMMPS_NS::LAMMPS* lmp);

  void compute(int eflag, int vflag) override;
  void settings(int narg, char** arg) override;
  void init_style() override;
  double init_one(int i, int j) override;
  double memory_usage() override;

 private:
  const std::array<rebo2::PairParameters, 3>& take_file(const char* file) override;

  rebo2::Rebo2Parameters parameters_;
  std::unique_ptr<rebo2::MixedEvaluation> evaluation_;
};

}  // namespace nanocarbon
