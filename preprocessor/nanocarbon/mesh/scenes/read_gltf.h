// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "nanocarbon/mesh/polygon_soup.h"

namespace nanocarbon::mesh {

//! \brief Reads the triangles of a glTF 2.0 file (text or GLB): those of its scene, each node where it is placed.
//! \details Lengths are in metres. The vertices of a node that are at the same place are one, since glTF has a vertex
//! for each normal and colour. Buffers may be in the file, in GLB's chunk, or in files beside it; positions may be
//! quantised or sparse. Materials, normals, animations, skins and morph targets are passed over, points and lines with
//! a note. Meshes compressed by Draco or meshopt are refused.
//! \param file path, for messages and for the folder of files beside it
//! \throw UserError (malformed) naming what of the file is wrong, (unreadable) for a file beside it
PolygonSoup read_gltf(std::string_view contents, const std::string& file);

//! Whether contents are those of a GLB file, or JSON with glTF's 'asset'.
bool begins_like_gltf(std::string_view contents);

}  // namespace nanocarbon::mesh
