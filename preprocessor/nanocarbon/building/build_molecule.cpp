// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/build_molecule.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "nanocarbon/building/anneal_recipe.h"
#include "nanocarbon/building/dual_minimum.h"
#include "nanocarbon/building/failed_molecule.h"
#include "nanocarbon/building/size_advice.h"
#include "nanocarbon/building/stopwatch.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/mesh/periodic_mesh.h"
#include "nanocarbon/mesh/repair/drop_specks.h"
#include "nanocarbon/molecule/dual.h"
#include "nanocarbon/molecule/hydrogens.h"
#include "nanocarbon/topology/connected_components.h"

namespace nanocarbon::building {
namespace {

// Atoms, bonds and rings are faces, edges and vertices; what a boundary lacks of them adds up to nothing.
std::int64_t euler_characteristic(const Molecule& molecule) {
  return static_cast<std::int64_t>(molecule.size()) - static_cast<std::int64_t>(molecule.bonds.size()) +
         static_cast<std::int64_t>(molecule.rings.size());
}

void require_same_topology(const mesh::MeshTopology& surface, const BuildResult& result) {
  const mesh::MeshTopology t = mesh::mesh_topology(result.triangulation);
  const std::size_t components =
      topology::connected_components(result.molecule.size(), result.molecule.bonds).count;
  const std::int64_t euler = euler_characteristic(result.molecule);
  if (surface.components != components || surface.euler_characteristic != euler ||
      surface.components != t.components || surface.euler_characteristic != t.euler_characteristic ||
      surface.boundary_loops != t.boundary_loops || surface.genus != t.genus)
    throw UserError(
        Failure::failed,
        fmt::format("the molecule has {} pieces, {} boundary loops and Euler characteristic {}, the surface "
                    "{}, {} and {}; please report this",
                    components, t.boundary_loops, euler, surface.components, surface.boundary_loops,
                    surface.euler_characteristic));
}

// Parts that are thinner than an edge are pulled together by the low-pass filter and collapse.
void require_shape(std::size_t atoms, std::size_t room) {
  constexpr double smallest_part =
      0.5;  // replacing the projection mesh costs some of the area, never this much
  if (static_cast<double>(atoms) >= smallest_part * static_cast<double>(room)) return;
  throw UserError(Failure::failed,
                  fmt::format("the shape was lost: {} atoms are left where there is room for {}; ask for "
                              "more atoms, try --projection-interval 0, or accept it as it is with --force",
                              atoms, room));
}

// The surface of the size, and in the cell, that the molecule has in the end.
SizedSurface fitted(SizedSurface surface, double growth, const Mat3& deformation = Mat3::Identity()) {
  surface.scale *= growth;
  rescale(surface.mesh, growth);
  if (surface.mesh.space.periodic()) {
    mesh::deform(surface.mesh, deformation);
    surface.scale *= std::cbrt(deformation.determinant());
  }
  return surface;
}

BuildResult build_by_thesis(SizedSurface surface, const BuildOptions& options) {
  Stopwatch stage;
  thesis::ThesisOptions thesis = options.thesis;
  thesis.threads = options.threads;
  // A number of atoms is met by adjusting the scale on the way; a length or a scale is the user's own.
  if (std::holds_alternative<AtomCount>(options.size) ||
      std::holds_alternative<AtomPerTriangle>(options.size))
    thesis.atoms = surface.atoms;
  if (options.progress)
    thesis.progress = [&](const thesis::ThesisProgress& p) {
      options.progress("remeshing", static_cast<double>(p.iteration) / p.max_iterations);
    };
  const auto timed = StageClock::stage(options.clock, "thesis");
  thesis::ThesisResult remeshed = thesis::remesh_by_thesis(surface.mesh, thesis);
  BuildResult result;
  result.surface = fitted(std::move(surface), remeshed.scale);
  result.seconds.remeshing = stage.lap();
  if (!options.force) require_shape(remeshed.mesh.triangles.size(), result.surface.atoms);
  result.molecule = molecule::dual(remeshed.mesh);
  if (options.relax) {
    if (options.progress) options.progress("relaxing the dual", 0.0);
    const auto relaxed = minimise_dual(result.molecule, *make_potential(options.potential),
                                       annealing::TetherSurface(result.surface.mesh, 1));
    if (!relaxed.intact && !options.force)
      throw UserError(Failure::failed,
                      "the dual cannot be relaxed with its own bonds: the potential would bind other atoms; "
                      "use the default recipe, or accept the molecule as it is with --force");
  }
  result.triangulation = std::move(remeshed.mesh);
  result.thesis = std::move(remeshed.record);
  result.seconds.molecule = stage.lap();
  return result;
}

void require_room_for_features(const SizedSurface& surface, const BuildOptions& options) {
  const auto timed = StageClock::stage(options.clock, "features");
  const features::FeatureReport features = features::check_features(surface.mesh, {}, options.threads);
  if (features.ok()) return;
  const features::FeatureProblem& worst = features.problems.front();
  const Vec3 where = worst.where / surface.scale;
  std::string reason = fmt::format(
      "with {} atoms the shape is too small in {} place(s): a {} of {:.2f} A at ({:.4g}, {:.4g}, {:.4g}) in "
      "the mesh needs {:.2f} A",
      surface.atoms, features.problems.size(), name(worst.kind), worst.size, where.x(), where.y(), where.z(),
      worst.needed);
  double widest_hole = 0;
  std::size_t holes = 0;
  for (const features::FeatureProblem& problem : features.problems)
    if (problem.kind == features::FeatureKind::small_hole) {
      widest_hole = std::max(widest_hole, problem.size);
      ++holes;
    }
  if (worst.kind == features::FeatureKind::small_hole)
    reason += fmt::format(" (--close-holes {:.3g} would close {})", 1.1 * widest_hole / surface.scale,
                          holes == 1 ? "it" : fmt::format("the {} that are too small", holes));
  throw TooFewAtoms(Failure::size, reason, features);
}

void require_rings_of_carbon(const Molecule& molecule) {
  std::size_t wrong = 0;
  for (std::size_t r = 0; r < molecule.rings.size(); ++r)
    wrong += molecule.rings[r].size() < 5 || molecule.rings[r].size() > 8;
  if (wrong > 0)
    throw TooFewAtoms(
        Failure::failed,
        fmt::format(
            "{} ring(s) have fewer than 5 or more than 8 atoms, because parts of the shape are too narrow",
            wrong));
}

void require_bonds_that_hold(bool intact, const Molecule& molecule, const SizedSurface& surface) {
  if (!intact) throw TooFewAtoms(Failure::failed, describe_failure(molecule, surface));
}

// A size that is looked for is to have the shape; where a number was asked for, a rounded one is warned of.
void require_likeness(const Likeness& l, bool looking_for_a_size) {
  if (l.rounded() && looking_for_a_size)
    throw TooFewAtoms(Failure::failed, "the molecule is rounded off: " + l.distance_told());
  if (!l.far() && !l.strained()) return;
  const std::string what = l.far() ? l.distance_told()
                                   : fmt::format(
                                         "its energy is {:.0f} meV per atom above graphene, {:.1f} times the "
                                         "{:.0f} that the shape's curvature and boundary cost",
                                         1e3 * l.energy, l.energy_share, 1e3 * l.expected_energy);
  throw TooFewAtoms(Failure::failed, "the molecule does not have the shape: " + what);
}

std::vector<int> ranks_of(const TriangleMesh& surface) {
  return mesh::wrapping_ranks(surface, mesh::mesh_topology(surface));
}

// Vertices must not meet through two images, and contacts must be unique.
void require_wide_cell(const SizedSurface& surface) {
  constexpr double least_width = 9.0;  // Angstrom
  const double width = surface.mesh.space.least_width();
  if (width >= least_width) return;
  const double grown = least_width / width;
  throw UserError(
      Failure::size,
      fmt::format("the cell is {:.3g} A wide at the size asked for, but needs {:.2g} A: ask for --atoms {} "
                  "or more, or treat several cells as one with --cells 2",
                  width, least_width,
                  static_cast<std::size_t>(std::ceil(grown * grown * static_cast<double>(surface.atoms)))));
}

// A closed molecule cannot grow without more atoms, but an open one can become a shallower piece of a larger shape.
bool may_open_out(const TriangleMesh& surface) {
  return !surface.space.periodic() && !mesh::mesh_topology(surface).closed();
}

AnnealOptions annealing_options(const BuildOptions& options, const TriangleMesh& surface,
                                const potential::Potential& potential, ThreadTeam& team) {
  AnnealOptions annealing{.quality = options.quality,
                          .tether = tether_of(options),
                          .force_tolerance = options.force_tolerance,
                          .seed = options.seed,
                          .running = {&team, options.clock},
                          .keep_size = keeps_size(options.size) || may_open_out(surface),
                          .relax_cell = relaxed_strains(options, surface),
                          .hydrogen = options.boundary == Boundary::hydrogen,
                          .progress = options.progress};
  if (potential.unbonded_reach() > 0) annealing.steric_reach = steric_reach_of_layers;
  if (surface.space.periodic()) {
    const std::vector<int> ranks = ranks_of(surface);
    if (*std::min_element(ranks.begin(), ranks.end()) == 3) annealing.largest_ring = 8;
  }
  return annealing;
}

AnnealResult annealed(const SizedSurface& surface, potential::Potential& potential,
                      const BuildOptions& options) {
  ThreadTeam team(std::max(1u, options.threads));
  try {
    return anneal(surface.mesh, surface.atoms, potential,
                  annealing_options(options, surface.mesh, potential, team));
  } catch (const UserError& error) {
    if (error.failure() == Failure::size) throw TooFewAtoms(error.failure(), error.what());
    throw;
  }
}

BuildResult build_by_annealing(SizedSurface surface, const BuildOptions& options) {
  Stopwatch stage;
  if (!options.force) require_room_for_features(surface, options);
  const std::unique_ptr<potential::Potential> potential = make_potential(options.potential);
  if (options.certify && surface.mesh.space.periodic())
    throw UserError(Failure::usage, "--certify does not work in periodic cells yet; leave it out");
  AnnealResult made = annealed(surface, *potential, options);
  Molecule molecule = std::move(made.minimum.molecule);
  surface = fitted(std::move(surface), made.minimum.growth, made.minimum.deformation);
  RestingState rest = made.minimum.rest;
  if (!options.force) {
    require_bonds_that_hold(rest.intact, molecule, surface);
    require_rings_of_carbon(molecule);
  }
  std::optional<minimisation::Certificate> certificate;
  if (options.certify) {
    if (options.progress) options.progress("certifying", 0.0);
    const auto timed = StageClock::stage(options.clock, "certificate");
    // Goes on to the minimum, which may be far from where annealing was asked to stop.
    certificate = minimisation::certify(
        molecule, *potential,
        {.force_tolerance = std::min(minimisation::certified_force, options.force_tolerance)});
    rest =
        resting_state(molecule, *potential, certificate->energy, certificate->max_force, certificate->intact);
    if (!options.force) require_bonds_that_hold(rest.intact, molecule, surface);
  }
  const Likeness like =
      likeness(molecule::carbon_skeleton(molecule), surface.mesh, rest.above_graphene, options.boundary);
  if (!options.force) require_likeness(like, options.fit);
  BuildResult result;
  result.triangulation =
      annealing::triangulation_of(made.minimum.network, molecule.positions, Space(molecule.cell));
  result.surface = std::move(surface);
  result.molecule = std::move(molecule);
  result.rest = rest;
  result.annealed = made.record;
  result.likeness = like;
  result.boundary = boundary_facts(result.molecule, *potential);
  result.certificate = std::move(certificate);
  result.seconds.remeshing = made.remeshing_seconds;
  result.seconds.molecule = stage.lap() - made.remeshing_seconds;
  return result;
}

BuildResult build_once(const TriangleMesh& surface, const BuildOptions& options) {
  const bool anneals = options.recipe == Recipe::annealed;
  const double thesis_bond = 0.5 * (options.thesis.min_bond + options.thesis.max_bond);
  Stopwatch whole;
  const auto timed = StageClock::stage(options.clock, "checks");
  std::size_t specks_dropped = 0;
  SizedSurface sized =
      sized_without_specks(surface, options.size, anneals ? options.bond_length : thesis_bond,
                           options.drop_specks, specks_dropped);
  if (surface.space.periodic()) require_wide_cell(sized);
  BuildResult result =
      anneals ? build_by_annealing(std::move(sized), options) : build_by_thesis(std::move(sized), options);
  result.specks_dropped = specks_dropped;
  require_same_topology(mesh::mesh_topology(result.surface.mesh), result);
  result.seconds.total = whole.lap();
  return result;
}

void tell(const BuildOptions& options, const std::string& fact) {
  if (options.tell) options.tell(fact);
}

// What comes of it with a number of atoms, or nothing where it does not hold.
std::optional<BuildResult> built_with(std::size_t atoms, const TriangleMesh& surface, BuildOptions options) {
  options.size = AtomCount{atoms};
  try {
    return build_once(surface, options);
  } catch (const UserError&) {
    return {};
  }
}

SizeSearch search_of(const TriangleMesh& surface, const BuildOptions& options) {
  BuildOptions draft = options;
  draft.quality = Quality::draft;
  draft.certify = draft.force = false;
  draft.tell = nullptr;
  draft.clock = nullptr;
  const auto holds = [&surface, draft](std::size_t atoms) {
    return built_with(atoms, surface, draft).has_value();
  };
  return {surface, options.bond_length, options.threads, holds};
}

std::string advice_after(const TooFewAtoms& error, const TriangleMesh& surface, const BuildOptions& options) {
  std::size_t ignored = 0;
  const SizedSurface sized =
      sized_without_specks(surface, options.size, options.bond_length, options.drop_specks, ignored);
  const double atoms = mesh::area(sized.mesh) / area_per_atom(options.bond_length);
  SizeSearch search = search_of(sized.mesh, options);
  // Drafts are made of what will be built: another scale rounds differently, and may hold where that does not.
  search.holds = search_of(surface, options).holds;
  // What has been tried and failed says more than the check: then larger ones are tried as well.
  const bool was_tried = error.failure() == Failure::failed;
  if (was_tried) search.largest_tried = std::max<std::size_t>(search.largest_tried, 5 * sized.atoms);
  const auto failed = static_cast<double>(sized.atoms);
  // Not longer than the build itself, where that is large: one draft of a few more.
  const double effort = std::max(1.3 * failed, std::clamp(5.0 * failed, 10'000.0, 40'000.0));
  return advice(next_size(search, error.report() ? atoms : 1.1 * atoms,
                          error.report() ? &*error.report() : nullptr, effort));
}

// Room for the smallest cage in each component, if no more.
double smallest_size(const TriangleMesh& surface, bool drop_specks) {
  const std::vector<double> areas = mesh::component_areas(surface);
  double whole = 0, smallest = mesh::area(surface);
  for (const double area : areas) whole += area;
  for (const double area : areas)
    if (!drop_specks || area > 1e-3 * whole) smallest = std::min(smallest, area);
  constexpr double buckminsterfullerene = 60;
  return std::max(buckminsterfullerene, 1.05 * static_cast<double>(smallest_cage) * whole / smallest);
}

BuildResult build_fitting(const TriangleMesh& surface, BuildOptions options) {
  constexpr int most_builds = 5;
  SizeSearch search = search_of(surface, options);
  search.most_tries = 20;                 // a cage of 60 is soon tried
  search.largest_tried = largest_fit;     // a draft is soon made, and a whole build that fails is not
  const double effort = 5 * largest_fit;  // atoms of drafts: about as long as one build of the largest takes
  // Where a draft was asked for, the one that holds is it.
  const bool is_draft = options.quality == Quality::draft && !options.certify && !options.force;
  std::optional<BuildResult> made;
  if (is_draft)
    search.holds = [&](std::size_t atoms) {
      made = built_with(atoms, surface, options);
      return made.has_value();
    };
  double from = smallest_size(surface, options.drop_specks);
  std::string last = "nothing was tried";
  for (int i = 0; i < most_builds; ++i) {
    tell(options, fmt::format("looking for the smallest size from {:.0f} atoms upwards", from));
    const SizeFound found = next_size(search, from, nullptr, effort);
    if (!found.atoms)
      throw UserError(
          Failure::size,
          fmt::format("no number of atoms from {:.0f} on was found that fits the shape: {}; force "
                      "one with --atoms N --force, or change the shape",
                      from, why_none(found)));
    if (*found.atoms > largest_fit)
      throw UserError(
          Failure::size,
          fmt::format(
              "the smallest number of atoms that leaves no feature too small is {}, and --atoms fit builds "
              "up to {}; ask for --atoms {}, or change the shape: thicker walls and wider gaps need fewer",
              *found.atoms, largest_fit, *found.atoms));
    if (made) return *std::move(made);
    tell(options, fmt::format("building with {} atoms", *found.atoms));
    options.size = AtomCount{*found.atoms};
    try {
      return build_once(surface, options);
    } catch (const TooFewAtoms& error) {
      last = error.what();
      from = 1.1 * static_cast<double>(*found.atoms);
    }
  }
  throw UserError(Failure::failed,
                  fmt::format("none of {} sizes up to {:.0f} atoms gives a molecule that holds: {}; force "
                              "one with --atoms N --force, or change the shape",
                              most_builds, from / 1.1, last));
}

}  // namespace

std::string_view name(Recipe recipe) {
  switch (recipe) {
    case Recipe::annealed:
      return "annealed";
    case Recipe::thesis:
      return "thesis";
    case Recipe::pecanha2013:
      return "pecanha2013";
    case Recipe::hauck2014:
      return "hauck2014";
    case Recipe::hauck2015:
      return "hauck2015";
  }
  return "";
}

double tether_of(const BuildOptions& options) {
  return options.tether.value_or(keeps_size(options.size) ? default_tether_of_size : default_tether);
}

minimisation::CellRelaxation relaxed_strains(const BuildOptions& options, const TriangleMesh& surface) {
  if (!surface.space.periodic()) return minimisation::CellRelaxation::none;
  if (options.relax_cell) return *options.relax_cell;
  const std::vector<int> ranks = ranks_of(surface);
  const bool sheets = std::all_of(ranks.begin(), ranks.end(), [](int rank) { return rank == 2; });
  return keeps_size(options.size) || sheets ? minimisation::CellRelaxation::none
                                            : minimisation::CellRelaxation::isotropic;
}

BuildResult build_molecule(const TriangleMesh& surface, const BuildOptions& options) {
  const bool periodic = surface.space.periodic();
  if (options.recipe != Recipe::annealed && periodic)
    throw UserError(Failure::usage, fmt::format("--recipe {} does not work in periodic cells; use the "
                                                "default recipe, or build in free space with --periodic none",
                                                name(options.recipe)));
  if (options.relax_cell && *options.relax_cell != minimisation::CellRelaxation::none && !periodic)
    throw UserError(Failure::usage,
                    "--relax-cell is for meshes in a periodic cell; this one is in free space");
  if (options.fit) return build_fitting(surface, options);
  try {
    return build_once(surface, options);
  } catch (const TooFewAtoms& error) {
    if (!options.advise) throw;
    tell(options, std::string(error.what()) + "; looking for a size that works");
    throw UserError(error.failure(),
                    fmt::format("{}; {}", error.what(), advice_after(error, surface, options)));
  }
}

}  // namespace nanocarbon::building
