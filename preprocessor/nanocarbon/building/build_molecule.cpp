// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/build_molecule.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>
#include <variant>

#include "nanocarbon/annealing/geometry_check.h"
#include "nanocarbon/building/dual_minimum.h"
#include "nanocarbon/building/failed_molecule.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/molecule/dual.h"
#include "nanocarbon/remeshing/crystal/crystallise.h"
#include "nanocarbon/remeshing/features/atoms_for_features.h"
#include "nanocarbon/remeshing/features/make_room.h"
#include "nanocarbon/topology/connected_components.h"

namespace nanocarbon::building {
namespace {

class Stopwatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

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
void require_shape(const BuildResult& result) {
  constexpr double smallest_part =
      0.5;  // replacing the projection mesh costs some of the area, never this much
  const std::size_t atoms = result.triangulation.triangles.size();
  if (static_cast<double>(atoms) >= smallest_part * static_cast<double>(result.surface.atoms)) return;
  throw UserError(
      Failure::failed,
      fmt::format("the shape was lost: {} atoms are left where there is room for {}; ask for more "
                  "atoms, try --projection-interval 0, or take it as it is with --force",
                  atoms, result.surface.atoms));
}

void build_by_thesis(BuildResult& result, const BuildOptions& options) {
  Stopwatch stage;
  thesis::ThesisOptions thesis = options.thesis;
  thesis.threads = options.threads;
  // A number of atoms is met by adjusting the scale on the way; a length or a scale is the user's own.
  if (std::holds_alternative<AtomCount>(options.size) ||
      std::holds_alternative<AtomPerTriangle>(options.size))
    thesis.atoms = result.surface.atoms;
  if (options.progress)
    thesis.progress = [&](const thesis::ThesisProgress& p) {
      options.progress("remeshing", static_cast<double>(p.iteration) / p.max_iterations);
    };
  result.thesis = thesis::remesh_by_thesis(result.surface.mesh, thesis);
  result.triangulation = std::exchange(result.thesis->mesh, {});
  result.surface.scale *= result.thesis->scale;
  for (Vec3& point : result.surface.mesh.points) point *= result.thesis->scale;
  result.seconds.remeshing = stage.lap();
  if (!options.force) require_shape(result);
  result.molecule = molecule::dual(result.triangulation);
  if (options.relax) {
    if (options.progress) options.progress("relaxing the dual", 0.0);
    const auto relaxed = minimise_dual(result.molecule, *make_potential(options.potential),
                                       annealing::TetherSurface(result.surface.mesh, 1));
    if (!relaxed.intact && !options.force)
      throw UserError(
          Failure::failed,
          "the dual cannot be relaxed with the bonds it has: the potential would bind other atoms; take the "
          "default recipe, or the molecule as it is with --force");
  }
  result.seconds.molecule = stage.lap();
}

std::string number_that_would_do(const BuildResult& result, const BuildOptions& options) {
  const SizedSurface& surface = result.surface;
  const auto atoms = features::atoms_for_features(
      surface.mesh, mesh::area(surface.mesh) / area_per_atom(options.bond_length), {}, options.threads);
  if (!atoms)
    return "no number of atoms up to 300,000, or four times as many as asked for, would do: go on with "
           "--force";
  return fmt::format("the next size that would do is --atoms {}; ask for that, or go on with --force",
                     *atoms);
}

void require_room_for_features(const BuildResult& result, const BuildOptions& options) {
  const SizedSurface& surface = result.surface;
  const features::FeatureReport features = features::check_features(surface.mesh, {}, options.threads);
  if (features.ok()) return;
  const features::FeatureProblem& worst = features.problems.front();
  const Vec3 where = worst.where / surface.scale;
  throw UserError(
      Failure::size,
      fmt::format("the shape is too small for {} atoms in {} place(s): a {} of {:.2f} A at ({:.4g}, "
                  "{:.4g}, {:.4g}) of the mesh should have {:.2f} A; {}",
                  surface.atoms, features.problems.size(), name(worst.kind), worst.size, where.x(), where.y(),
                  where.z(), worst.needed, number_that_would_do(result, options)));
}

void require_rings_of_carbon(const Molecule& molecule) {
  std::size_t wrong = 0;
  for (std::size_t r = 0; r < molecule.rings.size(); ++r)
    wrong += molecule.rings[r].size() < 5 || molecule.rings[r].size() > 8;
  if (wrong > 0)
    throw UserError(
        Failure::failed,
        fmt::format("{} ring(s) have fewer than 5 or more than 8 atoms, for parts of the shape are too "
                    "narrow; ask for more atoms, or take it as it is with --force",
                    wrong));
}

void require_bonds_that_hold(const BuildResult& result, const BuildOptions& options) {
  if (!result.annealed->intact && !options.force)
    throw UserError(Failure::failed, describe_failure(result.molecule, result.surface));
}

// Goes on to the minimum, which may be far from where annealing was asked to stop.
void certify_annealed(BuildResult& result, potential::Potential& potential, const BuildOptions& options) {
  const minimisation::Certificate certificate = minimisation::certify(
      result.molecule, potential,
      {.force_tolerance = std::min(minimisation::certified_force, options.force_tolerance)});
  AnnealResult& annealed = *result.annealed;
  annealed.energy = certificate.energy / static_cast<double>(result.molecule.size());
  annealed.max_force = certificate.max_force;
  annealed.intact = certificate.intact;
  const annealing::GeometryCheck check =
      annealing::check_geometry(result.molecule.positions, annealing::fixed_bond_graph(annealed.network));
  annealed.shortest_bond = check.shortest_bond;
  annealed.longest_bond = check.longest_bond;
  annealed.closest_unbonded = check.closest_unbonded;
  result.certificate = certificate;
}

void build_by_annealing(BuildResult& result, const BuildOptions& options) {
  Stopwatch stage;
  if (!options.force) require_room_for_features(result, options);
  const std::unique_ptr<potential::Potential> potential = make_potential(options.potential);
  if (options.certify && potential->unbonded_reach() > 0)
    throw UserError(Failure::usage,
                    fmt::format("--certify knows potentials of bonds alone, not {}; take --potential "
                                "rebo2, or leave it out",
                                potential->name()));
  const Triangulator triangulate = [&](const TriangleMesh& surface, std::size_t faces, std::uint64_t seed) {
    Stopwatch crystal;
    crystal::CrystalOptions wanted{
        .faces = faces, .seed = seed, .quality = options.quality, .progress = options.progress};
    // Only smooth shapes are annealed at a sixteenth of the atoms, and there the first seed is enough.
    if (faces < result.surface.atoms / 8) wanted.attempts = 1;
    crystal::CrystalResult made = crystal::crystallise(surface, wanted);
    result.seconds.remeshing += crystal.lap();
    return std::move(made.mesh);
  };
  AnnealOptions annealing{.quality = options.quality,
                          .force_tolerance = options.force_tolerance,
                          .seed = options.seed,
                          .threads = options.threads,
                          .progress = options.progress};
  annealing.keep_size = keeps_size(options.size);
  annealing.tether = tether_of(options);
  annealing.make_room = [&](const TriangleMesh& thin) {
    return features::with_room_for_sheets(thin, features::resting_sheet_distance, options.threads);
  };
  result.annealed = anneal(result.surface.mesh, result.surface.atoms, triangulate, *potential, annealing);
  result.molecule = std::exchange(result.annealed->molecule, {});
  result.surface.scale *= result.annealed->growth;
  for (Vec3& point : result.surface.mesh.points) point *= result.annealed->growth;
  require_bonds_that_hold(result, options);
  if (!options.force) require_rings_of_carbon(result.molecule);
  if (options.certify) {
    if (options.progress) options.progress("certifying", 0.0);
    certify_annealed(result, *potential, options);
    require_bonds_that_hold(result, options);
  }
  result.triangulation = annealing::triangulation_of(result.annealed->network, result.molecule.positions);
  result.seconds.molecule = stage.lap() - result.seconds.remeshing;
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

BuildResult build_molecule(const TriangleMesh& surface, const BuildOptions& options) {
  const bool annealed = options.recipe == Recipe::annealed;
  const double thesis_bond = 0.5 * (options.thesis.min_bond + options.thesis.max_bond);
  BuildResult result;
  Stopwatch whole;
  result.surface = sized_surface(surface, options.size, annealed ? options.bond_length : thesis_bond);
  if (annealed)
    build_by_annealing(result, options);
  else
    build_by_thesis(result, options);
  require_same_topology(mesh::mesh_topology(result.surface.mesh), result);
  result.seconds.total = whole.lap();
  return result;
}

}  // namespace nanocarbon::building
