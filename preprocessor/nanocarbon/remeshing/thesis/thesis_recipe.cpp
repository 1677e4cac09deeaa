// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/thesis/thesis_recipe.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/split_in_four.h"
#include "nanocarbon/remeshing/thesis/low_pass_filter.h"
#include "nanocarbon/remeshing/thesis/projection.h"

namespace nanocarbon::thesis {
namespace {

//! Runs a step and adds the time it took.
template <class Step>
auto timed(double& seconds, Step&& step) {
  struct Clock {
    double& sum;
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    ~Clock() { sum += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); }
  } const clock{seconds};
  return step();
}

void add(StellarTotals& sum, const StellarTotals& t) {
  sum.candidates += t.candidates;
  sum.collapses += t.collapses;
  sum.splits += t.splits;
  sum.refused += t.refused;
}

void add(ValenceTotals& sum, const ValenceTotals& t) {
  sum.passes += t.passes;
  sum.flips += t.flips;
}

void add(LocalTotals& sum, const LocalTotals& t) {
  sum.candidates += t.candidates;
  sum.minimised += t.minimised;
  sum.iterations += t.iterations;
}

void check(const TriangleMesh& surface) {
  for (std::size_t v = 0; v < surface.points.size(); ++v)
    if (!surface.points[v].allFinite())
      throw UserError(Failure::unsuitable,
                      fmt::format("vertex {} does not have finite coordinates: repair the mesh", v));
}

//! The surface, with enough vertices to begin with.
TriangleMesh start_of(const TriangleMesh& surface, const ThesisOptions& options) {
  constexpr double coarsest = 4.0;  // target edges
  const double longest = coarsest * edge_interval(options.min_bond, options.max_bond).mean();
  TriangleMesh start = surface;
  while (mesh::edge_lengths(start).mean > longest) start = mesh::split_in_four(start);
  return start;
}

//! One run of Algorithm 1: the mesh, the projection mesh and the record of what was done.
class Recipe {
 public:
  Recipe(const TriangleMesh& surface, const ThesisOptions& options)
      : options_(options),
        interval_(edge_interval(options.min_bond, options.max_bond)),
        mesh_(to_triangulation(surface)),
        projection_mesh_(surface) {}

  ThesisResult run() {
    timed(did_.seconds.total, [&] {
      edges_ = record();
      while (edges_.outside() > 0 && did_.iterations < options_.iterations) {
        iterate();
        ++did_.iterations;
        edges_ = record();
        if (options_.progress) options_.progress({did_.iterations, options_.iterations, edges_});
      }
      did_.stop = edges_.outside() > 0 ? ThesisStop::iteration_limit : ThesisStop::converged;
      finish();
    });
    return {to_triangle_mesh(mesh_), scale_, std::move(did_)};
  }

 private:
  EdgeCounts record() {
    const EdgeCounts edges = count_edges(mesh_, interval_);
    did_.history.push_back(edges);
    return edges;
  }

  bool uses_local_optimisation() const { return options_.local_threshold >= 0.0; }
  bool optimises_locally() const {
    return uses_local_optimisation() && edges_.percent_outside() <= options_.local_threshold;
  }

  //! Lines 5 to 16.
  void iterate() {
    const unsigned p = options_.projection_interval;
    // At i = 0 the projection mesh already is a copy of the surface.
    if (p > 0 && did_.iterations > 0 && did_.iterations % p == 0) {
      timed(did_.seconds.projection, [&] { projection_mesh_ = ProjectionMesh(to_triangle_mesh(mesh_)); });
      ++did_.projection_replacements;
    }
    timed(did_.seconds.stellar, [&] {
      StellarOptions stellar;
      stellar.interval = interpolated_interval(interval_, mean_edge_length(mesh_));
      stellar.target_length = interval_.mean();
      stellar.position = options_.stellar_position;
      stellar.marks = options_.marks;
      add(did_.stellar, stellar_pass(mesh_, stellar));
    });
    timed(did_.seconds.valence, [&] {
      add(did_.valence, optimise_valences(mesh_, {options_.valence_error, options_.repeat_valences, {}}));
    });
    VertexStars stars = vertex_stars(mesh_);
    if (optimises_locally()) {
      timed(did_.seconds.local, [&] { add(did_.local, optimise_locally(stars, local_options(true))); });
      ++did_.local_iterations;
    } else {
      timed(did_.seconds.low_pass, [&] { return low_pass_filter(stars, options_.rings, options_.threads); });
      ++did_.low_pass_iterations;
    }
    timed(did_.seconds.projection, [&] {
      return project_points(stars.points, projection_mesh_, options_.nearest_vertices, options_.threads);
    });
    set_points(mesh_, stars);
    adjust_scale();
  }

