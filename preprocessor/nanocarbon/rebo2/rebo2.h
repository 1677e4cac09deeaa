#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "nanocarbon/core/cell.h"
#include "nanocarbon/core/element.h"
#include "nanocarbon/core/vec3.h"
#include "nanocarbon/rebo2/energy_parts.h"
#include "nanocarbon/rebo2/parameters.h"

namespace nanocarbon {

//! What an evaluation shall do.
struct Rebo2Options {
  bool general_only = false;   //!< never the fast evaluation of sp2 carbon (for comparison)
  bool atom_energies = false;  //!< also the energy of each atom
  bool atom_virials = false;   //!< also the virial of each atom; implies general_only
};

//! The energy of a structure and its derivatives.
struct Rebo2Result {
  double energy = 0.0;  //!< eV
  EnergyParts parts;
  std::vector<Vec3> forces;  //!< eV/Angstrom
  //! Sum of r (x) f over pairs, eV. Divided by the volume it is the potential part of LAMMPS's pressure
  //! tensor.
  Mat3 virial = Mat3::Zero();
  std::vector<double> atom_energies;  //!< eV; bonds are shared equally by their ends
  std::vector<Mat3> atom_virials;     //!< eV; as LAMMPS shares them; minus LAMMPS's stress times volume
};

//! \brief REBO2 for carbon and hydrogen.
//! \details Brenner et al. 2002 as LAMMPS's `pair_style rebo` evaluates it. Made to be called again and
//! again: lists and arrays are kept, and near pairs are looked for anew only after an atom has moved by half
//! the skin.
class Rebo2 {
 public:
  //! \param instructions of the fast evaluation: "generic", "avx2" or "avx512"; empty for the best that runs
  //! here \throw UserError (usage) where this processor or build does not have them
  explicit Rebo2(const Rebo2Parameters& parameters = rebo2_parameters(), std::string_view instructions = {});
  ~Rebo2();
  Rebo2(Rebo2&&) noexcept;
  Rebo2& operator=(Rebo2&&) noexcept;

  //! \param positions Angstrom, finite; \param elements one for each position
  //! \param cell nullptr for a molecule in free space; may be as small as one atom
  //! \return valid until the next call
  const Rebo2Result& evaluate(std::span<const Vec3> positions, std::span<const Element> elements,
                              const Cell* cell = nullptr, const Rebo2Options& options = {});

  //! Atoms that the last evaluation left to the general terms; all of them where it was asked for no others.
  std::size_t general_atoms() const;
  //! How often near pairs were looked for so far.
  std::size_t list_builds() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace nanocarbon
