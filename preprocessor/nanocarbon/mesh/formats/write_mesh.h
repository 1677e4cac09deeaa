// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <iosfwd>

#include "nanocarbon/mesh/formats/mesh_colours.h"
#include "nanocarbon/mesh/formats/mesh_format.h"
#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

struct MeshFileOptions {
  bool text = false;  //!< PLY and STL as text; OFF and OBJ always are
  const MeshColours* colours =
      nullptr;  //!< for PLY (vertices and edges) and OFF (vertices); others have none
};

//! Writes a mesh to a binary stream.
void write_mesh(std::ostream& out, MeshFormat format, const TriangleMesh& mesh,
                const MeshFileOptions& options = {});

//! \brief Writes a mesh as OFF, OBJ, PLY or STL, whichever the path's extension says; whole or not at all.
//! \details Coordinates read back to the same doubles, except from binary STL, which holds floats.
//! \throw UserError (usage) for another extension, (unwritable) when the file cannot be written
void write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh,
                const MeshFileOptions& options = {});

}  // namespace nanocarbon::mesh
