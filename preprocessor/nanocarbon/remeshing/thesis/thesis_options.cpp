// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/thesis/thesis_options.h"

namespace nanocarbon::thesis {

ThesisOptions hauck2015_options() {
  ThesisOptions options;
  options.valence_error = ValenceError::linear;
  options.repeat_valences = false;
  options.impose_valences = false;
  options.nearest_vertices = 1;
  return options;
}

ThesisOptions hauck2014_options() {
  ThesisOptions options = hauck2015_options();
  options.projection_interval = 0;
  options.local_threshold = -1.0;
  return options;
}

ThesisOptions pecanha2013_options() {
  ThesisOptions options = hauck2014_options();
  options.stellar_position = StellarPosition::midpoint;
  options.post_processing = PostProcessing::none;
  return options;
}

}  // namespace nanocarbon::thesis
