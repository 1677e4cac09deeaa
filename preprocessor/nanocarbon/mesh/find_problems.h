// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/mesh/diagnosis.h"
#include "nanocarbon/mesh/edge_table.h"

namespace nanocarbon::mesh {

//! Fills MeshDiagnosis::findings, the other members of which are known.
void find_problems(const PolygonSoup& soup, const EdgeTable& edges, MeshDiagnosis& diagnosis);

}  // namespace nanocarbon::mesh
