// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/grids/vtk_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "nanocarbon/mesh/grids/vtk_numbers.h"
#include "nanocarbon/mesh/parsing/text_scanner.h"

namespace nanocarbon::mesh {
namespace {

// Cells whose points are more than their corners, after those.
struct Curved {
  int type;
  std::size_t corners;
  std::optional<VolumeCell> volume;
};
constexpr std::array<Curved, 16> curved_cells = {{{22, 3, {}},
                                                  {34, 3, {}},
                                                  {69, 3, {}},
                                                  {23, 4, {}},
                                                  {28, 4, {}},
                                                  {30, 4, {}},
                                                  {70, 4, {}},
                                                  {24, 4, VolumeCell::tetrahedron},
                                                  {71, 4, VolumeCell::tetrahedron},
                                                  {25, 8, VolumeCell::hexahedron},
                                                  {29, 8, VolumeCell::hexahedron},
                                                  {72, 8, VolumeCell::hexahedron},
                                                  {26, 6, VolumeCell::wedge},
                                                  {32, 6, VolumeCell::wedge},
                                                  {73, 6, VolumeCell::wedge},
                                                  {27, 5, VolumeCell::pyramid}}};

class Adder {
 public:
  Adder(GridSurface& surface, const CellRefusal& refuse) : surface_(surface), refuse_(refuse) {}

  void add(int type, std::span<const VertexIndex> ids) {
    const auto pick = [&](std::initializer_list<std::size_t> order) {
      std::vector<VertexIndex> result;
      for (const std::size_t i : order) result.push_back(ids[i]);
      return result;
    };
    switch (type) {
      case 0:
      case 1:
      case 2:
      case 3:
      case 4:
      case 21:
      case 35:
      case 68:
        return surface_.skip_point_or_line();
      case 5:
        need(type, ids, 3);
        return surface_.add_face(ids);
      case 9:
        need(type, ids, 4);
        return surface_.add_face(ids);
      case vtk_polygon:
        return surface_.add_face(ids);
      case vtk_strip:
        for (std::size_t i = 0; i + 2 < ids.size(); ++i)
          surface_.add_face(std::array{ids[i], ids[i + 1 + i % 2], ids[i + 2 - i % 2]});
        return;
      case 8:  // a pixel
        need(type, ids, 4);
        return surface_.add_face(pick({0, 1, 3, 2}));
      case 11:  // a voxel
        need(type, ids, 8);
        return surface_.add_volume(VolumeCell::hexahedron, pick({0, 1, 3, 2, 4, 5, 7, 6}));
      case 10:
        return add_volume(type, VolumeCell::tetrahedron, ids);
      case 12:
        return add_volume(type, VolumeCell::hexahedron, ids);
      case 13:
        return add_volume(type, VolumeCell::wedge, ids);
      case 14:
        return add_volume(type, VolumeCell::pyramid, ids);
      default:
        return add_curved(type, ids);
    }
  }

 private:
  void need(int type, std::span<const VertexIndex> ids, std::size_t count) const {
    if (ids.size() != count)
      refuse_(fmt::format("a cell of VTK's type {} has {} points, not {}", type, ids.size(), count));
  }

  void add_volume(int type, VolumeCell cell, std::span<const VertexIndex> ids) {
    need(type, ids, corners_of(cell));
    surface_.add_volume(cell, ids);
  }

  void add_curved(int type, std::span<const VertexIndex> ids) {
    const auto found = std::find_if(curved_cells.begin(), curved_cells.end(),
                                    [&](const Curved& c) { return c.type == type; });
    if (found == curved_cells.end())
      return refuse_(
          fmt::format("cells of VTK's type {} are not known; save the surface as polygons (ParaView: Extract "
                      "Surface)",
                      type));
    if (ids.size() < found->corners)
      return refuse_(fmt::format("a cell of VTK's type {} has {} points", type, ids.size()));
    surface_.flatten();
    if (found->volume)
      surface_.add_volume(*found->volume, ids.first(found->corners));
    else
      surface_.add_face(ids.first(found->corners));
  }

  GridSurface& surface_;
  const CellRefusal& refuse_;
};

}  // namespace

void add_vtk_cells(GridSurface& surface, const VtkCells& cells, std::size_t first, std::size_t points,
                   int same_type, const CellRefusal& refuse) {
  if (!cells.types.empty() && cells.types.size() != cells.ends.size())
    return refuse(
        fmt::format("there are {} cells, but {} types of them", cells.ends.size(), cells.types.size()));
  Adder adder(surface, refuse);
  std::vector<VertexIndex> ids;
  std::size_t begin = 0;
  for (std::size_t cell = 0; cell < cells.ends.size(); ++cell) {
    const auto end = point_index(cells.ends[cell], cells.points.size() + 1);
    if (!end || *end < begin)
      return refuse(fmt::format("cell {} ends at {} of {} numbers of points, after {}", cell,
                                cells.ends[cell], cells.points.size(), begin));
    ids.clear();
    for (; begin < *end; ++begin) {
      const auto id = point_index(cells.points[begin], points);
      if (!id)
        return refuse(fmt::format("cell {} uses point {}, but there are {}, counted from 0", cell,
                                  cells.points[begin], points));
      ids.push_back(static_cast<VertexIndex>(first) + *id);
    }
    const double type = cells.types.empty() ? same_type : cells.types[cell];
    adder.add(type >= 0 && type < 1000 ? static_cast<int>(type) : -1, ids);
  }
}

std::vector<Vec3> vtk_points(const std::vector<double>& numbers, const CellRefusal& refuse) {
  if (numbers.size() % 3 != 0)
    refuse(fmt::format("{} coordinates are not three for each point", numbers.size()));
  std::vector<Vec3> points;
  points.reserve(numbers.size() / 3);
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
    for (std::size_t d = 0; d < 3; ++d)
      if (const char* fault = coordinate_fault(numbers[i + d]))
        refuse(fmt::format("a coordinate of point {}, {}, {}", i / 3, numbers[i + d], fault));
    points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  }
  return points;
}

}  // namespace nanocarbon::mesh
