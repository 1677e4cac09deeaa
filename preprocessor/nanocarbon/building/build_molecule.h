// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

#include "nanocarbon/building/annealing_record.h"
#include "nanocarbon/building/likeness.h"
#include "nanocarbon/building/potential_choice.h"
#include "nanocarbon/building/size_request.h"
#include "nanocarbon/core/quality.h"
#include "nanocarbon/minimisation/cell_minimum.h"
#include "nanocarbon/minimisation/certificate.h"
#include "nanocarbon/molecule/molecule.h"
#include "nanocarbon/remeshing/thesis/thesis_recipe.h"

namespace nanocarbon::building {

//! How a surface becomes a molecule.
enum class Recipe {
  annealed,     //!< crystallised triangulation, dual relaxed, defects annealed, energy minimised
  thesis,       //!< adaptive remeshing, then the dual as it is
  pecanha2013,  //!< its forerunners; see thesis_options.h
  hauck2014,
  hauck2015
};

//! The recipe's name on the command line and in reports.
std::string_view name(Recipe recipe);

struct BuildOptions {
  SizeRequest size = AtomPerTriangle{};
  Recipe recipe = Recipe::annealed;
  PotentialChoice potential =
      PotentialChoice::rebo2;  //!< of the last minimisation, the checks, the certificate

  //! \name Of the annealed recipe
  //! @{
  double bond_length = 1.42;  //!< used to compute the size, Angstrom
  Quality quality = Quality::good;
  std::optional<double> tether;   //!< to the surface while annealing, eV/Angstrom^2; nothing: tether_of()
  double force_tolerance = 1e-3;  //!< largest force left, eV/Angstrom
  //! Prove that the molecule is at a minimum (certificate.h); only with potentials of bonds alone.
  bool certify = false;
  //! Strains of a periodic cell that are freed in the end; nothing: relaxed_strains()
  std::optional<minimisation::CellRelaxation> relax_cell;
  //! @}
  //! Leave out pieces of the surface that have no room for a cage; they are an error otherwise.
  bool drop_specks = false;
  //! Go on where the shape asks for more atoms, keep a molecule that does not hold or has lost the shape.
  //! (The program also takes one that is not shown to be at a minimum.)
  bool force = false;
  //! Of the annealed recipe: instead of the size, the smallest number of atoms of two digits whose features are
  //! large enough and of which a molecule holds.
  bool fit = false;
  //! Look for a size that would do where one does not.
  bool advise = true;
  thesis::ThesisOptions thesis;  //!< of the thesis and its forerunners
  bool relax = false;  //!< the dual of theirs, to a minimum of REBO2 with the bonds it has (dual_minimum.h)

  unsigned threads = 1;
  std::uint64_t seed = 1;
  //! Called now and then with what is being done and how much of it, 0 to 1.
  std::function<void(std::string_view stage, double fraction)> progress;
  //! Called with what is known before more is found out: why a size is refused, while the next is sought.
  std::function<void(const std::string& fact)> tell;
};

//! The tether that annealing uses, eV/Angstrom^2: the one asked for, or what suits the size asked for.
double tether_of(const BuildOptions& options);

//! \brief The strains of the cell that are freed: those asked for, or what suits the size asked for.
//! \details A number of atoms leaves the cell's size free; a length or scale means it. Sheets alone would lose
//! their ripples by it.
minimisation::CellRelaxation relaxed_strains(const BuildOptions& options, const TriangleMesh& surface);

//! Wall-clock seconds of each stage.
struct BuildSeconds {
  double remeshing = 0.0;
  double molecule = 0.0;  //!< dual and relaxation
  double total = 0.0;
};

struct BuildResult {
  SizedSurface surface;
  std::size_t specks_dropped = 0;
  TriangleMesh triangulation;  //!< Angstrom; the molecule is its dual
  Molecule molecule;
  std::optional<RestingState> rest;                      //!< of the annealed recipe, as are the next three
  std::optional<AnnealingRecord> annealed;               //!< what annealing did
  std::optional<Likeness> likeness;                      //!< to the surface
  std::optional<minimisation::Certificate> certificate;  //!< where asked for
  std::optional<thesis::ThesisRecord> thesis;            //!< what remeshing by the thesis did
  BuildSeconds seconds;
};

//! \brief From a surface to a molecule of carbon atoms.
//! \param surface a sound 2-manifold, oriented, mesh units (see load_surface())
//! \throw UserError (size, unsuitable) as sized_surface(); (size) where features are too small, and with what would do; (failed) where the molecule's topology is not the
//! surface's, REBO2 would bind other atoms than the molecule does, or the thesis's method lost the shape
BuildResult build_molecule(const TriangleMesh& surface, const BuildOptions& options);

}  // namespace nanocarbon::building
