// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "nanocarbon/core/cell.h"
#include "nanocarbon/core/element.h"
#include "nanocarbon/core/vec3.h"
#include "nanocarbon/potential/airebo/energy_parts.h"
#include "nanocarbon/potential/airebo/parameters.h"
#include "nanocarbon/potential/potential.h"

namespace nanocarbon::airebo {

//! The energy of a structure by AIREBO, its parts and its derivatives.
struct AireboResult : potential::Evaluation {
  AireboEnergyParts energy_parts;
};

//! \brief AIREBO or AIREBO-M for carbon and hydrogen.
//! \details As LAMMPS's `pair_style airebo` and `airebo/morse` evaluate it. Made for repeated calls: lists
//! and arrays are kept, and pairs are searched for again only after an atom has moved by half the skin.
class Airebo final : public potential::Potential {
 public:
  //! \param instructions of the plain sum over pairs: "generic", "avx2" or "avx512"; empty for the best that
  //! runs here
  //! \throw UserError (usage) if this processor or build does not have them
  explicit Airebo(const AireboParameters& parameters = airebo_parameters(), const AireboTerms& terms = {},
                  std::string_view instructions = {});
  ~Airebo() override;
  Airebo(Airebo&&) noexcept;
  Airebo& operator=(Airebo&&) noexcept;

  std::string_view name() const override;
  //! \details Energies and virials of single atoms come from the general evaluation, which is slower. They are
  //! shared as in LAMMPS, except for the virial of a path if another is equally good: which atoms get it depends on
  //! the order of neighbours in LAMMPS as well.
  const AireboResult& evaluate(std::span<const Vec3> positions, std::span<const Element> elements,
                               const Cell* cell = nullptr,
                               const potential::EvaluationOptions& options = {}) override;
  std::vector<potential::EnergyPart> parts() const override;
  const BondCutoffs& bond_cutoffs() const override;
  double graphene_energy() const override;
  double hydrogen_energy() const override;
  double unbonded_reach() const override;

  //! Number of atoms whose bonds the last fast evaluation left to the general terms.
  std::size_t general_atoms() const;
  //! Number of terms of E_LJ that it evaluated one by one.
  std::size_t single_terms() const;
  //! How often all pairs have been searched for.
  std::size_t list_builds() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace nanocarbon::airebo
