// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/repair/place_cell.h"

#include <gtest/gtest.h>

#include <cmath>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/mesh/repair/sew_in_cell.h"

namespace nanocarbon::mesh {
namespace {

const Cell unit_cell = orthogonal_cell({1, 1, 1}, {true, true, false});

// A sheet from one column of twelfths of the cell to another, 1 wide, that repeats itself along x.
TriangleMesh columns_of_a_sheet(int first, int last) {
  TriangleMesh mesh;
  const int columns = last - first;
  for (int j = 0; j <= 12; ++j)
    for (int i = first; i <= last; ++i)
      mesh.points.push_back({i / 12.0, j / 12.0, 0.05 * std::sin(2 * M_PI * i / 12.0)});
  for (int j = 0; j < 12; ++j)
    for (int i = 0; i < columns; ++i) {
      const auto at = [&](int a, int b) { return static_cast<VertexIndex>(b * (columns + 1) + a); };
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return mesh;
}

// Two triangles for each row of each column beyond twelve.
TEST(PlaceCell, CountsWhatItDrops) {
  for (const int columns : {12, 13, 18, 24}) {
    TriangleMesh mesh = columns_of_a_sheet(0, columns);
    Cell cell = unit_cell;
    EXPECT_EQ(place_cell(mesh, cell, 1e-6, 0.02), 24u * static_cast<unsigned>(columns - 12)) << columns;
    EXPECT_EQ(mesh.triangles.size(), 288u) << columns;
    EXPECT_EQ(cell.vectors, unit_cell.vectors) << columns;
  }
}

// Grids that are padded to be periodic, and files of several cells.
TEST(PlaceCell, DropsWhatIsThereTwice) {
  for (const int columns : {13, 18, 24, 36}) {
    TriangleMesh mesh = columns_of_a_sheet(0, columns);
    const SewnSurface sewn = sew_in_cell(mesh, unit_cell);
    EXPECT_EQ(sewn.mesh.points.size(), 144u) << columns;
    EXPECT_TRUE(mesh_topology(sewn.mesh).closed()) << columns;
    EXPECT_EQ(sewn.notes.size(), 1u) << columns;
    // Not where it is something else.
    for (Vec3& p : mesh.points) p.z() += 0.02 * p.x();
    EXPECT_THROW(sew_in_cell(mesh, unit_cell), UserError) << columns;
  }
}

// Whichever side of the cell it is on, and wherever the mesh was cut: a file says where its cell begins.
TEST(PlaceCell, DropsCopiesOnEitherSideOfTheCell) {
  struct Range {
    int first, last;  // columns, twelfths of the cell
  };
  for (const Range range :
       {Range{-1, 12}, {-12, 12}, {-1, 13}, {-6, 6}, {-6, 7}, {-7, 6}, {-15, 4}, {18, 31}}) {
    TriangleMesh mesh = columns_of_a_sheet(range.first, range.last);
    const SewnSurface sewn = sew_in_cell(mesh, unit_cell);
    EXPECT_EQ(sewn.mesh.points.size(), 144u) << range.first;
    EXPECT_TRUE(mesh_topology(sewn.mesh).closed()) << range.first;
    EXPECT_EQ(sewn.mesh.space.cell()->origin, unit_cell.origin) << range.first;
    // Not where it is something else, if it was cut where the cell ends.
    if (range.first % 12 != 0 && range.last % 12 != 0) continue;
    for (Vec3& p : mesh.points) p.z() += 0.02 * p.x();
    EXPECT_THROW(sew_in_cell(mesh, unit_cell), UserError) << range.first;
  }
}

}  // namespace
}  // namespace nanocarbon::mesh
