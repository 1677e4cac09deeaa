// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/fixed_bond_graph.h"

#include <fmt/format.h>

#include "nanocarbon/core/error.h"

namespace nanocarbon::annealing {

FixedBondGraph fixed_bond_graph(const Molecule& molecule) {
  FixedBondGraph graph;
  graph.neighbours.assign(molecule.size(), {no_atom, no_atom, no_atom});
  graph.space = Space(molecule.cell);
  const auto add = [&](AtomIndex from, AtomIndex to) {
    for (AtomIndex& slot : graph.neighbours[from])
      if (slot == no_atom) {
        slot = to;
        return;
      }
    throw UserError(Failure::unsuitable,
                    fmt::format("atom {} has more than three bonds; only sp2 carbon can be relaxed", from));
  };
  for (const Bond& bond : molecule.bonds) {
    add(bond.first, bond.second);
    add(bond.second, bond.first);
  }
  return graph;
}

FixedBondGraph fixed_bond_graph(const TrivalentNetwork& network, const Space& space) {
  FixedBondGraph graph;
  graph.space = space;
  graph.hydrogen = network.hydrogen;
  graph.steric_reach = network.steric_reach;
  graph.neighbours.reserve(network.atoms.size());
  for (const TrivalentAtom& atom : network.atoms)
    graph.neighbours.push_back(atom.exists() ? atom.neighbour : std::array{no_atom, no_atom, no_atom});
  return graph;
}

FixedBondGraph part_of(const FixedBondGraph& whole, std::span<const AtomIndex> atoms, std::size_t inner,
                       std::vector<AtomIndex>& number) {
  FixedBondGraph part;
  part.inner = inner;
  part.hydrogen = whole.hydrogen;
  part.steric_reach = whole.steric_reach;
  part.space = whole.space;
  for (AtomIndex k = 0; k < atoms.size(); ++k) number[atoms[k]] = k;
  part.neighbours.reserve(atoms.size());
  for (const AtomIndex a : atoms) {
    auto& neighbours = part.neighbours.emplace_back(whole.neighbours[a]);
    for (AtomIndex& n : neighbours)
      if (n != no_atom) n = number[n];
  }
  return part;
}

multilevel::NodeGraph bonded_atoms(const FixedBondGraph& graph) {
  std::vector<std::pair<AtomIndex, AtomIndex>> pairs;
  for (AtomIndex a = 0; a < graph.neighbours.size(); ++a)
    for (const AtomIndex n : graph.neighbours[a])
      if (n != no_atom && n > a) pairs.emplace_back(a, n);
  return multilevel::graph_of_pairs(graph.neighbours.size(), pairs);
}

}  // namespace nanocarbon::annealing
