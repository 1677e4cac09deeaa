// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/page/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <ostream>
#include <span>

#include "nanocarbon/core/error.h"
#include "nanocarbon/page/page_assets.h"

namespace nanocarbon::page {
namespace {

using Json = nlohmann::ordered_json;

std::string base64(std::string_view bytes) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  const auto byte = [&](std::size_t k) {
    return k < bytes.size() ? static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[k])) : 0u;
  };
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    const std::uint32_t three = (byte(k) << 16) | (byte(k + 1) << 8) | byte(k + 2);
    text += letters[(three >> 18) & 63];
    text += letters[(three >> 12) & 63];
    text += k + 1 < bytes.size() ? letters[(three >> 6) & 63] : '=';
    text += k + 2 < bytes.size() ? letters[three & 63] : '=';
  }
  return text;
}

// Arrays on their way into the page: each different one once, little-endian.
class PageData {
 public:
  template <typename Number>
  std::string add(const std::vector<Number>& values) {
    std::string bytes(values.size() * sizeof(Number), '\0');
    if (!values.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
    const auto [found, is_new] = names_.emplace(std::move(bytes), std::to_string(names_.size()));
    return found->second;
  }

  void write(std::ostream& out) const {
    for (const auto& [bytes, name] : names_)
      out << "<script type=\"application/octet-stream\" id=\"data-" << name << "\">" << base64(bytes)
          << "</script>\n";
  }

 private:
  std::map<std::string, std::string> names_;  // by contents
};

constexpr double steps = 65534.0;  // 65535 means not-a-number

std::uint16_t quantised(double value, double from, double step) {
  if (!std::isfinite(value)) return 65535;
  return static_cast<std::uint16_t>(step > 0.0 ? std::lround((value - from) / step) : 0);
}

Json points_json(std::span<const Vec3> points, PageData& data, const char* key) {
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();
  if (!points.empty()) low = high = points.front();
  for (const Vec3& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const Vec3 step = (high - low) / steps;
  std::vector<std::uint16_t> packed;
  packed.reserve(3 * points.size());
  for (const Vec3& p : points)
    for (int d = 0; d < 3; ++d) packed.push_back(quantised(p[d], low[d], step[d]));
  return {{"format", "uint16"},
          {key, data.add(packed)},
          {"from", {low.x(), low.y(), low.z()}},
          {"step", {step.x(), step.y(), step.z()}}};
}

Json positions_json(const std::vector<Vec3>& positions, bool exactly, PageData& data) {
  if (!exactly) return points_json(positions, data, "data");
  std::vector<float> values;
  values.reserve(3 * positions.size());
  for (const Vec3& p : positions)
    for (int d = 0; d < 3; ++d) values.push_back(static_cast<float>(p[d]));
  return {{"format", "float32"}, {"data", data.add(values)}};
}

Json column_json(const PageColumn& column, PageData& data) {
  Json json = {{"name", column.name}, {"unit", column.unit}, {"category", column.category}};
  if (!column.category.empty()) {
    std::vector<std::uint8_t> values;
    values.reserve(column.values.size());
    for (const float v : column.values)
      values.push_back(static_cast<std::uint8_t>(std::clamp(v, 0.0f, 255.0f)));
    json.update({{"format", "uint8"}, {"data", data.add(values)}});
    return json;
  }
  double low = 0.0, high = 0.0;
  bool any = false;
  for (const float v : column.values)
    if (std::isfinite(v)) {
      low = any ? std::min<double>(low, v) : v;
      high = any ? std::max<double>(high, v) : v;
      any = true;
    }
  const double step = (high - low) / steps;
  std::vector<std::uint16_t> packed;
  packed.reserve(column.values.size());
  for (const float v : column.values) packed.push_back(quantised(v, low, step));
  json.update({{"format", "uint16"}, {"data", data.add(packed)}, {"from", low}, {"step", step}});
  return json;
}

Json cell_json(const Cell& cell) {
  Json vectors = Json::array();
  for (int k = 0; k < 3; ++k) vectors.push_back({cell.vectors(0, k), cell.vectors(1, k), cell.vectors(2, k)});
  return {{"vectors", vectors},
          {"origin", {cell.origin.x(), cell.origin.y(), cell.origin.z()}},
          {"periodic", cell.periodic}};
}

Json frame_json(const PageFrame& frame, bool exactly, PageData& data) {
  const Molecule& m = frame.molecule;
  Json json = {{"label", frame.label}, {"positions", positions_json(m.positions, exactly, data)}};
  std::vector<std::uint32_t> ends;
  std::vector<std::int8_t> images;
  bool crossing = false;
  for (const Bond& bond : m.bonds) {
    ends.insert(ends.end(), {bond.first, bond.second});
    for (const std::int32_t i : bond.image) {
      images.push_back(static_cast<std::int8_t>(std::clamp(i, -127, 127)));
      crossing = crossing || i != 0;
    }
  }
  json["bonds"] = data.add(ends);
  if (crossing && m.cell) json["images"] = data.add(images);
  if (m.rings.size() > 0)
    json["rings"] = {{"offsets", data.add(m.rings.offsets)}, {"atoms", data.add(m.rings.atoms)}};
  if (m.cell) json["cell"] = cell_json(*m.cell);
  Json columns = Json::array();
  for (const PageColumn& column : frame.columns) columns.push_back(column_json(column, data));
  json["columns"] = columns;
  return json;
}

Json plot_json(const PagePlot& plot) {
  Json json = {{"title", plot.title}, {"label", plot.label}, {"kind", plot.bars ? "bars" : "line"},
               {"width", plot.width}, {"x", plot.x},         {"y", plot.y}};
  if (plot.ring_colours) json["colours"] = true;
  return json;
}

Json mesh_json(const TriangleMesh& mesh, PageData& data) {
  Json json = points_json(mesh.points, data, "points");
  std::vector<std::uint32_t> corners;
  corners.reserve(3 * mesh.triangles.size());
  for (const Triangle& t : mesh.triangles)
    for (const auto v : t) corners.push_back(static_cast<std::uint32_t>(v));
  json["triangles"] = data.add(corners);
  return json;
}

Json contents_json(const PageContents& contents, PageData& data) {
  constexpr std::size_t most_triangles = 300000;
  constexpr std::array<const char*, 3> moods = {"good", "doubt", "bad"};
  Json facts = Json::array();
  for (const auto& [name, value] : contents.facts) facts.push_back({name, value});
  Json json = {
      {"title", contents.title},
      {"command", contents.command},
      {"verdict", {{"text", contents.verdict}, {"kind", moods[static_cast<std::size_t>(contents.mood)]}}}};
  if (contents.mesh && contents.mesh->triangles.size() <= most_triangles)
    json["mesh"] = mesh_json(*contents.mesh, data);
  else if (contents.mesh)
    facts.push_back({"mesh", fmt::format("left out: its {} triangles would make this page too large",
                                         contents.mesh->triangles.size())});
  json["facts"] = facts;
  json["plots"] = Json::array();
  for (const PagePlot& plot : contents.plots) json["plots"].push_back(plot_json(plot));
  json["frames"] = Json::array();
  for (const PageFrame& frame : contents.frames)
    json["frames"].push_back(frame_json(frame, contents.frames.size() == 1, data));
  const auto& columns = contents.frames.front().columns;
  const auto element = std::find_if(columns.begin(), columns.end(),
                                    [](const PageColumn& column) { return column.category == "element"; });
  json["elementColumn"] = element - columns.begin();
  json["colourColumn"] = contents.colour_column;
  if (!contents.ids.empty()) {
    std::vector<std::int32_t> ids;
    ids.reserve(contents.ids.size());
    for (const std::int64_t id : contents.ids) ids.push_back(static_cast<std::int32_t>(id));
    json["ids"] = data.add(ids);
  }
  json["defects"] = Json::array();
  for (const PagePlace& place : contents.defects)
    json["defects"].push_back({{"kind", place.kind}, {"atoms", place.atoms}});
  return json;
}

// Inside of a script element only its end tag must not occur.
std::string script_text(std::string text) {
  for (std::size_t at = text.find("</"); at != std::string::npos; at = text.find("</", at + 3))
    text.insert(at + 1, "\\");
  return text;
}

std::string html_text(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else
      result += c;
  }
  return result;
}

}  // namespace

void require_pages() {
  if (page_assets().three.empty())
    throw UserError(
        Failure::unsuitable,
        "--page: this program was built without three.js, which pages need; install libjs-three and build "
        "it again");
}

void write_page(std::ostream& out, const PageContents& contents) {
  require_pages();
  const PageAssets assets = page_assets();
  PageData data;
  const std::string json = script_text(
      contents_json(contents, data).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  std::string_view rest = assets.html;
  while (!rest.empty()) {
    const std::size_t at = rest.find('@');
    const std::size_t end = at == std::string_view::npos ? at : rest.find('@', at + 1);
    if (end == std::string_view::npos) break;
    out << rest.substr(0, at);
    const std::string_view name = rest.substr(at + 1, end - at - 1);
    if (name == "TITLE") out << html_text(contents.title);
    if (name == "CSS") out << assets.css;
    if (name == "LICENCE") out << html_text(assets.licence);
    if (name == "CONTENTS") out << json;
    if (name == "DATA") data.write(out);
    if (name == "THREE") out << assets.three;
    if (name == "VIEWER") out << assets.viewer;
    rest = rest.substr(end + 1);
  }
  out << rest;
}

}  // namespace nanocarbon::page
