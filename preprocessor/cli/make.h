// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace nanocarbon::cli {

//! `nanocarbon make STRUCTURE ... -o FILE`: known structures as molecules, and smooth shapes as meshes.
void add_make(CLI::App& app);

//! Its parts, one subcommand for each structure; `make mesh` has one for each shape.
void add_make_graphene(CLI::App& make);
void add_make_graphite(CLI::App& make);
void add_make_tube(CLI::App& make);
void add_make_fullerene(CLI::App& make);
void add_make_onion(CLI::App& make);
void add_make_diamond(CLI::App& make);
void add_make_schwarzite(CLI::App& make);
void add_make_mesh(CLI::App& make);

}  // namespace nanocarbon::cli
