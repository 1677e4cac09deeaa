// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/scenes/read_gltf.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "nanocarbon/mesh/join_points.h"
#include "nanocarbon/mesh/parsing/text_scanner.h"
#include "nanocarbon/mesh/scenes/gltf_accessor.h"
#include "nanocarbon/mesh/scenes/gltf_buffers.h"
#include "nanocarbon/mesh/scenes/placement.h"

namespace nanocarbon::mesh {
namespace {

using Json = nlohmann::json;

// More than this is made of a file by naming the same data over and over.
constexpr std::size_t most_points = 100'000'000;

// What a file may require of its reader: pictures alone, and what is read.
constexpr std::array harmless = {"KHR_mesh_quantization", "KHR_texture_",  "KHR_materials_", "KHR_lights_",
                                 "EXT_texture_",          "MSFT_texture_", "KHR_xmp"};

class Reader {
 public:
  Reader(std::string_view contents, const std::string& file) : file_(contents, file) {}

  PolygonSoup read() {
    require_known_extensions();
    soup_.unit = "metre";
    const std::vector<std::uint64_t> roots = root_nodes();
    for (const std::uint64_t root : roots) place(root);
    if (soup_.faces() == 0)
      fail_in_gltf(file_.file(), "scene", "there are no triangles in it", "give a mesh");
    if (passed_over_ > 0)
      soup_.notes.push_back(fmt::format("skipped {} primitives that are points or lines", passed_over_));
    if (joined_ > 0)
      soup_.notes.push_back(fmt::format("joined {} glTF vertices at the same places", joined_));
    if (placed_ > 1) soup_.notes.push_back(fmt::format("placed {} objects as the file says", placed_));
    if (moves_) soup_.notes.push_back("skins and morph targets are left as they are at rest");
    return std::move(soup_);
  }

 private:
  void require_known_extensions() const {
    const auto required = file_.json().find("extensionsRequired");
    if (required == file_.json().end() || !required->is_array()) return;
    for (const Json& name : *required) {
      const std::string text = name.is_string() ? name.get<std::string>() : "";
      if (std::any_of(harmless.begin(), harmless.end(), [&](const char* k) { return text.starts_with(k); }))
        continue;
      fail_in_gltf(file_.file(), "extensionsRequired",
                   fmt::format("the file needs the extension {}", mesh::quoted(text)),
                   "export it without compression of meshes (Draco, meshopt) and without instancing");
    }
  }

  // Those of the scene; without one, all that are no children.
  std::vector<std::uint64_t> root_nodes() const {
    const Json& json = file_.json();
    std::vector<std::uint64_t> roots;
    const auto scenes = json.find("scenes");
    if (scenes != json.end() && scenes->is_array() && !scenes->empty()) {
      const std::uint64_t scene = file_.count(json, "scene", "scene", 0);
      const std::string place = fmt::format("scenes[{}]", scene);
      return numbers(file_.element("scenes", scene), "nodes", place);
    }
    const auto nodes = json.find("nodes");
    const std::size_t count = nodes != json.end() && nodes->is_array() ? nodes->size() : 0;
    std::vector<bool> child(count, false);
    for (std::size_t node = 0; node < count; ++node)
      for (const std::uint64_t c :
           numbers(file_.element("nodes", node), "children", fmt::format("nodes[{}]", node)))
        if (c < count) child[c] = true;
    for (std::size_t node = 0; node < count; ++node)
      if (!child[node]) roots.push_back(node);
    return roots;
  }

  std::vector<std::uint64_t> numbers(const Json& object, const char* key, const std::string& place) const {
    std::vector<std::uint64_t> result;
    const auto found = object.find(key);
    if (found == object.end()) return result;
    for (const Json& number : *found) {
      if (!number.is_number_unsigned())
        fail_in_gltf(file_.file(), place, fmt::format("'{}' is not a list of whole numbers", key));
      result.push_back(number.get<std::uint64_t>());
    }
    return result;
  }

  // A node and all below it. They are a forest: no node has two parents.
  void place(std::uint64_t root) {
    std::vector<std::pair<std::uint64_t, Placement>> open = {{root, Placement::Identity()}};
    while (!open.empty()) {
      const auto [index, outer] = open.back();
      open.pop_back();
      const std::string where = fmt::format("nodes[{}]", index);
      const Json& node = file_.element("nodes", index);
      if (index >= seen_.size()) seen_.resize(index + 1, false);
      if (seen_[index]) fail_in_gltf(file_.file(), where, "the node is in the scene more than once");
      seen_[index] = true;
      const Placement placement = outer * placement_of(node, where);
      if (node.contains("mesh")) {
        const PolygonSoup& object = mesh(file_.count(node, "mesh", where));
        moves_ = moves_ || node.contains("skin");
        if (object.faces() > 0) ++placed_;
        if (soup_.points.size() + object.points.size() > most_points)
          fail_in_gltf(file_.file(), where, "the nodes have more vertices than can be meant");
        if (!add_placed(soup_, object, placement))
          fail_in_gltf(file_.file(), where, "what is placed has coordinates above 1e50");
      }
      for (const std::uint64_t child : numbers(node, "children", where)) open.emplace_back(child, placement);
    }
  }

