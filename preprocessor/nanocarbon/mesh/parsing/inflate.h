// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace nanocarbon::mesh {

//! What is around data that deflate has packed.
enum class Packing { bare, zlib, gzip };

//! \brief Unpacks data whole. Of gzip several members are one file; what follows the last of another packing is
//! passed over.
//! \param most bytes that may come of it
//! \return nothing where the data is damaged, cut short, or more would come of it
std::optional<std::string> inflated(std::string_view packed, Packing packing, std::size_t most);

//! The check sum of ZIP archives (CRC-32).
std::uint32_t crc32_of(std::string_view bytes);

}  // namespace nanocarbon::mesh
