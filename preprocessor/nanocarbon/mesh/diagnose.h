// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/mesh/diagnosis.h"
#include "nanocarbon/mesh/polygon_soup.h"

namespace nanocarbon::mesh {

//! Measures a mesh and finds everything that is wrong with it. O(n log n) in faces.
MeshDiagnosis diagnose(const PolygonSoup& soup);

}  // namespace nanocarbon::mesh
