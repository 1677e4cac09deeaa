// SPDX-License-Identifier: GPL-2.0-or-later
// Stands in for what needs CGAL where that was not there when the program was built.
#include "nanocarbon/mesh/solid/alpha_wrap.h"
#include "nanocarbon/mesh/solid/cgal_version.h"
#include "nanocarbon/mesh/solid/mend_crossings.h"
#include "nanocarbon/mesh/solid/union_of_solids.h"

namespace nanocarbon::mesh {

TriangleMesh alpha_wrap(const TriangleMesh&, double, double) { refuse_without_cgal(); }

std::optional<TriangleMesh> mend_crossings(const TriangleMesh&, const std::vector<FaceIndex>&, Handles) {
  refuse_without_cgal();
}

std::optional<TriangleMesh> union_of_solids(const std::vector<TriangleMesh>&) { refuse_without_cgal(); }

const char* cgal_version() { return ""; }

}  // namespace nanocarbon::mesh
