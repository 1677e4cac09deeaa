// SPDX-License-Identifier: GPL-2.0-or-later
// Small files of VTK, Gmsh and scalar fields, written from their specifications.
#pragma once

#include <array>
#include <functional>
#include <string>

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::test {

std::string vtk_text(const TriangleMesh& mesh);
std::string vtp_text(const TriangleMesh& mesh);
std::string msh_text(const TriangleMesh& mesh);

//! Values at the nodes of a grid: origin + i a + j b + k c.
struct SampledField {
  std::array<std::size_t, 3> counts;
  Vec3 origin;
  Mat3 steps;  //!< columns
  std::function<double(const Vec3&)> value;
};

std::string cube_text(const SampledField& field, bool angstrom = false);
//! Floats; the grid's steps have to be along the axes, its origin at whole steps.
std::string mrc_bytes(const SampledField& field, bool big_endian = false,
                      std::array<int, 3> axes = {1, 2, 3});
std::string vti_text(const SampledField& field);
std::string structured_points_text(const SampledField& field);

}  // namespace nanocarbon::test
