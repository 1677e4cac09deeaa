#pragma once

namespace nanocarbon {

//! Mean distance of the atoms to the surface, Angstrom, that a molecule may have for nothing: less under a
//! tether stiffer than the default. \param tether eV/Angstrom^2
double distance_for_nothing(double tether);

//! \brief What a molecule costs, to choose between those from several starts: its energy, and a price for
//! being farther from the surface than that, higher under a stiff tether. eV for each atom. \param energy eV
//! for each atom \param mean_distance of the atoms to the surface, Angstrom
double cost_of(double energy, double mean_distance, double tether);

}  // namespace nanocarbon
