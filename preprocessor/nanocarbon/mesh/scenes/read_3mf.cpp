// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/scenes/read_3mf.h"

#include <fmt/format.h>

#include <array>
#include <map>
#include <memory>
#include <utility>

#include "nanocarbon/core/text_numbers.h"
#include "nanocarbon/mesh/parsing/text_scanner.h"
#include "nanocarbon/mesh/parsing/xml_file.h"
#include "nanocarbon/mesh/scenes/placement.h"
#include "nanocarbon/mesh/scenes/zip_archive.h"

namespace nanocarbon::mesh {
namespace {

// Enough for any print; objects that are made of each other over and over are a bomb.
constexpr std::size_t most_placed = 100'000, most_points = 100'000'000;
constexpr int deepest = 64;

struct Component {
  std::string path, object;
  Placement placement;
  pugi::xml_node node;  // for messages
};
struct Object {
  PolygonSoup mesh;
  std::vector<Component> components;
};
//! One model part of the package: the main one, or one of those that the production extension refers to.
struct Part {
  std::string text;
  std::unique_ptr<XmlFile> xml;
  std::string unit;
  std::map<std::string, Object, std::less<>> objects;
};

class Reader {
 public:
  Reader(std::string_view contents, const std::string& file) : archive_(contents, file), file_(file) {}

  PolygonSoup read() {
    const std::string main = main_part();
    const Part& part = this->part(main);
    soup_.unit = part.unit;
    std::size_t items = 0;
    for (const pugi::xml_node& item : child_of(part.xml->root(), "build").children()) {
      if (local_name(item.name()) != "item") continue;
      ++items;
      place(part, component(part, main, item), Placement::Identity(), 0);
    }
    if (items == 0) part.xml->fail(part.xml->root(), "the file builds nothing: its 'build' has no item");
    if (soup_.faces() == 0)
      part.xml->fail(part.xml->root(), "what the file builds has no triangles", "give a mesh");
    if (placed_ > 1) soup_.notes.push_back(fmt::format("placed {} objects as the file says", placed_));
    return std::move(soup_);
  }

 private:
  // The package says which of its parts is the model.
  std::string main_part() const {
    if (archive_.has("_rels/.rels")) {
      const std::string text = archive_.contents("_rels/.rels");
      const XmlFile xml(text, file_ + ": _rels/.rels");
      for (const pugi::xml_node& node : xml.root().children())
        if (attribute_of(node, "Type").ends_with("/3dmodel"))
          return without_slash(attribute_of(node, "Target"));
    }
    return "3D/3dmodel.model";
  }

  static std::string without_slash(std::string_view path) {
    return std::string(path.starts_with('/') ? path.substr(1) : path);
  }

  const Part& part(const std::string& path) {
    const auto [found, added] = parts_.try_emplace(path);
    Part& part = found->second;
    if (!added) return part;
    part.text = archive_.contents(path);
    part.xml = std::make_unique<XmlFile>(part.text, fmt::format("{}: {}", file_, shown(path)));
    if (local_name(part.xml->root().name()) != "model")
      part.xml->fail(part.xml->root(), "the part is no model of a 3MF file");
    const std::string_view unit = attribute_of(part.xml->root(), "unit");
    part.unit = unit.empty() ? "millimeter" : shown(unit);
    for (const pugi::xml_node& node : child_of(part.xml->root(), "resources").children())
      if (local_name(node.name()) == "object")
        part.objects.emplace(attribute_of(node, "id"), object(part, path, node));
    return part;
  }

  Object object(const Part& part, const std::string& path, const pugi::xml_node& node) {
    Object result;
    if (const pugi::xml_node mesh = child_of(node, "mesh")) result.mesh = read_mesh(*part.xml, mesh);
    for (const pugi::xml_node& child : child_of(node, "components").children())
      if (local_name(child.name()) == "component") result.components.push_back(component(part, path, child));
    return result;
  }

