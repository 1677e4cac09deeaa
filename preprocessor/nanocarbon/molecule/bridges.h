#pragma once

#include <cstdint>
#include <vector>

#include "nanocarbon/molecule/skeleton.h"

namespace nanocarbon {

//! \brief For each half-edge of the skeleton, whether its bond alone holds two parts together.
//! \details Depth first with the lowest atom reached (Tarjan 1974), linear. Bonds outside the skeleton count
//! as none.
std::vector<std::uint8_t> find_bridges(const EmbeddedGraph& graph, const Skeleton& skeleton);

}  // namespace nanocarbon
