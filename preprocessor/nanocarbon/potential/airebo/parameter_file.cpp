// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/airebo/parameter_file.h"

#include "nanocarbon/potential/rebo2/potential_file.h"

namespace nanocarbon::airebo {

AireboParameters read_airebo_parameters(const std::filesystem::path& path, LjForm form) {
  rebo2::PotentialFile file(path);
  if (form == LjForm::morse)
    file.require_header("AIREBO-M", "CH.airebo-m");
  else
    file.require_header("AIREBO", "CH.airebo");
  AireboParameters parameters = form == LjForm::morse ? airebo_m_parameters() : airebo_parameters();
  rebo2::read_bond_parameters(file, parameters.rebo);
  const auto for_pairs = [&](const char* name, double LongRangeParameters::*member) {
    for (LongRangeParameters& pair : parameters.long_range) pair.*member = file.labelled(name);
  };
  for_pairs("rcLJmin", &LongRangeParameters::length_switch_begin);
  for_pairs("rcLJmax", &LongRangeParameters::length_switch_end);
  for_pairs("bLJmin", &LongRangeParameters::order_switch_begin);
  for_pairs("bLJmax", &LongRangeParameters::order_switch_end);
  const auto for_potentials = [&](const char* name, double LjPairParameters::*member) {
    for (LongRangeParameters& pair : parameters.long_range) pair.potential.*member = file.labelled(name);
  };
  for_potentials("epsilon", &LjPairParameters::epsilon);
  for_potentials("sigma", &LjPairParameters::sigma);
  for (double& barrier : parameters.torsion.barriers) barrier = file.labelled("epsilonT");
  if (form == LjForm::morse) {
    for_potentials("epsilonM", &LjPairParameters::morse_epsilon);
    for_potentials("alphaM", &LjPairParameters::morse_decay);
    for_potentials("reqM", &LjPairParameters::morse_equilibrium);
  }
  rebo2::read_angular_splines(file, parameters.rebo);
  return parameters;
}

}  // namespace nanocarbon::airebo
