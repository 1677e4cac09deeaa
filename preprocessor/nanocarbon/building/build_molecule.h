// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

#include "nanocarbon/building/annealing_record.h"
#include "nanocarbon/building/boundary_facts.h"
#include "nanocarbon/building/likeness.h"
#include "nanocarbon/building/potential_choice.h"
#include "nanocarbon/building/size_request.h"
#include "nanocarbon/core/quality.h"
#include "nanocarbon/core/stage_clock.h"
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
      PotentialChoice::rebo2;  //!< of the final minimisation, the checks and the certificate

  //! \name Of the annealed recipe
  //! @{
  double bond_length = 1.42;  //!< used to compute the size, Angstrom
  Quality quality = Quality::good;
  std::optional<double> tether;   //!< to the surface while annealing, eV/Angstrom^2; nothing: tether_of()
  double force_tolerance = 1e-3;  //!< largest force left, eV/Angstrom
  Boundary boundary = Boundary::hydrogen;  //!< of the annealed recipe
  //! Prove that the molecule is at a minimum (certificate.h); only with potentials of bonds alone.
  bool certify = false;
  //! Strains of a periodic cell that the final minimisation may change; nothing: relaxed_strains()
  std::optional<minimisation::CellRelaxation> relax_cell;
  //! @}
  //! Leave out components of the surface that are too small for a cage; otherwise they are an error.
  bool drop_specks = false;
  //! Build even if the shape needs more atoms; keep a molecule that does not hold or has lost the shape. (The program
  //! also accepts one that is not shown to be at a minimum.)
  bool force = false;
  //! Of the annealed recipe: ignore the size, and build with the smallest number of atoms, to two digits, for which all
  //! features are large enough and a molecule holds that is not rounded off (Likeness::rounded()), up to largest_fit.
  bool fit = false;
  //! If a size does not work, look for one that does.
  bool advise = true;
  thesis::ThesisOptions thesis;  //!< of the thesis and its forerunners
  bool relax = false;            //!< their dual, to a minimum of REBO2 with its own bonds (dual_minimum.h)

  unsigned threads = 1;
  StageClock* clock = nullptr;  //!< that times the stages; may be null
  std::uint64_t seed = 1;
  //! Called now and then with what is being done and how much of it, 0 to 1.
  std::function<void(std::string_view stage, double fraction)> progress;
  //! Called with facts on the way: why a size is refused, before the search for another begins.
  std::function<void(const std::string& fact)> tell;
};

//! The largest molecule that a build without a number of atoms (BuildOptions::fit) goes on to, since larger ones take minutes.
inline constexpr std::size_t largest_fit = 20'000;

//! The tether that annealing uses, eV/Angstrom^2: the one asked for, or the default for the kind of size asked for.
double tether_of(const BuildOptions& options);

//! \brief The strains of the cell that may change: those asked for, or the default for the kind of size asked for.
//! \details With a number of atoms the cell's size is free; a length or scale prescribes it. It is also kept if all
//! components are sheets, which would lose their ripples otherwise.
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
  std::optional<RestingState> rest;                      //!< of the annealed recipe, as are the next four
  std::optional<AnnealingRecord> annealed;               //!< what annealing did
  std::optional<Likeness> likeness;                      //!< to the surface
  std::optional<BoundaryFacts> boundary;                 //!< what the boundary is made of
  std::optional<minimisation::Certificate> certificate;  //!< where asked for
  std::optional<thesis::ThesisRecord> thesis;            //!< what remeshing by the thesis did
  BuildSeconds seconds;
};

//! \brief From a surface to a molecule of carbon atoms, with hydrogen at boundaries by the annealed recipe.
//! \param surface a sound 2-manifold, oriented, mesh units (see load_surface())
//! \throw UserError (size, unsuitable) as sized_surface(); (size) if features are too small, with a size that works;
//! (failed) if the molecule's topology is not the surface's, the potential would bind other atoms than the molecule
//! does, or the shape was lost
BuildResult build_molecule(const TriangleMesh& surface, const BuildOptions& options);

}  // namespace nanocarbon::building
