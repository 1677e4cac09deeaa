// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>

#include "nanocarbon/mesh/formats/cell_request.h"
#include "nanocarbon/mesh/formats/load_surface.h"
#include "nanocarbon/mesh/solid/wrap.h"

namespace nanocarbon::cli {

//! What is done to a mesh before it is used: what `build` and `inspect` have in common.
struct SurfaceOptions {
  std::optional<mesh::WrapSize> wrap;
  bool unite = false;
  bool untangle = false;
  double close_holes = 0.0;  //!< mesh units
  mesh::FieldRequest field;  //!< where the file has a scalar field; periodic as the cell's options say
};

//! Adds --level, --field, --field-edge, --wrap, --unite, --untangle and --close-holes. \p options must outlive the app.
void add_surface_options(CLI::App& group, SurfaceOptions& options);

//! A mesh as read and, if so asked, made solid.
struct SurfaceInput {
  mesh::PolygonSoup soup;  //!< its notes tell what was done
  std::size_t vertices_read = 0, faces_read = 0;
};

//! \throw UserError (unreadable, malformed) as read_mesh(), (usage) for what is not for meshes in a cell,
//! (unsuitable) naming the file where --wrap, --unite or --untangle is not possible
SurfaceInput read_surface(const std::filesystem::path& path, const SurfaceOptions& options,
                          const mesh::CellRequest& cell);

//! \brief mesh::load_surface() of what read_surface() gives; a refusal ends with the options that would help, which
//! were tried.
mesh::LoadedSurface load_surface(const std::filesystem::path& path, const SurfaceOptions& options,
                                 bool repair, const mesh::CellRequest& cell);

}  // namespace nanocarbon::cli
