// SPDX-License-Identifier: GPL-2.0-or-later
// Stands in for what needs CGAL where that was not there when the program was built.
#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/solid/alpha_wrap.h"
#include "nanocarbon/mesh/solid/cgal_version.h"
#include "nanocarbon/mesh/solid/mend_crossings.h"
#include "nanocarbon/mesh/solid/union_of_solids.h"

namespace nanocarbon::mesh {
namespace {

[[noreturn]] void fail() {
  throw UserError(Failure::usage,
                  "--wrap, --unite and --untangle need CGAL, which this nanocarbon was built without: "
                  "install CGAL 5.5 or "
                  "newer (Debian's libcgal-dev), configure with -DNANOCARBON_CGAL=ON and build again");
}

}  // namespace

TriangleMesh alpha_wrap(const TriangleMesh&, double, double) { fail(); }

std::optional<TriangleMesh> mend_crossings(const TriangleMesh&, const std::vector<FaceIndex>&, Handles) {
  fail();
}

std::optional<TriangleMesh> union_of_solids(const std::vector<TriangleMesh>&) { fail(); }

const char* cgal_version() { return ""; }

}  // namespace nanocarbon::mesh
