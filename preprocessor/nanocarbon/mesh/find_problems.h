#pragma once

#include "nanocarbon/mesh/diagnosis.h"
#include "nanocarbon/mesh/edge_table.h"

namespace nanocarbon {

//! Fills MeshDiagnosis::findings, the other members of which are known.
void find_problems(const PolygonSoup& soup, const EdgeTable& edges, MeshDiagnosis& diagnosis);

}  // namespace nanocarbon
