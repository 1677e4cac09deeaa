// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/crystal/crystallise.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <vector>

#include "nanocarbon/core/chunks.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/remeshing/crystal/flips.h"
#include "nanocarbon/remeshing/crystal/isotropic.h"
#include "nanocarbon/remeshing/crystal/particle_annealing.h"
#include "nanocarbon/remeshing/crystal/patches.h"
#include "nanocarbon/remeshing/crystal/soundness.h"
#include "nanocarbon/remeshing/crystal/surface_guide.h"
#include "nanocarbon/remeshing/crystal/tiling.h"
#include "nanocarbon/remeshing/crystal/tiling_moves.h"
#include "nanocarbon/remeshing/crystal/valence_repair.h"

namespace nanocarbon::crystal {
namespace {

// Normals are smoothed over this share of the spacing: less shows every bump, more blurs thin parts.
constexpr double normals_length = 0.4;
// Temperature at which annealing ends.
constexpr double coldest = 0.2;

// Below this many triangles a coarse level says too little about where the fine one's defects belong.
constexpr std::size_t least_coarse_faces = 1200;

constexpr std::uint64_t seed_step = 1000003;

// With more triangles than this a wrong valence or a fold is mended with what surrounds it alone, by particles
// that are annealed for so many steps.
constexpr std::size_t least_large_faces = 20000, patch_steps = 1500;

//! Steps of annealing and temperatures for a quality. Refined levels stay below melting: they keep their
//! order.
struct Effort {
  std::size_t coarse_steps;  //!< on the first of several levels
  std::size_t fine_steps;    //!< on each level after it
  std::size_t single_steps;  //!< where there is one level only
  double hot = 1.5;
  double warm = 0.8;
};

Effort effort_for(Quality quality) {
  switch (quality) {
    case Quality::draft:
      return {3000, 1000, 1500};
    case Quality::good:
      return {20000, 6000, 20000};
    case Quality::best:
      break;
  }
  return {80000, 20000, 60000};
}

//! Vertices that a triangulation of this topology has for a number of faces. A boundary edge has no second
//! face, so that a tiling keeps about the boundary it has.
std::size_t vertices_for_faces(const Tiling& tiling, std::size_t faces) {
  const auto vertices = static_cast<double>(tiling.table.live_vertices());
  const auto triangles = static_cast<double>(tiling.table.live_triangles());
  return static_cast<std::size_t>(
      std::max(4.0, std::round(vertices + (static_cast<double>(faces) - triangles) / 2)));
}

void reach_faces(Tiling& tiling, std::size_t faces) {
  const std::size_t wanted = vertices_for_faces(tiling, faces);
  reach_vertex_count(tiling, wanted);
  unfold(tiling, 10);
}

std::vector<VertexIndex> troubled_vertices(const Tiling& tiling) {
  std::vector<VertexIndex> troubled = unsound_vertices(tiling);
  for (VertexIndex v = 0; v < tiling.table.vertices(); ++v)
    if (!tiling.is_held(v) && !tiling.table.on_boundary(v) && std::abs(tiling.table.valence(v) - 6) > 1)
      troubled.push_back(v);
  std::sort(troubled.begin(), troubled.end());
  troubled.erase(std::unique(troubled.begin(), troubled.end()), troubled.end());
  return troubled;
}

//! Flips away what is left of wrong valences and evens the edges.
void polish(Tiling& tiling) {
  constexpr int rounds = 4;
  for (int round = 0; round < rounds; ++round) {
    const bool folded = !unsound_vertices(tiling).empty();
    if (folded) unfold(tiling, 3);
    const std::size_t flips = flip_to_valences(tiling, 10);
    const ValenceRepair repair = repair_valences(tiling);
    // Edges are even, and nothing has changed since.
    if (round > 0 && !folded && flips == 0 && repair.flips == 0) break;
    settle_on_surface(tiling);
    even_edges(tiling, mean_edge_length(tiling), 150);
    if (round > 0 && repair.flips == 0) break;
  }
  settle_on_surface(tiling);
}

//! Takes away vertices where triangles are turned or valences wrong beyond repair by flips, puts as many back
//! where edges are longest, and polishes again; keeps what is better. Thin rims need it.
void mend(Tiling& tiling) {
  constexpr std::size_t rounds = 10;
  Tiling trial = tiling;
  std::size_t best = troubled_vertices(tiling).size();
  for (std::size_t round = 0; round < rounds && best > 0; ++round) {
    const double longest = 1.6 * mean_edge_length(trial);
    for (const VertexIndex v : troubled_vertices(trial)) {
      if (!trial.table.vertex_alive(v)) continue;
      std::vector<std::pair<double, HalfEdgeIndex>> edges;
      trial.table.for_outgoing(v, [&](HalfEdgeIndex h) {
        edges.emplace_back(trial.between(v, trial.table.target(h)).squaredNorm(), h);
      });
      std::sort(edges.begin(), edges.end());
      // The shortest first; where that did not help, another one in the next round.
      std::rotate(edges.begin(), edges.begin() + static_cast<std::ptrdiff_t>(round / 2 % edges.size()),
                  edges.end());
      for (const auto& edge : edges)
        if (trial.table.alive(edge.second) && try_collapse(trial, edge.second, longest)) break;
    }
    compact(trial);
    unfold(trial, 5);
    reach_vertex_count(trial, tiling.table.live_vertices());
    polish(trial);
    const std::size_t left = troubled_vertices(trial).size();
    if (left < best) {
      best = left;
      tiling = trial;
    }
  }
}

//! Mends surroundings of wrong valences and folds one by one, with as many seeds as it takes, within reason.
void mend_in_patches(Tiling& tiling, double spacing, std::uint64_t seed) {
  constexpr int rounds = 3, reach = 12;
  constexpr std::uint64_t seeds = 6;
  for (int round = 0; round < rounds; ++round) {
    const std::vector<VertexIndex> troubled = troubled_vertices(tiling);
    if (troubled.empty()) return;
    std::vector<Patch> patches = surroundings(tiling, troubled, reach);
    for_each_index(tiling.team, patches.size(), [&](std::size_t k) {
      const Tiling as_it_was = patches[k].tiling;
      std::size_t least = troubled_vertices(as_it_was).size();
      for (std::uint64_t attempt = 0; attempt < seeds && least > 0; ++attempt) {
        Tiling trial = as_it_was;
        if (attempt > 0) anneal_particles(trial, spacing, {patch_steps, 1.2, coldest, seed + attempt});
        polish(trial);
        mend(trial);
        const std::size_t left = troubled_vertices(trial).size();
        if (left >= least) continue;
        least = left;
        patches[k].tiling = std::move(trial);
      }
    });
    replace(tiling, patches);
  }
}

//! A tiling of about this many faces that is annealed from hot; the guide's normals are smoothed to fit.
Tiling freeze(SurfaceGuide& guide, double spacing, std::size_t faces, const AnnealingSchedule& schedule,
              ThreadTeam* team) {
  guide.smooth_normals(normals_length * spacing);
  Tiling tiling = tiling_of(guide);
  tiling.team = team;
  remesh_isotropically(tiling, spacing, 6);
  reach_faces(tiling, faces);
  anneal_particles(tiling, spacing, schedule);
  return tiling;
}

//! \brief Crystallises at a quarter of the faces, or a quarter of that, and refines, annealing shortly.
//! \return nothing where a coarse level cannot show the shape without turned or folded triangles
std::optional<Tiling> freeze_coarse_to_fine(SurfaceGuide& guide, double spacing, int levels,
                                            const Effort& effort, const CrystalOptions& options) {
  // Each level is taken for the same share of the work.
  int done = 0;
  AnnealingSchedule schedule{effort.coarse_steps, effort.hot, coldest, options.seed, [&](double share) {
                               if (options.progress)
                                 options.progress("crystallising coarse to fine",
                                                  0.05 + 0.85 * (done + share) / (levels + 1));
                             }};
  double coarse_spacing = std::ldexp(spacing, levels);
  Tiling tiling =
      freeze(guide, coarse_spacing, (options.faces >> (2 * levels + 1)) * 2, schedule, options.team);
  if (!unsound_vertices(tiling).empty()) return std::nullopt;
  schedule.steps = effort.fine_steps;
  schedule.hot = effort.warm;
  for (int level = levels - 1; level >= 0; --level) {
    coarse_spacing /= 2;
    guide.smooth_normals(normals_length * coarse_spacing);
    split_in_four(tiling);
    const bool large = tiling.table.live_triangles() > least_large_faces;
    if (large) put_in_order(tiling);
    if (level == 0) reach_faces(tiling, options.faces);
    // A single place is no reason to begin again with all.
    const auto unfolded = [&] {
      if (unfold(tiling, 10) == 0) return true;
      if (large) mend_in_patches(tiling, coarse_spacing, options.seed);
      return large && unsound_vertices(tiling).empty();
    };
    if (!unfolded()) return std::nullopt;
    ++done;
    anneal_particles(tiling, coarse_spacing, schedule);
    if (level > 0 && !unsound_vertices(tiling).empty() && !(large && unfolded())) return std::nullopt;
  }
  return tiling;
}

// In a cell narrower than this, in spacings, vertices meet through two images.
constexpr double least_width = 3.7;

int deepest_levels(const SurfaceGuide& guide, double spacing, std::size_t faces) {
  int levels = 0;
  while ((faces >> (2 * (levels + 1))) >= least_coarse_faces &&
         guide.space().least_width() > least_width * std::ldexp(spacing, levels + 1))
    ++levels;
  return levels;
}

//! One crystallisation from the seed of the options.
Tiling crystallise_once(SurfaceGuide& guide, double spacing, const CrystalOptions& options, int& levels) {
  const auto report = [&](std::string_view stage, double share) {
    if (options.progress) options.progress(stage, share);
  };
  const Effort effort = effort_for(options.quality);
  std::optional<Tiling> tiling;
  levels = 0;
  for (int deep = deepest_levels(guide, spacing, options.faces); deep > 0 && !tiling; --deep) {
    report("crystallising coarse to fine", 0.05);
    tiling = freeze_coarse_to_fine(guide, spacing, deep, effort, options);
    if (tiling) levels = deep;
  }
  if (!tiling) {
    report("crystallising", 0.3);
    const AnnealingSchedule schedule{effort.single_steps, effort.hot, coldest, options.seed,
                                     [&](double share) { report("crystallising", 0.3 + 0.6 * share); }};
    tiling = freeze(guide, spacing, options.faces, schedule, options.team);
  }
  const std::size_t reached = tiling->table.live_triangles();
  if (reached > options.faces + options.faces / 50 + 4)
    throw UserError(Failure::size,
                    fmt::format("{} atoms are too few for the shape: keeping its topology takes at least "
                                "{}. Ask for more atoms.",
                                options.faces, reached));
  report("evening edges", 0.9);
  polish(*tiling);
  if (tiling->table.live_triangles() > least_large_faces)
    mend_in_patches(*tiling, spacing, options.seed);
  else
    mend(*tiling);
  return *std::move(tiling);
}

}  // namespace

CrystalResult crystallise(const TriangleMesh& surface, const CrystalOptions& options) {
  CrystalResult result;
  result.spacing = std::sqrt(4 * mesh::area(surface) / (std::sqrt(3.0) * static_cast<double>(options.faces)));
  if (options.progress) options.progress("remeshing", 0);
  SurfaceGuide guide(surface, result.spacing);
  std::optional<Tiling> best;
  std::size_t least = 0;
  CrystalOptions trial = options;
  // Freezing is a matter of chance: on the thin ears of the Stanford bunny two seeds of five leave a fold or
  // a wrong valence that mending does not cure.
  for (int attempt = 0; attempt < options.attempts && (!best || least > 0); ++attempt) {
    int levels = 0;
    Tiling tiling = crystallise_once(guide, result.spacing, trial, levels);
    const std::size_t troubled = troubled_vertices(tiling).size();
    const bool large = tiling.table.live_triangles() > least_large_faces;
    if (!best || troubled < least) {
      best = std::move(tiling);
      least = troubled;
      result.levels = levels;
    }
    if (large) break;
    trial.seed += seed_step;
  }
  for (VertexIndex v = 0; v < best->table.vertices(); ++v) {
    const int charge = best->table.on_boundary(v) ? 0 : std::abs(best->table.valence(v) - 6);
    result.defects += charge > 0 ? 1 : 0;
    result.bad_valences += charge > 1 ? 1 : 0;
  }
  result.unsound = unsound_vertices(*best).size();
  result.mesh = to_mesh(*best);
  if (options.progress) options.progress("done", 1);
  return result;
}

}  // namespace nanocarbon::crystal
