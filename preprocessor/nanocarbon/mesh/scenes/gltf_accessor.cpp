// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/scenes/gltf_accessor.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>

#include "nanocarbon/mesh/parsing/byte_order.h"
#include "nanocarbon/mesh/parsing/text_scanner.h"

namespace nanocarbon::mesh {
namespace {

using Json = nlohmann::json;

// Numbers that stand in a buffer view, some each stride.
struct Columns {
  std::string_view bytes;
  std::uint64_t kind = 0, components = 0, count = 0, stride = 0;
  bool normalised = false;

  double operator()(std::uint64_t row, std::uint64_t component) const {
    const char* at = bytes.data() + row * stride + component * size_of(kind);
    switch (kind) {
      case 5120:
        return scaled<std::int8_t>(at);
      case 5121:
        return scaled<std::uint8_t>(at);
      case 5122:
        return scaled<std::int16_t>(at);
      case 5123:
        return scaled<std::uint16_t>(at);
      case 5125:
        return scaled<std::uint32_t>(at);
      default:
        return load<float>(at, ByteOrder::little);
    }
  }

  static std::uint64_t size_of(std::uint64_t kind) {
    if (kind == 5120 || kind == 5121) return 1;
    return kind == 5122 || kind == 5123 ? 2 : kind == 5125 || kind == 5126 ? 4 : 0;
  }

 private:
  template <typename Integer>
  double scaled(const char* at) const {
    const double value = load<Integer>(at, ByteOrder::little);
    return normalised ? std::max(value / std::numeric_limits<Integer>::max(), -1.0) : value;
  }
};

// Numbers that a view holds from a byte on; `stated` is what says how many there are, `of` in which buffer view.
Columns columns(GltfFile& file, const Json& of, std::uint64_t kind, std::uint64_t components,
                std::uint64_t count, const std::string& place) {
  Columns result{{}, kind, components, count};
  if (Columns::size_of(kind) == 0)
    fail_in_gltf(file.file(), place, fmt::format("there are no numbers of type {}", kind));
  if (!of.contains("bufferView")) fail_in_gltf(file.file(), place, "it has no data: no buffer view");
  const std::uint64_t index = file.count(of, "bufferView", place);
  const std::string_view bytes = file.view(index);
  const std::uint64_t row = Columns::size_of(kind) * components,
                      begin = file.count(of, "byteOffset", place, 0);
  result.stride = file.count(file.element("bufferViews", index), "byteStride", place, row);
  if (result.stride < row || result.stride > 1024)
    fail_in_gltf(file.file(), place,
                 fmt::format("its elements are {} bytes apart, but have {}", result.stride, row));
  if (begin > bytes.size()) fail_in_gltf(file.file(), place, "it begins after its buffer view");
  result.bytes = bytes.substr(begin);
  const std::uint64_t room = result.bytes.size() < row ? 0 : (result.bytes.size() - row) / result.stride + 1;
  if (count > room)
    fail_in_gltf(file.file(), place,
                 fmt::format("it has {} elements, but its buffer view holds {}", count, room));
  return result;
}

Columns columns_of(GltfFile& file, std::uint64_t index, const char* type, std::uint64_t components) {
  const std::string place = fmt::format("accessors[{}]", index);
  const Json& accessor = file.element("accessors", index);
  const auto found = accessor.find("type");
  if (found == accessor.end() || !found->is_string() || found->get_ref<const std::string&>() != type)
    fail_in_gltf(file.file(), place, fmt::format("its type is not {}", type));
  Columns result = columns(file, accessor, file.count(accessor, "componentType", place), components,
                           file.count(accessor, "count", place), place);
  const auto normalised = accessor.find("normalized");
  result.normalised = normalised != accessor.end() && normalised->is_boolean() && normalised->get<bool>();
  return result;
}

// Of a sparse accessor some elements stand elsewhere.
void replace_sparse(GltfFile& file, std::uint64_t index, std::vector<Vec3>& points) {
  const std::string place = fmt::format("accessors[{}].sparse", index);
  const Json& accessor = file.element("accessors", index);
  const auto sparse = accessor.find("sparse");
  if (sparse == accessor.end()) return;
  if (!sparse->is_object() || !sparse->contains("indices") || !sparse->contains("values") ||
      !(*sparse)["indices"].is_object() || !(*sparse)["values"].is_object())
    fail_in_gltf(file.file(), place, "it has no indices and values");
  const std::uint64_t count = file.count(*sparse, "count", place);
  const Json& rows = (*sparse)["indices"];
  const Columns where = columns(file, rows, file.count(rows, "componentType", place), 1, count, place);
  const Columns values =
      columns(file, (*sparse)["values"], file.count(accessor, "componentType", place), 3, count, place);
  for (std::uint64_t i = 0; i < count; ++i) {
    const double row = where(i, 0);
    if (!(row >= 0 && row < static_cast<double>(points.size())))
      fail_in_gltf(file.file(), place, fmt::format("element {} of {}", row, points.size()));
    points[static_cast<std::size_t>(row)] = Vec3(values(i, 0), values(i, 1), values(i, 2));
  }
}

}  // namespace

std::vector<Vec3> gltf_positions(GltfFile& file, std::uint64_t accessor) {
  const Columns rows = columns_of(file, accessor, "VEC3", 3);
  std::vector<Vec3> points;
  points.reserve(rows.count);
  for (std::uint64_t i = 0; i < rows.count; ++i) points.emplace_back(rows(i, 0), rows(i, 1), rows(i, 2));
  replace_sparse(file, accessor, points);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (const double x : points[i])
      if (const char* fault = coordinate_fault(x))
        fail_in_gltf(file.file(), fmt::format("accessors[{}]", accessor),
                     fmt::format("a coordinate of vertex {} {}", i, fault));
  return points;
}

std::vector<std::uint64_t> gltf_indices(GltfFile& file, std::uint64_t accessor) {
  const Columns rows = columns_of(file, accessor, "SCALAR", 1);
  if (rows.kind != 5121 && rows.kind != 5123 && rows.kind != 5125)
    fail_in_gltf(file.file(), fmt::format("accessors[{}]", accessor),
                 "numbers of vertices are no unsigned integers");
  std::vector<std::uint64_t> indices;
  indices.reserve(rows.count);
  for (std::uint64_t i = 0; i < rows.count; ++i) indices.push_back(static_cast<std::uint64_t>(rows(i, 0)));
  return indices;
}

}  // namespace nanocarbon::mesh
