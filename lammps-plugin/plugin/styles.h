// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <span>

#include "plugin/lammps_plugin_abi.h"

namespace nanocarbon {

//! Every style of the plugin. The handles are left empty.
std::span<const PluginStyle> plugin_styles();

}  // namespace nanocarbon
