// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bond_topology/atom_storage.h"
#include "bond_topology/change_line.h"
#include "bond_topology/local_bonds.h"
#include "bond_topology/options.h"
#include "bond_topology/restart_data.h"
#include "bond_topology/surface_watch.h"
#include "bond_topology/type_elements.h"
#include "fix.h"

namespace nanocarbon {

//! \brief fix ID group bond/topology N: bonds, rings, surface and repelled atoms of sp2 carbon, see its
//! documentation page.
//! \details The LAMMPS face of topology/bond_graph.h and topology/surface_topology.h.
//! Each rank looks at its own bonds (bond_topology/local_bonds.h); only when any of them has changed are they
//! gathered on rank 0, which knows the start (bond_topology/surface_watch.h), and the outcome carried back.
class FixBondTopology : public LAMMPS_NS::Fix {
 public:
  FixBondTopology(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);
  ~FixBondTopology() override;

  int setmask() override;
  void init() override;
  void setup(int) override;
  void min_setup(int) override;
  void setup_post_neighbor() override;
  void post_neighbor() override;
  void min_post_neighbor() override;
  void min_post_force(int) override;
  void end_of_step() override;
  void post_run() override;

  double compute_scalar() override;
  double compute_vector(int) override;
  int image(int*& kinds, double**& places) override;
  int modify_param(int narg, char** arg) override;
  double memory_usage() override;

  void write_restart(FILE*) override;
  void restart(char*) override;
  int pack_restart(int atom, double* buffer) override;
  void unpack_restart(int atom, int nth) override;
  int size_restart(int) override;
  int maxsize_restart() override;

  void grow_arrays(int atoms) override;
  void copy_arrays(int from, int to, int) override;
  void set_arrays(int atom) override;
  int pack_exchange(int atom, double* buffer) override;
  int unpack_exchange(int atom, double* buffer) override;
  int pack_forward_comm(int n, int* atoms, double* buffer, int, int*) override;
  void unpack_forward_comm(int n, int first, double* buffer) override;

 private:
  // What all ranks agree on after a look: how many changes since the last adopted one, which, and watched
  // atoms.
  using Tally = std::array<std::uint64_t, 3>;

  // On rank 0 only.
  struct Watch {
    WatchStart start;
    WatchReport adopted;  // as of the last line in the file
    WatchReport latest;
  };

  bool is_root() const;
  RankAtoms rank_atoms() const;
  std::size_t own_watched() const;
  Tally tally(const LocalChanges& changes) const;
  SimulationTime now() const;
  void check_reach() const;
  bool is_watched(int atom) const;
  SaidElements said_elements() const;
  void identify_types();
  void rebuild_candidates();
  void begin();
  void begin_afresh();
  void begin_from_restart();
  void look_at_bonds();
  void adopt_bonds();
  void evaluate();
  void write_line(const std::string& line);

  BondTopologyOptions options_;
  std::vector<Element> element_of_type_;
  std::string types_said_;  // in the log
  AtomStorage storage_;
  CandidateBonds candidates_;
  bool stale_ = true;  // the candidates' indices are not those of the atoms now
  bool started_ = false;
  bool halted_ = false;
  Tally shown_ = {};  // of the latest look
  std::uint64_t adopted_atoms_ = 0;
  SimulationTime when_ = {};  // of the latest look
  WatchFigures figures_;
  std::optional<Watch> watch_;
  std::optional<RestartData> restart_;  // between reading a restart file and the first run
  std::FILE* file_ = nullptr;
  std::vector<int> image_kinds_;
  std::vector<std::array<double, 7>> image_lines_;
  std::vector<double*> image_rows_;
};

}  // namespace nanocarbon
