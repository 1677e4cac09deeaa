// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "lammps.h"

namespace nanocarbon {

//! \brief Gives input scripts of this LAMMPS the `plugin` command (load, unload, list, clear) of LAMMPS's own
//! PLUGIN package; does nothing where that package is built in.
//! \details As there, a plugin's styles are lost
//! with `clear`, and are there again after another `plugin load`. Errors go through LAMMPS: no such file
//! (with every place looked at), not a plugin, no such style.
void add_plugin_command(LAMMPS_NS::LAMMPS& lmp);

}  // namespace nanocarbon
