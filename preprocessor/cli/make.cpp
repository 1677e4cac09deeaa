// SPDX-License-Identifier: GPL-2.0-or-later
#include "make.h"

namespace nanocarbon::cli {

void add_make(CLI::App& app) {
  CLI::App& make = *app.add_subcommand("make", "Make a known structure, or a shape as a mesh");
  make.require_subcommand(1);
  add_make_graphene(make);
  add_make_graphite(make);
  add_make_tube(make);
  add_make_fullerene(make);
  add_make_onion(make);
  add_make_diamond(make);
  add_make_schwarzite(make);
  add_make_mesh(make);
  make.footer(
      R"(Atoms are written as a LAMMPS data file (FILE.data) or extended XYZ (FILE.xyz), near equilibrium under REBO2
(graphite, bundles of tubes and onions under AIREBO), meshes as OFF, OBJ, PLY or STL, ready for 'nanocarbon build'. Each has its own --help.
Examples:
  nanocarbon make tube 10 10 --length 50 -o tube.data
  nanocarbon make fullerene 1 1 -o c60.xyz
  nanocarbon make mesh torus --major 3 --minor 1 -o torus.off)");
}

}  // namespace nanocarbon::cli
