// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace nanocarbon::mesh {

//! What in a glTF file is wrong, and where: buffers[0], accessors[3], ...
//! \throw UserError (malformed)
[[noreturn]] void fail_in_gltf(const std::string& file, const std::string& place, const std::string& what,
                               const std::string& remedy = "repair the file or export it again");

//! The JSON of a glTF file and its buffers.
class GltfFile {
 public:
  //! \param contents have to stay as long as this
  //! \throw UserError (malformed, unreadable)
  GltfFile(std::string_view contents, std::string file);

  const nlohmann::json& json() const { return json_; }
  const std::string& file() const { return file_; }

  //! An element of one of the arrays at the top ("nodes", "meshes", ...), which has to be there and an object.
  const nlohmann::json& element(const char* array, std::uint64_t index) const;
  //! A whole number from 0 on in an object.
  std::uint64_t count(const nlohmann::json& object, const char* key, const std::string& place) const;
  //! The same, which may be missing.
  std::uint64_t count(const nlohmann::json& object, const char* key, const std::string& place,
                      std::uint64_t otherwise) const;
  //! The bytes of a buffer view.
  std::string_view view(std::uint64_t index);

 private:
  std::string_view read_container(std::string_view contents);
  std::string_view buffer(std::uint64_t index);
  std::string external(const std::string& uri, const std::string& place) const;

  std::string file_;
  nlohmann::json json_;
  std::string_view chunk_;  // GLB's binary one
  bool has_chunk_ = false;
  std::vector<std::string> unpacked_;  // of each buffer, where it is not the chunk
  std::vector<bool> known_;
};

}  // namespace nanocarbon::mesh
