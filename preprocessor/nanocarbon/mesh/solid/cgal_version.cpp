// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/solid/cgal_version.h"

#include "nanocarbon/core/error.h"

namespace nanocarbon::mesh {

void refuse_without_cgal() {
  throw UserError(Failure::usage,
                  "--wrap, --unite and --untangle need CGAL, which this nanocarbon was built without: "
                  "install CGAL 5.5 or "
                  "newer (Debian's libcgal-dev), configure with -DNANOCARBON_CGAL=ON and build again");
}

}  // namespace nanocarbon::mesh
