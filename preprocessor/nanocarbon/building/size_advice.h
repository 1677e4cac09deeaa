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

//! A molecule that more atoms may make possible. The message says what is wrong, and leaves what to do to who
//! catches it.
class TooFewAtoms : public UserError {
 public:
  TooFewAtoms(Failure failure, const std::string& message,
              std::optional<features::FeatureReport> report = std::nullopt)
      : UserError(failure, message), report_(std::move(report)) {}
  //! What the check of features said of the surface at this size, if that is what was wrong.
  const std::optional<features::FeatureReport>& report() const { return report_; }

 private:
  std::optional<features::FeatureReport> report_;
};

//! \brief Looks for a number of atoms that a surface can have.
struct SizeSearch {
  const TriangleMesh& surface;  //!< of any size
  double bond_length;           //!< Angstrom
  unsigned threads;
  //! Whether a quickly made molecule of a number of atoms holds.
  std::function<bool(std::size_t atoms)> holds;
  //! Molecules larger than this are not tried; what is said of them is what the check of features says.
  std::size_t largest_tried = 6000;
};

struct SizeFound {
  std::optional<std::size_t> atoms;  //!< nothing where none that was looked at would do
  bool tried = false;   //!< a molecule of so many atoms held, rather than no feature being too small
  double searched = 0;  //!< the largest number that was looked at
};

//! \brief The next number of two digits whose features are large enough and, unless it is too large for that, of
//! which a quickly made molecule holds.
//! \param atoms from here on
//! \param report what the check said of the surface at this number, where that is known
//! \param effort atoms of molecules to try in all
SizeFound next_size(const SizeSearch& search, double atoms, const features::FeatureReport* report,
                    double effort);

//! What to ask for, in words that end a message.
std::string advice(const SizeFound& found);

}  // namespace nanocarbon::building
