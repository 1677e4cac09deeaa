// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/triangle_mesh.h"
#include "nanocarbon/remeshing/features/feature_size.h"

namespace nanocarbon::building {

//! A failure that more atoms may mend. The message says what is wrong; whoever catches it adds what to do.
class TooFewAtoms : public UserError {
 public:
  TooFewAtoms(Failure failure, const std::string& message,
              std::optional<features::FeatureReport> report = std::nullopt)
      : UserError(failure, message), report_(std::move(report)) {}
  //! The report of the feature check at this size, if that was what failed.
  const std::optional<features::FeatureReport>& report() const { return report_; }

 private:
  std::optional<features::FeatureReport> report_;
};

//! \brief A search for a number of atoms that suits a surface.
struct SizeSearch {
  const TriangleMesh& surface;  //!< of any size
  double bond_length;           //!< Angstrom
  unsigned threads;
  //! Whether a draft with a number of atoms holds.
  std::function<bool(std::size_t atoms)> holds;
  //! Molecules larger than this are not tried; for them only the features are checked.
  std::size_t largest_tried = 6000;
  int most_tries = 6;
};

struct SizeFound {
  std::optional<std::size_t> atoms;  //!< nothing if none of those looked at works
  //! A draft with that many atoms held; otherwise only the features were checked.
  bool tried = false;
  //! The largest number of which a draft was made, which did not hold; 0 for none.
  std::size_t largest_failed = 0;
  //! Where it ended with features: no number up to this was found that leaves them room.
  double refused_to = 0;
};

//! \brief The next number, to two digits, for which the features are large enough and, unless it is too large to try, a
//! draft holds.
//! \param atoms where to start
//! \param report of the feature check at this number, if known
//! \param effort atoms of molecules to try in all
SizeFound next_size(const SizeSearch& search, double atoms, const features::FeatureReport* report,
                    double effort);

//! Why a search found no number, as part of a sentence.
std::string why_none(const SizeFound& found);

//! The end of a message, with what to ask for.
std::string advice(const SizeFound& found);

}  // namespace nanocarbon::building
