// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/grids/read_vtk.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <utility>

#include "nanocarbon/core/text_numbers.h"
#include "nanocarbon/mesh/grids/vtk_cells.h"
#include "nanocarbon/mesh/grids/vtk_image.h"
#include "nanocarbon/mesh/grids/vtk_numbers.h"
#include "nanocarbon/mesh/parsing/text_scanner.h"
#include "nanocarbon/mesh/parsing/value_cursor.h"

namespace nanocarbon::mesh {
namespace {

constexpr std::string_view magic = "# vtk DataFile Version ";

std::string upper(std::string_view word) {
  std::string result(word);
  for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

class Reader {
 public:
  Reader(std::string_view contents, const std::string& file, const std::string& array)
      : cursor_(contents, file), file_(file), array_(array) {}

  GridContents read() {
    const std::string_view head = cursor_.line();
    if (!head.starts_with(magic)) cursor_.fail(fmt::format("the file does not begin with '{}'", magic));
    double version = 0.0;
    read_real(head.substr(magic.size()).substr(0, 3), version);
    offsets_ = version >= 5.0;
    cursor_.line();  // a title
    const std::string coding = upper(cursor_.word());
    if (coding != "ASCII" && coding != "BINARY")
      cursor_.fail(fmt::format("{} is neither ASCII nor BINARY", mesh::quoted(coding)));
    binary_ = coding == "BINARY";
    if (upper(cursor_.word()) != "DATASET") cursor_.fail("there is no line DATASET");
    const std::string kind = upper(cursor_.word());
    cursor_.line();
    if (kind == "STRUCTURED_POINTS") return image();
    if (kind != "POLYDATA" && kind != "UNSTRUCTURED_GRID")
      cursor_.fail(fmt::format("data of the kind {} is not read", mesh::quoted(kind)),
                   "save its surface as polygons (ParaView: Extract Surface, .vtp)");
    return surface();
  }

 private:
  GridContents surface() {
    std::vector<Vec3> points;
    std::vector<std::pair<int, VtkCells>> groups;
    for (std::string key = next_key(); !key.empty() && key != "POINT_DATA" && key != "CELL_DATA";
         key = next_key()) {
      if (key == "POINTS") {
        const std::uint64_t count = cursor_.count("number of points");
        const VtkType type = this->type();
        points = vtk_points(numbers(count, 3, type, "points"), refuse_);
      } else if (key == "CELL_TYPES") {
        const std::uint64_t count = cursor_.count("number of cells");
        cursor_.line();
        if (groups.empty()) cursor_.fail("CELL_TYPES stand before CELLS");
        groups.back().second.types = numbers(count, 1, VtkType::int32, "types of cells");
      } else if (const int type = type_of(key)) {
        groups.emplace_back(type, cells());
      } else {
        skip(key);
      }
    }
    GridSurface surface;
    for (const auto& [type, cells] : groups) add_vtk_cells(surface, cells, 0, points.size(), type, refuse_);
    if (surface.empty()) cursor_.fail("the file has neither faces nor cells that have some", "give a mesh");
    return std::move(surface).on(std::move(points));
  }

  // 0 for what are no cells; cells with types of their own have none in common.
  static int type_of(const std::string& key) {
    if (key == "VERTICES") return 2;
    if (key == "LINES") return 4;
    if (key == "POLYGONS") return vtk_polygon;
    if (key == "TRIANGLE_STRIPS") return vtk_strip;
    return key == "CELLS" ? -1 : 0;
  }

  VtkCells cells() {
    VtkCells result;
    const std::uint64_t count = cursor_.count("number of cells"),
                        size = cursor_.count("length of the list of cells");
    cursor_.line();
    if (offsets_) {  // count is that of the offsets, one more than of cells
      result.ends = listed("OFFSETS", count);
      result.points = listed("CONNECTIVITY", size);
      if (!result.ends.empty()) result.ends.erase(result.ends.begin());
      return result;
    }
    const std::vector<double> list = numbers(size, 1, VtkType::int32, "cells");
    result.points.reserve(list.size());
    for (std::size_t at = 0; result.ends.size() < count;) {
      const auto corners = at < list.size() ? point_index(list[at], list.size() - at) : std::nullopt;
      if (!corners) cursor_.fail(fmt::format("cell {} goes beyond the list of cells", result.ends.size()));
      result.points.insert(result.points.end(), list.begin() + static_cast<std::ptrdiff_t>(at) + 1,
                           list.begin() + static_cast<std::ptrdiff_t>(at + *corners) + 1);
      result.ends.push_back(static_cast<double>(result.points.size()));
      at += *corners + 1;
    }
    return result;
  }

  std::vector<double> listed(const std::string& name, std::uint64_t count) {
    if (next_key() != name) cursor_.fail(fmt::format("there is no line {}", name));
    const VtkType type = this->type();
    return numbers(count, 1, type, "cells");
  }

  GridContents image() {
    VtkImage image;
    bool of_cells = false;
    std::uint64_t places = 0;
    for (std::string key = next_key(); !key.empty(); key = next_key()) {
      if (key == "DIMENSIONS") {
        for (std::size_t& count : image.points) count = cursor_.count("number of points along an edge");
      } else if (key == "ORIGIN") {
        for (double& x : image.origin) x = cursor_.coordinate("origin");
      } else if (key == "SPACING" || key == "ASPECT_RATIO") {
        for (int d = 0; d < 3; ++d) image.steps(d, d) = cursor_.coordinate("spacing");
      } else if (key == "POINT_DATA" || key == "CELL_DATA") {
        of_cells = key == "CELL_DATA";
        places = cursor_.count("number of values");
      } else if (key == "SCALARS") {
        scalars(image, places, of_cells);
      } else if (key == "FIELD") {
        fields([&](std::string name, std::uint64_t components, std::vector<double> values) {
          if (components == 1) image.arrays.push_back({std::move(name), std::move(values), of_cells});
        });
      } else {
        skip(key, places);
      }
    }
    return field_of(image, array_, file_);
  }

  void scalars(VtkImage& image, std::uint64_t places, bool of_cells) {
    std::string name(cursor_.word());
    const std::string_view type_name = cursor_.word();
    const std::optional<VtkType> type = vtk_type(type_name);
    if (!type) cursor_.fail(fmt::format("the type {} is none of numbers", mesh::quoted(type_name)));
    std::int64_t components = 1;
    const std::string_view rest = cursor_.line();
    if (rest.find_first_not_of(" \t") != rest.npos)
      components = ValueCursor(rest, file_).integer("number of components");
    if (components < 1 || components > 1000) cursor_.fail(fmt::format("there are {} components", components));
    if (upper(cursor_.next_word()) == "LOOKUP_TABLE") cursor_.word(), cursor_.line();
    std::vector<double> values = numbers(places, static_cast<std::uint64_t>(components), *type, "scalars");
    if (components == 1) image.arrays.push_back({std::move(name), std::move(values), of_cells});
  }

  // FIELD name n, then for each array: name components tuples type, and its values.
  template <typename Take>
  void fields(const Take& take) {
    cursor_.word();
    const std::uint64_t count = cursor_.count("number of arrays");
    cursor_.line();
    for (std::uint64_t i = 0; i < count; ++i) {
      skip_metadata();
      std::string name(cursor_.word());
      const std::uint64_t components = cursor_.count("number of components"),
                          tuples = cursor_.count("number of values");
      const std::string_view type_name = cursor_.next_word();
      if (type_name == "string" && !binary_) {
        cursor_.line();
        for (std::uint64_t line = 0; line < components * tuples && !cursor_.at_end(); ++line) cursor_.line();
        continue;
      }
      const VtkType type = this->type();
      take(std::move(name), components, numbers(tuples, components, type, "values of an array"));
    }
  }

  void skip_metadata() {
    while (upper(cursor_.next_word()) == "METADATA") {
      cursor_.word();
      cursor_.line();
      while (cursor_.remaining() > 0 && cursor_.line().find_first_not_of(" \t") != std::string_view::npos)
        continue;
    }
  }

  std::string next_key() {
    skip_metadata();
    return upper(cursor_.word());
  }

  void skip(const std::string& key, std::uint64_t places = 0) {
    const auto pass = [&](std::uint64_t components, bool named_type) {
      cursor_.word();  // its name
      const VtkType type = named_type ? this->type() : VtkType::uint8;
      if (!named_type) cursor_.line();
      numbers(places, components, type, "attributes");
    };
    if (key == "FIELD") return fields([](const std::string&, std::uint64_t, const std::vector<double>&) {});
    if (key == "VECTORS" || key == "NORMALS") return pass(3, true);
    if (key == "TENSORS") return pass(9, true);
    if (key == "LOOKUP_TABLE") {
      cursor_.word();
      const std::uint64_t size = cursor_.count("size of a table");
      cursor_.line();
      numbers(size, 4, VtkType::uint8, "table of colours");
      return;
    }
    cursor_.fail(fmt::format("{} is not known here", mesh::quoted(key)));
  }

  // The type that ends a line.
  VtkType type() {
    const std::string_view name = cursor_.word();
    const std::optional<VtkType> type = vtk_type(name);
    if (!type) cursor_.fail(fmt::format("the type {} is none of numbers", mesh::quoted(name)));
    cursor_.line();
    return *type;
  }

  std::vector<double> numbers(std::uint64_t count, std::uint64_t components, VtkType type, const char* what) {
    const std::uint64_t room = cursor_.remaining();  // no number takes less than a byte
    if (components > room + 1 || count > room / std::max<std::uint64_t>(components, 1) + 1)
      cursor_.fail(fmt::format("the file ends within the {}: {} numbers for each of {} are announced", what,
                               components, count));
    const std::uint64_t size = count * components;
    if (binary_) return vtk_numbers(cursor_.bytes(size * size_of(type), what), type, ByteOrder::big);
    std::vector<double> result;
    result.reserve(std::min<std::uint64_t>(size, room / 2 + 1));
    for (std::uint64_t i = 0; i < size; ++i) result.push_back(cursor_.real(what));
    return result;
  }

  ValueCursor cursor_;
  const std::string& file_;
  const std::string& array_;
  const CellRefusal refuse_ = [this](const std::string& what) { cursor_.fail(what); };
  bool binary_ = false, offsets_ = false;
};

}  // namespace

GridContents read_vtk(std::string_view contents, const std::string& file, const std::string& array) {
  return Reader(contents, file, array).read();
}

bool begins_like_vtk(std::string_view contents) { return contents.starts_with(magic); }

}  // namespace nanocarbon::mesh