  //! Brings the count of faces towards the one asked for. Scaling the lengths by which edges are judged is
  //! the same as scaling surface and mesh the other way, which finish() does once. Small steps, so that a
  //! pass of stellar operations keeps up; none while the mesh is still far finer or coarser than its target.
  void adjust_scale() {
    if (options_.atoms == 0) return;
    const double mean_ratio = mean_edge_length(mesh_) / interval_.mean();
    if (mean_ratio < 0.9 || mean_ratio > 1.15) return;
    const double excess = static_cast<double>(mesh_.n_faces()) / static_cast<double>(options_.atoms);
    // Local optimisation mends single edges: it is disturbed only for a count that has drifted.
    const bool local = optimises_locally();
    if (local && std::abs(excess - 1.0) < 0.01) return;
    const double limit = local ? 0.002 : 0.01;
    const double factor = std::clamp(std::sqrt(excess), 1.0 - limit, 1.0 + limit);
    interval_ = {interval_.min * factor, interval_.max * factor};
    scale_ /= factor;
  }

  //! "The method imposes that the valence of each vertex cannot be lower than 5 or greater than 7", but an 8
  //! among sixes has the same error as the 7, 7, 7 and 5 that a flip makes of it: Algorithm 4 stops there.
  void impose_valences() {
    if (!options_.impose_valences) return;
    constexpr int rounds = 3;  // moving vertices makes room for other flips
    for (int round = 0; round < rounds && count_valences(mesh_).outside_5_to_7() > 0; ++round) {
      const crystal::ValenceRepair repair =
          timed(did_.seconds.valence, [&] { return repair_valences(mesh_); });
      did_.valence.flips += repair.flips;
      if (repair.flips == 0 || !uses_local_optimisation()) return;
      VertexStars stars = vertex_stars(mesh_);
      timed(did_.seconds.local, [&] { add(did_.local, optimise_locally(stars, local_options(true))); });
      set_points(mesh_, stars);
    }
  }

  //! Lines 18 and 19, and the counts of the result.
  void finish() {
    impose_valences();
    VertexStars stars = vertex_stars(mesh_);
    if (uses_local_optimisation())
      timed(did_.seconds.local, [&] { add(did_.local, optimise_locally(stars, local_options(true))); });
    if (options_.post_processing == PostProcessing::at_end)
      timed(did_.seconds.post_processing,
            [&] { add(did_.post_processing, optimise_locally(stars, local_options(false))); });
    // Where the interval was scaled, the mesh is brought to the one that was asked for.
    for (Vec3& p : stars.points) p *= scale_;
    interval_ = edge_interval(options_.min_bond, options_.max_bond);
    set_points(mesh_, stars);
    did_.edges = count_edges(mesh_, interval_);
    did_.mean_edge = mean_edge_length(mesh_);
    did_.valences = count_valences(mesh_);
  }

  LocalOptions local_options(bool tangent_plane) const {
    LocalOptions local;
    local.interval = interval_;
    local.tangent_plane = tangent_plane;
    return local;
  }

  const ThesisOptions& options_;
  LengthInterval interval_;  // l_min and l_max; scaled where a number of atoms is asked for
  Triangulation mesh_;
  ProjectionMesh projection_mesh_;
  EdgeCounts edges_;  // of the mesh at the end of the last iteration
  double scale_ = 1.0;
  ThesisRecord did_;
};

}  // namespace

const char* to_string(ThesisStop stop) {
  return stop == ThesisStop::converged ? "converged: no short or long edge is left"
                                       : "the limit of iterations was reached";
}

ThesisResult remesh_by_thesis(const TriangleMesh& surface, const ThesisOptions& options) {
  check(surface);
  return Recipe(start_of(surface, options), options).run();
}

}  // namespace nanocarbon::thesis
