// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/anneal_recipe.h"

#include <optional>
#include <utility>

#include "nanocarbon/building/annealed_starts.h"
#include "nanocarbon/building/crystal_start.h"
#include "nanocarbon/building/likeness.h"
#include "nanocarbon/building/starts_in_cell.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/mesh/periodic_mesh.h"
#include "nanocarbon/potential/rebo2/parameters.h"
#include "nanocarbon/remeshing/features/make_room.h"

namespace nanocarbon::building {

namespace {

// A lattice without defects that costs more than this above what the surface's curvature does, eV an atom, is so
// strained that defects might be cheaper. In a cell of 400 atoms the cheapest pair of them costs twice as much.
constexpr double strain_of_a_lattice = 0.01;

bool costs_no_more_than_bending(const Released& molecule, const TriangleMesh& surface, std::size_t atoms) {
  return molecule.energy - rebo2::graphene_energy < strain_of_a_lattice + expected_energy(surface, atoms);
}

// What all starts have come to.
struct Chosen {
  BestStart best;
  double unannealed = 0;  // eV for each atom, of dual relaxation alone
};

Chosen choose_start(const TriangleMesh& surface, std::size_t atoms, const AnnealOptions& options) {
  std::optional<AnnealedStart> lattice;
  if (surface.space.periodic()) lattice = start_without_defects(surface, atoms, options);
  if (lattice && costs_no_more_than_bending(lattice->released, surface, atoms)) {
    const double unannealed = lattice->level.unannealed;
    return {{*std::move(lattice), 0}, unannealed};
  }
  CrystalStart start = full_size_start(surface, atoms, options);
  annealing::relax_level(*start.level, annealing::TetherSurface(surface, 1));
  Chosen chosen{.best = {}, .unannealed = start.level->unannealed};
  if (options.quality == Quality::draft)
    chosen.best.start.level = *std::move(start.level);
  else if (surface.space.periodic() && mesh::mesh_topology(surface).closed())
    chosen.best = best_start_in_cell(*std::move(start.level), surface, atoms, options);
  else
    chosen.best = best_start(*std::move(start.level), surface, atoms, options);
  if (lattice && options.quality != Quality::draft &&
      is_better(lattice->released, chosen.best.start.released, options.tether))
    chosen.best.start = *std::move(lattice);
  chosen.best.seconds += start.seconds;
  return chosen;
}

TriangleMesh with_room(const TriangleMesh& surface, const AnnealOptions& options) {
  const auto timed = options.running.stage("features");
  return features::with_room_for_sheets(surface, features::resting_sheet_distance, options.running.threads())
      .value_or(surface);
}

}  // namespace

AnnealResult anneal(const TriangleMesh& given, std::size_t atoms, potential::Potential& potential,
                    const AnnealOptions& options) {
  const TriangleMesh surface = with_room(given, options);
  auto [best, unannealed] = choose_start(surface, atoms, options);
  TriangleMesh strained = surface;
  if (surface.space.periodic()) mesh::deform(strained, best.start.strain);
  AnnealResult result;
  result.minimum = final_minimum(std::move(best.start.level), strained, atoms, potential, options);
  result.minimum.deformation *= best.start.strain;
  result.record = {.unannealed_energy = unannealed,
                   .refinements = best.start.refinements,
                   .accepted = result.minimum.accepted,
                   .deformation = result.minimum.deformation,
                   .stress = result.minimum.stress};
  result.remeshing_seconds = best.seconds;
  return result;
}

}  // namespace nanocarbon::building
