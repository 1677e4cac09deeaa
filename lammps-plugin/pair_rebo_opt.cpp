// SPDX-License-Identifier: GPL-2.0-or-later
#include "pair_rebo_opt.h"

#include <algorithm>

#include "atom.h"
#include "nanocarbon/potential/rebo2/kernels/sp2_dispatch.h"
#include "nanocarbon/potential/rebo2/parameter_file.h"

using namespace LAMMPS_NS;

namespace nanocarbon {

PairReboOpt::PairReboOpt(LAMMPS* lammps) : PairBondOrder(lammps, "rebo/opt") {
  all_ghosts_have_bonds = false;
}

void PairReboOpt::settings(int narg, char**) {
  if (narg != 0) error->all(FLERR, std::string("Illegal pair_style command: rebo/opt takes no arguments"));
}

const std::array<rebo2::PairParameters, 3>& PairReboOpt::take_file(const char* file) {
  parameters_ = read_for_all(file, rebo2::rebo2_parameters(), rebo2::read_rebo2_parameters);
  evaluation_ = std::make_unique<rebo2::MixedEvaluation>(parameters_, *rebo2::usable_sp2_kernels().front());
  return parameters_.pairs;
}

void PairReboOpt::init_style() { request_near_list(); }

double PairReboOpt::init_one(int i, int j) {
  set_bond_cutoff(i, j);
  // How far an atom feels forces: three bonds, as of rebo. It decides which atoms there are ghosts of.
  return 3.0 * longest_bond();
}

void PairReboOpt::compute(int eflag, int vflag) {
  ev_init(eflag, vflag);
  if (update_near() != Lists::good) evaluation_->near_changed();
  choose_loops(*evaluation_);
  potential::AtomShares shares;
  if (eflag_atom) shares.energies = eatom;
  const bool needs_virials = vflag_atom || (vflag_global && !vflag_fdotr);
  if (needs_virials) shares.virials = start_virials();
  const double energy = evaluation_->evaluate(atoms(), near(), atom->f[0], shares).total();
  // The fast loops for sp2 carbon watch near pairs each step, the others hardly notice them.
  margin = evaluation_->uses_lanes() ? 0.7 : 0.4;
  std::fill_n(pvector, 3, 0.0);
  if (eflag) pvector[0] = energy;
  if (eflag_global) eng_vdwl += energy;
  if (needs_virials) add_virials();
  if (vflag_fdotr) virial_fdotr_compute();
}

double PairReboOpt::memory_usage() {
  return static_cast<double>(lists_memory() + (evaluation_ ? evaluation_->memory() : 0));
}

}  // namespace nanocarbon
