// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/molecule_graph.h"

namespace nanocarbon::molecule {

topology::EmbeddedGraph embedded_graph(const Molecule& molecule) {
  return topology::embedded_graph(molecule.positions, molecule.elements, molecule.bonds,
                                  molecule.cell ? &*molecule.cell : nullptr);
}

}  // namespace nanocarbon::molecule
