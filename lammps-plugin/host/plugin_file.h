// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace nanocarbon {

//! Where a plugin's name led.
struct PluginFile {
  std::filesystem::path path;                 //!< empty when there is no such file
  std::vector<std::filesystem::path> looked;  //!< every path that was tried, in order
};

//! \brief The file that `plugin load NAME` means.
//! \details The name as given; a bare name also in the folders of LAMMPS_PLUGIN_PATH, beside the program, and
//! in the folder that plugins are installed to.
PluginFile find_plugin_file(const std::string& name);

}  // namespace nanocarbon
