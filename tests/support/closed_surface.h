// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <gtest/gtest.h>

#include "nanocarbon/mesh/diagnose.h"
#include "nanocarbon/mesh/diagnosis.h"

namespace nanocarbon::test {

//! What a mesh is that must be a closed 2-manifold, wound outward, which crosses itself nowhere.
inline mesh::MeshTopology closed_surface(const TriangleMesh& mesh) {
  const mesh::MeshDiagnosis diagnosis = mesh::diagnose(mesh::soup_of(mesh));
  for (const mesh::MeshFinding& finding : diagnosis.findings) ADD_FAILURE() << finding.text;
  EXPECT_TRUE(diagnosis.topology.closed());
  EXPECT_GT(diagnosis.volume.value_or(-1.0), 0.0);
  return diagnosis.topology;
}

}  // namespace nanocarbon::test
