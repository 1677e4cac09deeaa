// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "build_command.h"
#include "nanocarbon/page/page.h"

namespace nanocarbon::cli {

//! The page of a build: the molecule with all that is known of its atoms, beside the mesh that it was made from.
page::PageContents build_page(const BuildCommand& command, const building::BuildResult& result,
                              const nlohmann::ordered_json& report);

}  // namespace nanocarbon::cli
