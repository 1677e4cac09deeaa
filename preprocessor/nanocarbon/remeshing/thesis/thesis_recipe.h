// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "nanocarbon/mesh/triangle_mesh.h"
#include "nanocarbon/remeshing/thesis/edge_lengths.h"
#include "nanocarbon/remeshing/thesis/local_optimiser.h"
#include "nanocarbon/remeshing/thesis/stellar_pass.h"
#include "nanocarbon/remeshing/thesis/thesis_options.h"
#include "nanocarbon/remeshing/thesis/valence_optimiser.h"

namespace nanocarbon::thesis {

enum class ThesisStop {
  converged,       //!< no edge is short or long
  iteration_limit  //!< n iterations were done
};

//! The words of a report for it.
const char* to_string(ThesisStop stop);

//! Wall-clock seconds by step.
struct ThesisSeconds {
  double stellar = 0.0;
  double valence = 0.0;
  double low_pass = 0.0;
  double local = 0.0;
  double projection = 0.0;  //!< with the replacements of the projection mesh
  double post_processing = 0.0;
  double total = 0.0;
};

//! What a run did.
struct ThesisRecord {
  unsigned iterations = 0;
  ThesisStop stop = ThesisStop::iteration_limit;
  std::vector<EdgeCounts> history;  //!< of the surface as given, then after every iteration
  EdgeCounts edges;                 //!< of the result, after post-processing
  double mean_edge = 0.0;           //!< Angstrom
  ValenceCounts valences;

  StellarTotals stellar;  //!< over all iterations, as are those below
  ValenceTotals valence;
  unsigned low_pass_iterations = 0;  //!< iterations that filtered globally
  unsigned local_iterations = 0;     //!< iterations that optimised locally
  LocalTotals local;                 //!< with the final NonLinearOptimizer of line 18
  unsigned projection_replacements = 0;
  LocalTotals post_processing;
  ThesisSeconds seconds;
};

struct ThesisResult {
  TriangleMesh mesh;   //!< Angstrom; its dual (molecule/dual.h) is the molecule
  double scale = 1.0;  //!< the mesh lies on the surface times this; not 1 only with ThesisOptions::atoms
  ThesisRecord record;
};

//! \brief Adaptive remeshing (Algorithm 1), up to but without the dual.
//! \details Where the listing leaves room: `iter` and `i` are one counter and `r` is k. The percentage of
//! line 10 is that of the `short` and `long` which line 4 tests, counted at the end of the iteration before.
//! A surface whose mean edge is longer than four target edges is first split in four until it is not: the
//! thesis's models are not that coarse, and on a handful of vertices the filter, whose stars then reach round
//! the whole shape, pulls everything into one place faster than splits add vertices.
//! Line 6 at i = 0 replaces the projection mesh by the copy it already is. Lines 18 and 19 find empty
//! priority lists on a mesh that converged. The result has the topology of the surface.
//! \param surface Angstrom: scaled already (see building/size_request.h)
//! \pre bond lengths are above zero and in order
//! \throw UserError (unsuitable) where the surface is not an oriented 2-manifold or a point is not finite
ThesisResult remesh_by_thesis(const TriangleMesh& surface, const ThesisOptions& options);

}  // namespace nanocarbon::thesis
