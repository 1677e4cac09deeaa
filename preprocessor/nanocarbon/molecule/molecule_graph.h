// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/molecule/molecule.h"
#include "nanocarbon/topology/embedded_graph.h"

namespace nanocarbon::molecule {

//! The bond graph of a molecule with the direction of each bond, as the topology of its surface is read off.
topology::EmbeddedGraph embedded_graph(const Molecule& molecule);

}  // namespace nanocarbon::molecule
