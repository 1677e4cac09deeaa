// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>

#include "nanocarbon/potential/airebo/fast_evaluation.h"
#include "nanocarbon/potential/airebo/general_evaluation.h"
#include "nanocarbon/potential/airebo/lj/lj_sum.h"
#include "pair_bond_order.h"

namespace nanocarbon {

//! \brief pair_style airebo/opt: what pair_style airebo computes, by room airebo.
//! \details Takes the arguments of airebo and gives its results, so that `suffix opt` speeds up a script as it
//! is. From LAMMPS it asks for a list that is only as long as a bond and the skin, and for a half list of the
//! whole cut-off.
class PairAireboOpt : public PairBondOrder {
 public:
  explicit PairAireboOpt(LAMMPS_NS::LAMMPS* lammps)
      : PairAireboOpt(lammps, "airebo/opt", airebo::LjForm::lennard_jones) {}

  void compute(int eflag, int vflag) override;
  void settings(int narg, char** arg) override;
  void init_style() override;
  void init_list(int id, LAMMPS_NS::NeighList* list) override;
  double init_one(int i, int j) override;
  double memory_usage() override;

 protected:
  PairAireboOpt(LAMMPS_NS::LAMMPS* lammps, std::string style, airebo::LjForm form);

 private:
  //! Parameters and arguments with what evaluates them.
  struct Evaluation {
    Evaluation(const airebo::AireboParameters& parameters, const airebo::AireboTerms& terms)
        : model(parameters, terms), fast(model), plain(model.lj) {}
    airebo::AireboModel model;
    airebo::FastEvaluation fast;
    airebo::LjSum plain;
    airebo::AireboWorkspace workspace;
  };

  const std::array<rebo2::PairParameters, 3>& take_file(const char* file) override;
  void take_lists();
  //! Rows of own atoms in the half list with the pairs up to a distance (Angstrom).
  potential::NearPairs half_pairs(double cutoff) const;
  airebo::AireboEnergyParts evaluate_in_general();
  airebo::AireboEnergyParts evaluate_fast(bool energy);

  std::string style_;
  airebo::LjForm form_;
  airebo::AireboParameters parameters_;
  airebo::AireboTerms terms_;
  std::unique_ptr<Evaluation> evaluation_;
  LAMMPS_NS::NeighList* half_list_ = nullptr;
};

//! pair_style airebo/morse/opt: AIREBO-M, as pair_style airebo/morse computes it.
class PairAireboMorseOpt : public PairAireboOpt {
 public:
  explicit PairAireboMorseOpt(LAMMPS_NS::LAMMPS* lammps)
      : PairAireboOpt(lammps, "airebo/morse/opt", airebo::LjForm::morse) {}
};

}  // namespace nanocarbon
