// SPDX-License-Identifier: GPL-2.0-or-later
// Small glTF and 3MF files, written from their specifications.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::test {

//! Text with every `from` in it replaced.
std::string replaced(std::string text, std::string_view from, std::string_view to);

//! Bytes as base64 (RFC 4648).
std::string base64(std::string_view bytes);

//! A ZIP archive whose files are stored as they are.
std::string stored_zip(const std::vector<std::pair<std::string, std::string>>& files);

//! The buffer of a mesh in a glTF file: positions in floats, then indices of four bytes.
std::string gltf_buffer(const TriangleMesh& mesh);
//! The JSON of a glTF file with one mesh in that buffer and the given scene ("\"nodes\": [...]", and so on).
//! \param uri of the buffer, with quotes; empty for the chunk of a GLB file
std::string gltf_json(const TriangleMesh& mesh, const std::string& uri,
                      const std::string& scene = R"("scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}])");
//! A GLB file of JSON and a binary chunk.
std::string glb(const std::string& json, const std::string& buffer);
//! A GLB file of a mesh.
std::string glb(const TriangleMesh& mesh);

//! The <mesh> of a 3MF file.
std::string mesh_3mf(const TriangleMesh& mesh);
//! A 3MF file with resources and a build.
std::string file_3mf(const std::string& resources, const std::string& build,
                     const std::string& unit = "millimeter");
//! A 3MF file of a mesh.
std::string file_3mf(const TriangleMesh& mesh);

}  // namespace nanocarbon::test
