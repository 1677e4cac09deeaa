// SPDX-License-Identifier: GPL-2.0-or-later
// Files of VTK and Gmsh: those that other programs wrote (files/README.md says which), and damaged ones.
#include <gmock/gmock.h>

#include <map>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/formats/load_surface.h"
#include "nanocarbon/mesh/formats/read_mesh.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/triangulate.h"
#include "support/grid_files.h"
#include "support/refusal.h"
#include "support/scene_files.h"
#include "support/small_meshes.h"
#include "support/temporary_folder.h"

namespace nanocarbon::mesh {
namespace {

using testing::Contains;
using testing::HasSubstr;

const std::filesystem::path files = std::filesystem::path(__FILE__).parent_path() / "files";

// The octahedron with corners at 1 has the volume 4/3, the cube 1, whatever it is made of.
TEST(GridFiles, FilesOfOtherProgramsHaveTheRightVolume) {
  std::size_t read = 0;
  for (const auto& entry : std::filesystem::directory_iterator(files)) {
    const std::string name = entry.path().filename().string();
    if (name.ends_with(".md") || name.find("refused") != name.npos || name.starts_with("field")) continue;
    SCOPED_TRACE(name);
    ++read;
    const LoadedSurface surface = load_surface(entry.path());
    EXPECT_EQ(surface.diagnosis.topology.euler_characteristic, 2);
    EXPECT_NEAR(signed_volume(surface.mesh), name.starts_with("octahedron") ? 4.0 / 3 : 1.0, 1e-6);
    if (name.starts_with("hex") || name.starts_with("tet")) {
      EXPECT_THAT(surface.repairs, Contains(HasSubstr("took the boundary of")));
    }
    EXPECT_EQ(surface.mesh.triangles.size(), name.starts_with("octahedron") ? 8u : 12u);
  }
  EXPECT_GT(read, 15u);
}

// The distance from the origin, written by VTK beside another array; it is the one that the file points out.
TEST(GridFiles, FieldsThatVtkWroteHaveTheirSphere) {
  for (const std::string name : {"field_vtk.vti", "field_vtk_base64.vti", "field_vtk.vtk"}) {
    SCOPED_TRACE(name);
    FieldRequest request{.level = 1.5};
    if (name.ends_with(".vtk")) request.array = "distance";  // there both are alike
    const LoadedSurface surface = load_surface(files / name, {.field = request});
    EXPECT_EQ(surface.diagnosis.topology.euler_characteristic, 2);
    for (const Vec3& p : surface.mesh.points) EXPECT_NEAR(p.norm(), 1.5, 0.03);
    request = {.level = 3, .array = "twice"};
    EXPECT_EQ(load_surface(files / name, {.field = request}).mesh.triangles.size(),
              surface.mesh.triangles.size());
  }
}

std::string malformed(const std::string& contents, const std::string& file) {
  return test::refusal(Failure::malformed, [&] { parse_mesh(contents, file); });
}

TEST(GridFiles, AnotherCompressorIsNamed) {
  EXPECT_THAT(test::refusal(Failure::malformed, [] { load_surface(files / "refused_lz4.vtp"); }),
              HasSubstr("refused_lz4.vtp:2: its arrays are packed by 'vtkLZ4DataCompressor'; save it with "
                        "the compressor ZLib"));
}

TEST(GridFiles, FacesAreTakenBeforeCellsThatFillSpace) {
  std::string msh = test::msh_text(test::tetrahedron());
  msh = test::replaced(msh, "$Elements\n1 4 1 4\n", "$Elements\n2 5 1 5\n3 1 4 1\n9 1 2 3 4\n");
  const PolygonSoup soup = parse_mesh(msh, "a.msh");
  EXPECT_EQ(soup.faces(), 4u);
  EXPECT_THAT(soup.notes, Contains(HasSubstr("skipped 1 cells that fill space")));
}

TEST(GridFiles, StripsPixelsAndCurvedCellsAreFaces) {
  const std::string head =
      "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 6 float\n0 0 0\n"
      "1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n";
  const PolygonSoup soup = parse_mesh(
      head + "CELLS 4 22\n6 0 1 2 3 4 5\n4 0 1 2 3\n6 0 1 2 3 4 5\n2 0 1\nCELL_TYPES 4\n6 8 22 3\n", "a.vtk");
  EXPECT_THAT(soup.corners, testing::ElementsAre(0, 1, 2, 1, 3, 2, 2, 3, 4, 3, 5, 4, 0, 1, 3, 2, 0, 1, 2));
  EXPECT_THAT(soup.notes, Contains(HasSubstr("skipped 1 points and lines")));
  EXPECT_THAT(soup.notes, Contains(HasSubstr("took the corners alone of 1 cells")));
  EXPECT_THAT(malformed(head + "CELLS 1 3\n2 0 1\nCELL_TYPES 1\n3\n", "a.vtk"),
              HasSubstr("neither faces nor cells"));
  EXPECT_THAT(malformed(head + "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n42\n", "a.vtk"),
              HasSubstr("VTK's type 42 are not known"));
}

// Version 5.1 of VTK's older format: offsets and connectivity; fields and meta data before.
TEST(GridFiles, OffsetsOfNewerVersions) {
  const PolygonSoup soup = parse_mesh(
      "# vtk DataFile Version 5.1\nvtk output\nASCII\nDATASET POLYDATA\nFIELD FieldData 1\nTIME 1 1 "
      "double\n0.5\n"
      "POINTS 4 float\n0 0 0 1 0 0 1 1 0\n0 1 0\nMETADATA\nINFORMATION 0\n\nPOLYGONS 3 7\nOFFSETS "
      "vtktypeint64\n0 3 7\n"
      "CONNECTIVITY vtktypeint64\n0 1 2 0 1 2 3\nCELL_DATA 2\nanything\n",
      "a.vtk");
  EXPECT_EQ(soup.faces(), 2u);
  EXPECT_EQ(soup.face(1).size(), 4u);
}

TEST(GridFiles, DamagedFilesAreRefusedWithTheirPlace) {
  const TriangleMesh mesh = test::tetrahedron();
  const std::string vtk = test::vtk_text(mesh), vtp = test::vtp_text(mesh), msh = test::msh_text(mesh);
  EXPECT_THAT(malformed(test::replaced(vtk, "3 0 1 2\n", "3 0 1 9\n"), "a.vtk"),
              HasSubstr("cell 0 uses point 9, but there are 4"));
  EXPECT_THAT(malformed(test::replaced(vtk, "1 -1 -1\n", "1 -1 nan\n"), "a.vtk"),
              HasSubstr("a.vtk:7: the points 'nan'"));
  EXPECT_THAT(malformed(test::replaced(vtk, "POLYGONS 4 16", "POLYGONS 4 1600000000000"), "a.vtk"),
              HasSubstr("announced"));
  EXPECT_THAT(malformed(test::replaced(vtk, "POLYDATA", "STRUCTURED_GRID"), "a.vtk"),
              HasSubstr("Extract Surface"));
  EXPECT_THAT(malformed(vtk.substr(0, vtk.find("POLYGONS")), "a.vtk"), HasSubstr("neither faces"));
  EXPECT_THAT(malformed(test::replaced(vtp, "0 1 2\n", "0 1 9\n"), "a.vtp"),
              HasSubstr("a.vtp:4: cell 0 uses point 9"));
  EXPECT_THAT(malformed(test::replaced(vtp, "3 6 9", "3 2 9"), "a.vtp"), HasSubstr("cell 1 ends at 2"));
  EXPECT_THAT(
      malformed(test::replaced(vtp, "byte_order", "compressor=\"vtkLZ4DataCompressor\" byte_order"), "a.vtp"),
      HasSubstr("packed by 'vtkLZ4DataCompressor'"));
  EXPECT_THAT(malformed(test::replaced(vtp, "\"PolyData\" v", "\"PPolyData\" v"), "a.vtp"),
              HasSubstr("names other files"));
  EXPECT_THAT(malformed(test::replaced(vtp, "format=\"ascii\"", "format=\"binary\""), "a.vtp"),
              HasSubstr("a.vtp:5"));
  EXPECT_THAT(malformed(test::replaced(vtp, "</Piece>", ""), "a.vtp"), HasSubstr("is not XML"));
  EXPECT_THAT(malformed(test::replaced(msh, "1 1 2 3\n", "1 1 2 7\n"), "a.msh"), HasSubstr("uses node 7"));
  EXPECT_THAT(malformed(test::replaced(msh, "2 1 2 4\n", "2 1 99 4\n"), "a.msh"),
              HasSubstr("Gmsh's type 99"));
  EXPECT_THAT(malformed(test::replaced(msh, "4.1 0 8", "4 0 8"), "a.msh"),
              HasSubstr("a.msh:2: the version of the MSH file is '4'"));
  EXPECT_THAT(malformed(test::replaced(msh, "$EndElements", "$EndElement"), "a.msh"),
              HasSubstr("does not end"));
}

}  // namespace
}  // namespace nanocarbon::mesh
