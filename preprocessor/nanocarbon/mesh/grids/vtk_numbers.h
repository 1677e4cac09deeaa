// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "nanocarbon/mesh/parsing/byte_order.h"
#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

enum class VtkType { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

//! A type by its name in files of XML ("Float32") or in older ones ("float"); nothing for "string", "bit" and others.
std::optional<VtkType> vtk_type(std::string_view name);

std::size_t size_of(VtkType type);

//! Bytes as numbers: whole ones are exact up to 2^53.
std::vector<double> vtk_numbers(std::string_view bytes, VtkType type, ByteOrder order);

//! A number as that of one of so many points; nothing where it is none.
std::optional<VertexIndex> point_index(double number, std::size_t points);

}  // namespace nanocarbon::mesh
