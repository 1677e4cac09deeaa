// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <functional>

#include "nanocarbon/remeshing/thesis/edge_lengths.h"
#include "nanocarbon/remeshing/thesis/stellar_pass.h"
#include "nanocarbon/remeshing/thesis/valence_optimiser.h"

namespace nanocarbon::thesis {

enum class PostProcessing {
  none,
  at_end,  //!< Eq. 4.4 without constraint around every edge still outside the interval (section 4.6)
};

//! Where the recipe is, for a progress bar.
struct ThesisProgress {
  unsigned iteration;
  unsigned max_iterations;
  EdgeCounts edges;
};

//! \brief The tuple (M, l_min, l_max, n, k, p, s) of the thesis, and what its forerunners did otherwise.
//! \details Nothing here is drawn at random: the same surface and options give the same result, on any number
//! of threads.
struct ThesisOptions {
  double min_bond = 1.2;      //!< Angstrom; edges get sqrt(3) times as much
  double max_bond = 1.8;      //!< Angstrom
  unsigned iterations = 150;  //!< n
  unsigned rings = 2;         //!< k, of the low-pass filter
  unsigned projection_interval =
      10;  //!< p: iterations between replacements of the projection mesh; 0 for never
  double local_threshold =
      5.0;  //!< s: percentage of edges outside at or below which optimisation is local; below 0 never

  //! 0 keeps the surface's scale, as the thesis. Else the scale is adjusted on the way until the result has
  //! about this many faces, an atom each; ThesisResult::scale then tells by how much.
  std::size_t atoms = 0;

  StellarPosition stellar_position = StellarPosition::least_error;
  VisitedMarks marks = VisitedMarks::either_end;
  ValenceError valence_error = ValenceError::quadratic;
  bool repeat_valences = true;    //!< the valence optimiser repeats until nothing improves
  bool impose_valences = true;    //!< 5 to 7, at the end, by sequences of flips (valence_repair.h)
  unsigned nearest_vertices = 5;  //!< of the projection mesh, around which triangles are candidates
  PostProcessing post_processing = PostProcessing::at_end;

  unsigned threads = 1;  //!< to use at most

  std::function<void(const ThesisProgress&)> progress;  //!< called after every iteration, where set
};

//! \name The methods the thesis builds on
//! @{
//! Equalisation: stellar operations at midpoints, one pass of the linear valence error, low-pass filter,
//! projection to the triangles around one nearest vertex of the original surface. No local optimisation, no
//! post-processing.
ThesisOptions pecanha2013_options();
//! The same with the positions of Eq. 4.1 and post-processing at the end.
ThesisOptions hauck2014_options();
//! Local optimisation inside the loop and a projection mesh that is replaced: the thesis without its three
//! changes (quadratic error, repetition, five nearest vertices).
ThesisOptions hauck2015_options();
//! @}

}  // namespace nanocarbon::thesis
