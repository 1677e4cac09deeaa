// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/grids/msh_elements.h"

#include <algorithm>
#include <array>

namespace nanocarbon::mesh {
namespace {

enum class Kind : std::uint8_t { flat, triangle, quadrangle, tetrahedron, hexahedron, wedge, pyramid };

struct Element {
  std::uint64_t type;
  Kind kind;
  std::size_t nodes;
};

// Gmsh's manual, "MSH file format": all orders begin with the corners.
constexpr std::array<Element, 38> elements = {
    {{1, Kind::flat, 2},          {2, Kind::triangle, 3},      {3, Kind::quadrangle, 4},
     {4, Kind::tetrahedron, 4},   {5, Kind::hexahedron, 8},    {6, Kind::wedge, 6},
     {7, Kind::pyramid, 5},       {8, Kind::flat, 3},          {9, Kind::triangle, 6},
     {10, Kind::quadrangle, 9},   {11, Kind::tetrahedron, 10}, {12, Kind::hexahedron, 27},
     {13, Kind::wedge, 18},       {14, Kind::pyramid, 14},     {15, Kind::flat, 1},
     {16, Kind::quadrangle, 8},   {17, Kind::hexahedron, 20},  {18, Kind::wedge, 15},
     {19, Kind::pyramid, 13},     {20, Kind::triangle, 9},     {21, Kind::triangle, 10},
     {22, Kind::triangle, 12},    {23, Kind::triangle, 15},    {24, Kind::triangle, 15},
     {25, Kind::triangle, 21},    {26, Kind::flat, 4},         {27, Kind::flat, 5},
     {28, Kind::flat, 6},         {29, Kind::tetrahedron, 20}, {30, Kind::tetrahedron, 35},
     {31, Kind::tetrahedron, 56}, {36, Kind::quadrangle, 16},  {37, Kind::quadrangle, 25},
     {38, Kind::quadrangle, 36},  {90, Kind::wedge, 40},       {92, Kind::hexahedron, 64},
     {93, Kind::hexahedron, 125}, {118, Kind::pyramid, 30}}};

const Element* find(std::uint64_t type) {
  const auto found =
      std::find_if(elements.begin(), elements.end(), [&](const Element& e) { return e.type == type; });
  return found == elements.end() ? nullptr : &*found;
}

VolumeCell volume_of(Kind kind) {
  switch (kind) {
    case Kind::tetrahedron:
      return VolumeCell::tetrahedron;
    case Kind::hexahedron:
      return VolumeCell::hexahedron;
    case Kind::wedge:
      return VolumeCell::wedge;
    default:
      return VolumeCell::pyramid;
  }
}

}  // namespace

std::optional<std::size_t> msh_nodes(std::uint64_t type) {
  const Element* element = find(type);
  return element ? std::optional(element->nodes) : std::nullopt;
}

void add_msh_element(GridSurface& surface, std::uint64_t type, std::span<const VertexIndex> nodes) {
  const Kind kind = find(type)->kind;
  if (kind == Kind::flat) return surface.skip_point_or_line();
  const bool face = kind == Kind::triangle || kind == Kind::quadrangle;
  const std::size_t corners = kind == Kind::triangle     ? 3
                              : kind == Kind::quadrangle ? 4
                                                         : corners_of(volume_of(kind));
  if (nodes.size() > corners) surface.flatten();
  if (face)
    surface.add_face(nodes.first(corners));
  else
    surface.add_volume(volume_of(kind), nodes.first(corners));
}

}  // namespace nanocarbon::mesh
