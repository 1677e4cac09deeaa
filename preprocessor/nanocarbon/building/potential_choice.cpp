// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/potential_choice.h"

#include "nanocarbon/potential/airebo/airebo.h"
#include "nanocarbon/potential/airebo/parameter_file.h"
#include "nanocarbon/potential/rebo2/parameter_file.h"
#include "nanocarbon/potential/rebo2/rebo2.h"

namespace nanocarbon::building {

std::string_view name(PotentialChoice choice) {
  switch (choice) {
    case PotentialChoice::rebo2:
      return "rebo2";
    case PotentialChoice::airebo:
      return "airebo";
    case PotentialChoice::airebo_m:
      return "airebo-m";
  }
  return "";
}

std::unique_ptr<potential::Potential> make_potential(PotentialChoice choice) {
  switch (choice) {
    case PotentialChoice::airebo:
      return std::make_unique<airebo::Airebo>(airebo::airebo_parameters());
    case PotentialChoice::airebo_m:
      return std::make_unique<airebo::Airebo>(airebo::airebo_m_parameters());
    case PotentialChoice::rebo2:
      break;
  }
  return std::make_unique<rebo2::Rebo2>();
}

std::unique_ptr<potential::Potential> make_potential(PotentialChoice choice,
                                                     const std::filesystem::path& parameters) {
  switch (choice) {
    case PotentialChoice::airebo:
      return std::make_unique<airebo::Airebo>(
          airebo::read_airebo_parameters(parameters, airebo::LjForm::lennard_jones));
    case PotentialChoice::airebo_m:
      return std::make_unique<airebo::Airebo>(
          airebo::read_airebo_parameters(parameters, airebo::LjForm::morse));
    case PotentialChoice::rebo2:
      break;
  }
  return std::make_unique<rebo2::Rebo2>(rebo2::read_rebo2_parameters(parameters));
}

}  // namespace nanocarbon::building
