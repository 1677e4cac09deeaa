// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "nanocarbon/core/cell.h"
#include "nanocarbon/core/element.h"
#include "nanocarbon/core/vec3.h"
#include "nanocarbon/potential/potential.h"
#include "nanocarbon/potential/rebo2/energy_parts.h"
#include "nanocarbon/potential/rebo2/parameters.h"

namespace nanocarbon::rebo2 {

//! The energy of a structure by REBO2, its parts and its derivatives.
struct Rebo2Result : potential::Evaluation {
  EnergyParts parts;
};

//! \brief REBO2 for carbon and hydrogen.
//! \details Brenner et al. 2002 as LAMMPS's `pair_style rebo` evaluates it. Made for repeated calls: lists
//! and arrays are kept, and near pairs are searched for again only after two atoms near each other may have come
//! closer by the skin.
class Rebo2 final : public potential::Potential {
 public:
  //! \param instructions of the fast evaluation: "generic", "avx2" or "avx512"; empty for the best that runs
  //! here
  //! \throw UserError (usage) if this processor or build does not have them
  explicit Rebo2(const Rebo2Parameters& parameters = rebo2_parameters(), std::string_view instructions = {});
  ~Rebo2() override;
  Rebo2(Rebo2&&) noexcept;
  Rebo2& operator=(Rebo2&&) noexcept;

  std::string_view name() const override { return "rebo2"; }
  const Rebo2Result& evaluate(std::span<const Vec3> positions, std::span<const Element> elements,
                              const Cell* cell = nullptr,
                              const potential::EvaluationOptions& options = {}) override;
  std::vector<potential::EnergyPart> parts() const override;
  const BondCutoffs& bond_cutoffs() const override;
  double graphene_energy() const override { return rebo2::graphene_energy; }
  double hydrogen_energy() const override { return rebo2::hydrogen_energy; }

  //! Number of atoms that the last evaluation left to the general terms; all of them if only those were asked for.
  std::size_t general_atoms() const;
  //! How often near pairs have been searched for.
  std::size_t list_builds() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace nanocarbon::rebo2
