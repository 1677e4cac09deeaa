// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

//! \file
//! \brief The binary interface between LAMMPS's PLUGIN package and a plugin, unchanged since it came in 2021.
//! \details Declared here because installed LAMMPS headers lack it; the names are our own, the layout is
//! LAMMPS's.

namespace nanocarbon {

extern "C" {

using PluginMakeOne = void*(void* lmp);                              //!< pair styles and commands
using PluginMakeWithArguments = void*(void* lmp, int, char** args);  //!< fixes and computes

//! What a plugin says of one style. LAMMPS copies it; the texts must live as long as the object is loaded.
struct PluginStyle {
  const char* lammps_version;
  const char* kind;  //!< "fix", "pair", ...
  const char* name;
  const char* info;
  const char* author;
  union {
    PluginMakeOne* make_one;
    PluginMakeWithArguments* make_with_arguments;
  };
  void* handle;  //!< of the loaded object; LAMMPS counts the styles that use it
};

using PluginRegister = void(PluginStyle* style, void* lmp);
using PluginInit = void(void* lmp, void* handle, void* plugin_register);

}  // extern "C"

inline constexpr const char* plugin_entry_point = "lammpsplugin_init";

}  // namespace nanocarbon
