// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/grids/read_vtk_xml.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "nanocarbon/core/error.h"
#include "nanocarbon/core/text_numbers.h"
#include "nanocarbon/mesh/grids/vtk_cells.h"
#include "nanocarbon/mesh/grids/vtk_data_array.h"
#include "nanocarbon/mesh/grids/vtk_image.h"
#include "nanocarbon/mesh/parsing/text_scanner.h"

namespace nanocarbon::mesh {
namespace {

using Extent = std::array<std::int64_t, 6>;

class Reader {
 public:
  Reader(std::string_view contents, const std::string& file, const std::string& array)
      : vtk_(contents, file), file_(file), array_(array) {}

  GridContents read() {
    const pugi::xml_node root = xml().root();
    const std::string_view type = attribute_of(root, "type");
    const pugi::xml_node data = child_of(root, type);
    if (type == "PolyData" || type == "UnstructuredGrid") return surface(data, type == "PolyData");
    if (type == "ImageData") return image(data);
    if (type.starts_with("P") || type.find("MultiBlock") != type.npos || type.find("Collection") != type.npos)
      xml().fail(
          root,
          fmt::format("a file of the type {} names other files, which hold the data", mesh::quoted(type)),
          "give one of those, or save all in one file");
    xml().fail(root, fmt::format("data of the type {} is not read", mesh::quoted(type)),
               "save its surface as PolyData (ParaView: Extract Surface, .vtp)");
  }

 private:
  const XmlFile& xml() const { return vtk_.xml(); }

  pugi::xml_node array_named(const pugi::xml_node& node, std::string_view name) const {
    for (const pugi::xml_node& child : node.children())
      if (local_name(child.name()) == "DataArray" && attribute_of(child, "Name") == name) return child;
    return {};
  }

  std::vector<double> numbers(const pugi::xml_node& node, std::string_view name) const {
    const pugi::xml_node array = array_named(node, name);
    return array ? vtk_.numbers(array) : std::vector<double>{};
  }

  GridContents surface(const pugi::xml_node& data, bool polygons) {
    GridSurface surface;
    std::vector<Vec3> points;
    for (const pugi::xml_node& piece : data.children()) {
      if (local_name(piece.name()) != "Piece") continue;
      const CellRefusal refuse = [&](const std::string& what) { xml().fail(piece, what); };
      const std::size_t first = points.size();
      if (const pugi::xml_node array = child_of(child_of(piece, "Points"), "DataArray")) {
        const std::vector<Vec3> more = vtk_points(vtk_.numbers(array), refuse);
        points.insert(points.end(), more.begin(), more.end());
      }
      const auto add = [&](const char* name, int type) {
        const pugi::xml_node cells = child_of(piece, name);
        if (!cells) return;
        add_vtk_cells(surface,
                      {numbers(cells, "connectivity"), numbers(cells, "offsets"), numbers(cells, "types")},
                      first, points.size() - first, type, refuse);
      };
      if (polygons) {
        add("Verts", 2);
        add("Lines", 4);
        add("Polys", vtk_polygon);
        add("Strips", vtk_strip);
      } else {
        add("Cells", -1);
      }
    }
    if (surface.empty())
      xml().fail(xml().root(), "the file has neither faces nor cells that have some", "give a mesh");
    return std::move(surface).on(std::move(points));
  }

  template <std::size_t count>
  std::array<double, count> reals(const pugi::xml_node& node, const char* name,
                                  std::array<double, count> otherwise) const {
    const std::string_view text = attribute_of(node, name);
    if (text.empty()) return otherwise;
    TextScanner words(text, file_, {'\0', false});
    words.next_line();
    std::array<double, count> result{};
    for (double& number : result)
      if (read_real(words.word(), number) != NumberToken::number || coordinate_fault(number))
        xml().fail(node, fmt::format("its '{}', {}, is not {} numbers", name, mesh::quoted(text), count));
    return result;
  }

  Extent extent(const pugi::xml_node& node, const char* name) const {
    const std::array<double, 6> numbers = reals<6>(node, name, {0, 0, 0, 0, 0, 0});
    Extent result{};
    for (std::size_t i = 0; i < 6; ++i) {
      if (!(numbers[i] > -1e9 && numbers[i] < 1e9))
        xml().fail(node, fmt::format("its '{}' is too large", name));
      result[i] = static_cast<std::int64_t>(numbers[i]);
    }
    for (std::size_t d = 0; d < 6; d += 2)
      if (result[d + 1] < result[d]) xml().fail(node, fmt::format("its '{}' ends before it begins", name));
    return result;
  }

  GridContents image(const pugi::xml_node& data) {
    VtkImage image;
    const Extent whole = extent(data, "WholeExtent");
    for (std::size_t d = 0; d < 3; ++d)
      image.points[d] = static_cast<std::size_t>(whole[2 * d + 1] - whole[2 * d] + 1);
    const auto origin = reals<3>(data, "Origin", {0, 0, 0}), spacing = reals<3>(data, "Spacing", {1, 1, 1});
    const auto axes = reals<9>(data, "Direction", {1, 0, 0, 0, 1, 0, 0, 0, 1});
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column)
        image.steps(row, column) =
            axes[static_cast<std::size_t>(3 * row + column)] * spacing[static_cast<std::size_t>(column)];
    const Vec3 low(static_cast<double>(whole[0]), static_cast<double>(whole[2]),
                   static_cast<double>(whole[4]));
    image.origin = Vec3(origin[0], origin[1], origin[2]) + image.steps * low;
    std::vector<pugi::xml_node> pieces;
    for (const pugi::xml_node& piece : data.children())
      if (local_name(piece.name()) == "Piece") pieces.push_back(piece);
    if (pieces.size() != 1 || extent(pieces[0], "Extent") != whole)
      xml().fail(data, fmt::format("the image is in {} pieces", pieces.size()), "save it as one");
    for (const bool of_cells : {false, true}) {
      const pugi::xml_node arrays = child_of(pieces[0], of_cells ? "CellData" : "PointData");
      if (image.active.empty()) image.active = attribute_of(arrays, "Scalars");
      for (const pugi::xml_node& array : arrays.children()) {
        const std::string_view components = attribute_of(array, "NumberOfComponents");
        if (local_name(array.name()) != "DataArray" || (!components.empty() && components != "1")) continue;
        const std::string name(attribute_of(array, "Name"));
        // What is not asked for is not unpacked.
        if (!array_.empty() && name != array_)
          image.arrays.push_back({name, {}, of_cells});
        else
          image.arrays.push_back({name, vtk_.numbers(array), of_cells});
      }
    }
    return field_of(image, array_, file_);
  }

  VtkXml vtk_;
  const std::string& file_;
  const std::string& array_;
};

}  // namespace

GridContents read_vtk_xml(std::string_view contents, const std::string& file, const std::string& array) {
  return Reader(contents, file, array).read();
}

bool begins_like_vtk_xml(std::string_view contents) {
  const std::size_t begin = contents.find_first_not_of(" \t\r\n");
  return begin != contents.npos && contents[begin] == '<' &&
         contents.substr(0, 4000).find("<VTKFile") != contents.npos;
}

}  // namespace nanocarbon::mesh
