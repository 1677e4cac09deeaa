// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/scenes/gltf_buffers.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <optional>
#include <utility>

#include "nanocarbon/core/error.h"
#include "nanocarbon/core/text_numbers.h"
#include "nanocarbon/mesh/parsing/base64.h"
#include "nanocarbon/mesh/parsing/byte_order.h"

namespace nanocarbon::mesh {
namespace {

using Json = nlohmann::json;

// "a%20b.bin" is a file named "a b.bin".
std::string percent_decoded(std::string_view uri) {
  const auto digit = [](char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
  };
  std::string result;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool escape =
        uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1]) >= 0 && digit(uri[i + 2]) >= 0;
    result.push_back(escape ? static_cast<char>(16 * digit(uri[i + 1]) + digit(uri[i + 2])) : uri[i]);
    if (escape) i += 2;
  }
  return result;
}

}  // namespace

void fail_in_gltf(const std::string& file, const std::string& place, const std::string& what,
                  const std::string& remedy) {
  throw UserError(Failure::malformed, fmt::format("{}: {}: {}; {}", file, place, what, remedy));
}

GltfFile::GltfFile(std::string_view contents, std::string file) : file_(std::move(file)) {
  const bool binary = contents.starts_with("glTF");
  const std::string_view text = binary ? read_container(contents) : contents;
  try {
    json_ = Json::parse(text);
  } catch (const Json::out_of_range&) {
    fail_in_gltf(file_, "its JSON", "a number is too large");
  } catch (const Json::parse_error& error) {
    const std::size_t byte = error.byte + static_cast<std::size_t>(text.data() - contents.data());
    fail_in_gltf(file_, fmt::format("byte {}", byte),
                 "the JSON of the glTF file is damaged or ends too early");
  }
  if (!json_.is_object()) fail_in_gltf(file_, "byte 0", "the JSON of the glTF file is not an object");
  const auto asset = json_.find("asset");
  const std::string version = asset != json_.end() && asset->is_object() && asset->contains("version") &&
                                      (*asset)["version"].is_string()
                                  ? (*asset)["version"].get<std::string>()
                                  : "";
  if (!version.starts_with("2."))
    fail_in_gltf(file_, "asset", fmt::format("the version of glTF is '{}', not 2", shown(version)),
                 "export it as glTF 2.0");
}

// A header (magic, version, length) and chunks (length, kind, bytes): JSON, then perhaps BIN.
std::string_view GltfFile::read_container(std::string_view contents) {
  const auto fail = [&](std::size_t byte, const std::string& what) {
    fail_in_gltf(file_, fmt::format("byte {}", byte), what);
  };
  const auto number = [&](std::size_t byte) {
    if (contents.size() < byte + 4) fail(contents.size(), "the file ends within a header of a GLB file");
    return std::size_t{load<std::uint32_t>(contents.data() + byte, ByteOrder::little)};
  };
  if (number(4) != 2) fail(4, fmt::format("the GLB file is of version {}, not 2", number(4)));
  std::string_view json;
  for (std::size_t at = 12; at < std::min(contents.size(), number(8));) {
    const std::size_t length = number(at), kind = number(at + 4);
    if (length > contents.size() - at - 8)
      fail(at, fmt::format("a chunk of the GLB file has {} bytes, but the file ends after {}", length,
                           contents.size() - at - 8));
    const std::string_view chunk = contents.substr(at + 8, length);
    if (kind == 0x4E4F534A && json.empty()) json = chunk;
    if (kind == 0x004E4942 && !has_chunk_) chunk_ = chunk, has_chunk_ = true;
    at += 8 + length;
  }
  if (json.empty()) fail(12, "the GLB file has no chunk of JSON");
  return json;
}

const Json& GltfFile::element(const char* array, std::uint64_t index) const {
  const auto found = json_.find(array);
  const std::size_t size = found != json_.end() && found->is_array() ? found->size() : 0;
  if (index >= size || !(*found)[index].is_object())
    fail_in_gltf(file_, fmt::format("{}[{}]", array, index),
                 fmt::format("there is no such element of {}", size));
  return (*found)[index];
}

std::uint64_t GltfFile::count(const Json& object, const char* key, const std::string& place) const {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number_unsigned())
    fail_in_gltf(file_, place, fmt::format("there is no whole number '{}'", key));
  return found->get<std::uint64_t>();
}

std::uint64_t GltfFile::count(const Json& object, const char* key, const std::string& place,
                              std::uint64_t otherwise) const {
  return object.contains(key) ? count(object, key, place) : otherwise;
}

std::string_view GltfFile::view(std::uint64_t index) {
  const std::string place = fmt::format("bufferViews[{}]", index);
  const Json& view = element("bufferViews", index);
  const std::string_view bytes = buffer(count(view, "buffer", place));
  const std::uint64_t begin = count(view, "byteOffset", place, 0), length = count(view, "byteLength", place);
  if (begin > bytes.size() || length > bytes.size() - begin)
    fail_in_gltf(file_, place,
                 fmt::format("bytes {} to {} of a buffer of {}", begin, begin + length, bytes.size()));
  return bytes.substr(begin, length);
}

std::string_view GltfFile::buffer(std::uint64_t index) {
  const std::string place = fmt::format("buffers[{}]", index);
  const Json& buffer = element("buffers", index);
  const std::uint64_t length = count(buffer, "byteLength", place);
  if (index >= known_.size()) known_.resize(index + 1), unpacked_.resize(index + 1);
  const auto uri = buffer.find("uri");
  std::string_view bytes;
  if (uri == buffer.end()) {
    if (index != 0 || !has_chunk_) fail_in_gltf(file_, place, "the buffer has no data");
    bytes = chunk_;
  } else {
    if (!uri->is_string()) fail_in_gltf(file_, place, "its 'uri' is no text");
    if (!known_[index]) {
      const std::string& text = uri->get_ref<const std::string&>();
      if (text.starts_with("data:")) {
        const std::size_t comma = text.find(";base64,");
        const auto decoded =
            comma == text.npos ? std::nullopt : from_base64(std::string_view(text).substr(comma + 8));
        if (!decoded) fail_in_gltf(file_, place, "its 'uri' is not data in base64");
        unpacked_[index] = *decoded;
      } else {
        unpacked_[index] = external(text, place);
      }
      known_[index] = true;
    }
    bytes = unpacked_[index];
  }
  if (length > bytes.size())
    fail_in_gltf(file_, place, fmt::format("the buffer has {} bytes, not {}", bytes.size(), length));
  return bytes.substr(0, length);
}

std::string GltfFile::external(const std::string& uri, const std::string& place) const {
  const std::filesystem::path name = percent_decoded(uri);
  const auto fail = [&](const std::string& what) {
    throw UserError(
        Failure::unreadable,
        fmt::format("{}: {}: the file '{}' {}; put it beside the glTF file, or export a GLB file, which "
                    "has everything in it",
                    file_, place, shown(uri), what));
  };
  if (name.empty() || name.is_absolute() || uri.find("://") != uri.npos) fail("is not one beside it");
  const std::filesystem::path path = std::filesystem::path(file_).parent_path() / name;
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) fail("is not there");
  if (std::filesystem::file_size(path, error) > std::uintmax_t{4} << 30 || error)
    fail("is larger than 4 GiB");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) fail("cannot be opened");
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace nanocarbon::mesh