  template <std::size_t count>
  bool reals(const Json& node, const char* key, const std::string& place,
             std::array<double, count>& values) const {
    const auto found = node.find(key);
    if (found == node.end()) return false;
    const bool right = found->is_array() && found->size() == count &&
                       std::all_of(found->begin(), found->end(), [](const Json& n) {
                         return n.is_number() && !coordinate_fault(n.get<double>());
                       });
    if (!right) fail_in_gltf(file_.file(), place, fmt::format("'{}' is not {} finite numbers", key, count));
    for (std::size_t i = 0; i < count; ++i) values[i] = (*found)[i].template get<double>();
    return true;
  }

  Placement placement_of(const Json& node, const std::string& place) const {
    Placement result = Placement::Identity();
    std::array<double, 16> m{};
    if (reals(node, "matrix", place, m)) {
      for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row)
          result.matrix()(row, column) = m[static_cast<std::size_t>(4 * column + row)];
      return result;
    }
    std::array<double, 3> t = {0, 0, 0}, s = {1, 1, 1};
    std::array<double, 4> r = {0, 0, 0, 1};
    reals(node, "translation", place, t);
    reals(node, "scale", place, s);
    reals(node, "rotation", place, r);
    const Eigen::Quaterniond turn(r[3], r[0], r[1], r[2]);
    if (!(turn.norm() > 1e-6)) fail_in_gltf(file_.file(), place, "its rotation is zero");
    return result.translate(Vec3(t[0], t[1], t[2])).rotate(turn.normalized()).scale(Vec3(s[0], s[1], s[2]));
  }

  const PolygonSoup& mesh(std::uint64_t index) {
    const auto [found, added] = meshes_.try_emplace(index);
    PolygonSoup& soup = found->second;
    if (!added) return soup;
    const std::string place = fmt::format("meshes[{}]", index);
    const Json& mesh = file_.element("meshes", index);
    const auto primitives = mesh.find("primitives");
    if (primitives == mesh.end() || !primitives->is_array())
      fail_in_gltf(file_.file(), place, "it has no primitives");
    for (std::size_t i = 0; i < primitives->size(); ++i)
      add_primitive((*primitives)[i], fmt::format("{}.primitives[{}]", place, i), soup);
    const CoincidentPoints coincident = coincident_points(soup.points);
    joined_ += coincident.duplicates;
    join(soup, coincident);
    return soup;
  }

  void add_primitive(const Json& primitive, const std::string& place, PolygonSoup& soup) {
    if (!primitive.is_object()) fail_in_gltf(file_.file(), place, "it is not an object");
    const std::uint64_t mode = file_.count(primitive, "mode", place, 4);
    if (mode > 6) fail_in_gltf(file_.file(), place, fmt::format("there is no mode {}", mode));
    if (mode < 4) {
      ++passed_over_;
      return;
    }
    moves_ = moves_ || primitive.contains("targets");
    const auto attributes = primitive.find("attributes");
    if (attributes == primitive.end() || !attributes->is_object() || !attributes->contains("POSITION"))
      fail_in_gltf(file_.file(), place, "it has no positions");
    const std::vector<Vec3> points = gltf_positions(file_, file_.count(*attributes, "POSITION", place));
    const auto first = static_cast<VertexIndex>(soup.points.size());
    if (soup.points.size() + points.size() > most_points)
      fail_in_gltf(file_.file(), place, "the primitives have more vertices than can be meant");
    soup.points.insert(soup.points.end(), points.begin(), points.end());
    std::vector<std::uint64_t> order;
    if (primitive.contains("indices"))
      order = gltf_indices(file_, file_.count(primitive, "indices", place));
    else
      for (std::size_t i = 0; i < points.size(); ++i) order.push_back(i);
    for (const std::uint64_t v : order)
      if (v >= points.size())
        fail_in_gltf(file_.file(), place, fmt::format("a triangle uses vertex {} of {}", v, points.size()));
    const auto face = [&](std::size_t a, std::size_t b, std::size_t c) {
      for (const std::size_t corner : {a, b, c})
        soup.corners.push_back(first + static_cast<VertexIndex>(order[corner]));
      soup.close_face();
    };
    if (mode == 4 && order.size() % 3 != 0)
      fail_in_gltf(file_.file(), place,
                   fmt::format("{} corners are no whole number of triangles", order.size()));
    if (mode == 4)
      for (std::size_t i = 0; i + 2 < order.size(); i += 3) face(i, i + 1, i + 2);
    if (mode == 5)  // a strip: every other triangle is wound the other way
      for (std::size_t i = 0; i + 2 < order.size(); ++i) face(i, i + 1 + i % 2, i + 2 - i % 2);
    if (mode == 6)
      for (std::size_t i = 1; i + 1 < order.size(); ++i) face(0, i, i + 1);
  }

  GltfFile file_;
  PolygonSoup soup_;
  std::map<std::uint64_t, PolygonSoup> meshes_;
  std::vector<bool> seen_;
  std::size_t placed_ = 0, joined_ = 0, passed_over_ = 0;
  bool moves_ = false;
};

}  // namespace

PolygonSoup read_gltf(std::string_view contents, const std::string& file) {
  return Reader(contents, file).read();
}

bool begins_like_gltf(std::string_view contents) {
  if (contents.starts_with("glTF")) return true;
  const std::size_t begin = contents.find_first_not_of(" \t\r\n");
  return begin != contents.npos && contents[begin] == '{' && contents.find("\"asset\"") != contents.npos;
}

}  // namespace nanocarbon::mesh