  static PolygonSoup read_mesh(const XmlFile& xml, const pugi::xml_node& mesh) {
    PolygonSoup soup;
    for (const pugi::xml_node& node : child_of(mesh, "vertices").children())
      if (local_name(node.name()) == "vertex")
        soup.points.emplace_back(xml.coordinate(node, "x"), xml.coordinate(node, "y"),
                                 xml.coordinate(node, "z"));
    for (const pugi::xml_node& node : child_of(mesh, "triangles").children()) {
      if (local_name(node.name()) != "triangle") continue;
      for (const char* name : {"v1", "v2", "v3"}) {
        const std::uint64_t vertex = xml.count(node, name);
        if (vertex >= soup.points.size())
          xml.fail(node, fmt::format("a triangle uses vertex {}, but its object has {}, counted from 0",
                                     vertex, soup.points.size()));
        soup.corners.push_back(static_cast<VertexIndex>(vertex));
      }
      soup.close_face();
    }
    return soup;
  }

  Component component(const Part& part, const std::string& path, const pugi::xml_node& node) const {
    const std::string_view elsewhere = attribute_of(node, "path");
    return {elsewhere.empty() ? path : without_slash(elsewhere), std::string(attribute_of(node, "objectid")),
            placement(*part.xml, node), node};
  }

  // Twelve numbers, the rows of a matrix that a row of coordinates is multiplied with.
  static Placement placement(const XmlFile& xml, const pugi::xml_node& node) {
    Placement result = Placement::Identity();
    const std::string_view text = attribute_of(node, "transform");
    if (text.empty()) return result;
    TextScanner scanner(text, xml.file(), {'\0', false});
    std::array<double, 12> m{};
    scanner.next_line();
    for (double& number : m)
      if (read_real(scanner.word(), number) != NumberToken::number || coordinate_fault(number))
        xml.fail(node, fmt::format("the transform {} is not twelve numbers", mesh::quoted(text)));
    if (!scanner.at_line_end())
      xml.fail(node, fmt::format("the transform {} is not twelve numbers", mesh::quoted(text)));
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 3; ++column)
        result.matrix()(column, row) = m[static_cast<std::size_t>(3 * row + column)];
    return result;
  }

  void place(const Part& from, const Component& component, const Placement& outer, int depth) {
    const auto fail = [&](const std::string& what) { from.xml->fail(component.node, what); };
    if (depth > deepest)
      fail(fmt::format("components go more than {} deep: they contain each other", deepest));
    const Part& part = this->part(component.path);
    const auto object = part.objects.find(component.object);
    if (object == part.objects.end())
      fail(fmt::format("there is no object {}", mesh::quoted(component.object)));
    if (part.unit != soup_.unit)
      fail(fmt::format("'{}' is in {}, but the model in {}", component.path, part.unit, soup_.unit));
    const Placement placement = outer * component.placement;
    if (!object->second.mesh.points.empty()) {
      ++placed_;
      if (placed_ > most_placed || soup_.points.size() + object->second.mesh.points.size() > most_points)
        fail("the components of the file multiply to more than can be meant");
      if (!add_placed(soup_, object->second.mesh, placement))
        fail("what is placed has coordinates above 1e50");
    }
    for (const Component& part_of_it : object->second.components) {
      if (++components_ > most_placed) fail("the components of the file multiply to more than can be meant");
      place(part, part_of_it, placement, depth + 1);
    }
  }

  ZipArchive archive_;
  std::string file_;
  std::map<std::string, Part> parts_;
  PolygonSoup soup_;
  std::size_t placed_ = 0, components_ = 0;
};

}  // namespace

PolygonSoup read_3mf(std::string_view contents, const std::string& file) {
  return Reader(contents, file).read();
}

bool begins_like_3mf(std::string_view contents) {
  if (!contents.starts_with(std::string_view("PK\x03\x04", 4))) return false;
  // Names of files are not packed.
  return contents.find(".model") != contents.npos;
}

}  // namespace nanocarbon::mesh
