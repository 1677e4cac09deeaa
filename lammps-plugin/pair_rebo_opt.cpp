// SPDX-License-Identifier: GPL-2.0-or-later
#include "pair_rebo_opt.h"

#include <mpi.h>

#include <algorithm>
#include <cstring>

#include "atom.h"
#include "comm.h"
#include "compat/lammps_compat.h"
#include "error.h"
#include "force.h"
#include "memory.h"
#include "nanocarbon/core/error.h"
#include "nanocarbon/potential/rebo2/parameter_file.h"
#include "nanocarbon/potential/rebo2/sp2_dispatch.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "update.h"
#include "utils.h"

using namespace LAMMPS_NS;

namespace nanocarbon {

namespace {

// Pairs that are further apart than a bond by up to this are kept; they are good until atoms have moved half
// of it.
constexpr double margin = 0.4;  // Angstrom

}  // namespace

PairReboOpt::PairReboOpt(LAMMPS* lammps) : Pair(lammps) {
  single_enable = 0;
  restartinfo = 0;
  one_coeff = 1;
  manybody_flag = 1;
  ghostneigh = 1;
  centroidstressflag = CENTROID_NOTAVAIL;
  // As of rebo, which shares them with airebo: the REBO energy, and zero for Lennard-Jones and torsion.
  nextra = 3;
  pvector = new double[3]{};
}

PairReboOpt::~PairReboOpt() {
  delete[] pvector;
  if (!allocated) return;
  memory->destroy(setflag);
  memory->destroy(cutsq);
  memory->destroy(cutghost);
}

void PairReboOpt::allocate() {
  allocated = 1;
  const int n = atom->ntypes + 1;
  memory->create(setflag, n, n, "pair:setflag");
  memory->create(cutsq, n, n, "pair:cutsq");
  memory->create(cutghost, n, n, "pair:cutghost");
}

void PairReboOpt::settings(int narg, char**) {
  if (narg != 0) error->all(FLERR, std::string("Illegal pair_style command: rebo/opt takes no arguments"));
}

rebo2::Rebo2Parameters PairReboOpt::read_parameters(const char* file) const {
  rebo2::Rebo2Parameters parameters = rebo2::rebo2_parameters();
  if (comm->me == 0) {
    std::string path = utils::get_potential_file_path(file);
    if (path.empty()) path = file;
    try {
      parameters = rebo2::read_rebo2_parameters(path);
    } catch (const UserError& failure) {
      error->one(FLERR, std::string("pair_coeff rebo/opt: ") + failure.what());
    }
  }
  MPI_Bcast(&parameters, sizeof parameters, MPI_BYTE, 0, world);
  return parameters;
}

void PairReboOpt::coeff(int narg, char** arg) {
  if (std::strcmp(update->unit_style, "metal") != 0)
    error->all(FLERR, std::string("Pair style rebo/opt requires metal units, not ") + update->unit_style);
  if (!allocated) allocate();
  const int types = atom->ntypes;
  if (narg != 3 + types || std::strcmp(arg[0], "*") != 0 || std::strcmp(arg[1], "*") != 0)
    error->all(FLERR,
               std::string("Incorrect args for pair coefficients: rebo/opt needs pair_coeff * * FILE and an "
                           "element (C, H or NULL) for each atom type"));
  element_of_type_.assign(types + 1, -1);
  for (int type = 1; type <= types; ++type) {
    const std::string name = arg[2 + type];
    if (name == "NULL") continue;
    const auto element = element_from_symbol(name);
    if (!element)
      error->all(FLERR,
                 "Incorrect args for pair coefficients: rebo/opt knows C, H and NULL, not '" + name + "'");
    element_of_type_[type] = static_cast<int>(*element);
  }
  parameters_ = read_parameters(arg[2]);
  longest_bond_ = 0.0;
  for (const rebo2::PairParameters& pair : parameters_.pairs)
    longest_bond_ = std::max(longest_bond_, pair.cutoff_end);
  evaluation_ = std::make_unique<rebo2::MixedEvaluation>(parameters_, *rebo2::usable_sp2_kernels().front());
  listed_positions_.clear();

  int pairs = 0;
  for (int i = 1; i <= types; ++i)
    for (int j = i; j <= types; ++j) {
      setflag[i][j] = element_of_type_[i] >= 0 && element_of_type_[j] >= 0;
      pairs += setflag[i][j];
    }
  if (pairs == 0) error->all(FLERR, std::string("Incorrect args for pair coefficients: every type is NULL"));
}

void PairReboOpt::init_style() {
  if (atom->tag_enable == 0) error->all(FLERR, std::string("Pair style rebo/opt requires atom IDs"));
  if (force->newton_pair == 0) error->all(FLERR, std::string("Pair style rebo/opt requires newton pair on"));
  // Only binned lists can have a cut-off of their own.
  const double cutoff = neighbor->style == Neighbor::BIN ? longest_bond_ + neighbor->skin : 0.0;
  request_full_list(*neighbor, this, instance_me, true, cutoff);
  listed_positions_.clear();
}

double PairReboOpt::init_one(int i, int j) {
  if (setflag[i][j] == 0) error->all(FLERR, std::string("All pair coeffs are not set"));
  const auto element = [&](int type) { return static_cast<Element>(element_of_type_[type]); };
  cutghost[i][j] = cutghost[j][i] = parameters_.pairs[rebo2::pair_index(element(i), element(j))].cutoff_end;
  // How far an atom feels forces: three bonds, as of rebo. It decides which atoms there are ghosts of.
  return 3.0 * longest_bond_;
}

bool PairReboOpt::near_pairs_are_good() const {
  const std::size_t all = static_cast<std::size_t>(atom->nlocal) + atom->nghost;
  // LAMMPS's own list may be new, and with it the order of the atoms.
  if (neighbor->ago == 0 || listed_positions_.size() != 3 * all) return false;
  for (std::size_t i = 0; i < all; ++i)
    if (element_of_type_[atom->type[i]] >= 0 &&
        static_cast<int>(elements_[i]) != element_of_type_[atom->type[i]])
      return false;
  const double* now = atom->x[0];
  const double* then = listed_positions_.data();
  double farthest = 0.0;
  for (std::size_t i = 0; i < 3 * all; i += 3) {
    const double x = now[i] - then[i], y = now[i + 1] - then[i + 1], z = now[i + 2] - then[i + 2];
    const double moved = x * x + y * y + z * z;
    farthest = moved > farthest ? moved : farthest;
  }
  return farthest <= 0.25 * margin * margin;
}

// Pairs that a data file's bonds and special_bonds take out of the lists are those that matter most here.
// What is left depends on which rank holds an atom, and rebo computes something without meaning from it.
void PairReboOpt::refuse_missing_neighbours() const {
  if (atom->molecular != Atom::MOLECULAR) return;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (element_of_type_[atom->type[i]] < 0) continue;
    for (int from = 0, shell = 0; shell < 3; from = atom->nspecial[i][shell++]) {
      if (neighbor->special_flag[shell + 1] != 0) continue;  // kept in the lists
      for (int k = from; k < atom->nspecial[i][shell]; ++k) {
        const int j = atom->map(atom->special[i][k]);
        if (j < 0 || element_of_type_[atom->type[j]] < 0) continue;
        error->one(FLERR,
                   "Pair style rebo/opt needs the neighbors that special_bonds takes out, such as atoms " +
                       std::to_string(atom->tag[i]) + " and " + std::to_string(atom->tag[j]) +
                       ": use special_bonds lj/coul 1 1 1");
      }
    }
  }
}

void PairReboOpt::find_near_pairs() {
  if (neighbor->ago == 0) refuse_missing_neighbours();
  const int all = atom->nlocal + atom->nghost;
  const double* x = all > 0 ? atom->x[0] : nullptr;
  listed_positions_.assign(x, x + 3 * std::size_t(all));
  elements_.resize(all);
  for (int i = 0; i < all; ++i)
    elements_[i] = static_cast<Element>(std::max(0, element_of_type_[atom->type[i]]));

  std::vector<int> list_place(all, -1);
  for (int n = 0; n < list->inum + list->gnum; ++n) list_place[list->ilist[n]] = n;
  near_.offsets.assign(1, 0);
  near_.atoms.clear();
  const double cutoff = longest_bond_ + margin;
  for (int i = 0; i < all; ++i) {
    if (list_place[i] >= 0)
      for (int n = 0; n < list->numneigh[i]; ++n) {
        const int j = list->firstneigh[i][n] & NEIGHMASK;
        double squared = 0.0;
        for (int d = 0; d < 3; ++d) squared += (x[3 * j + d] - x[3 * i + d]) * (x[3 * j + d] - x[3 * i + d]);
        if (squared < cutoff * cutoff) near_.atoms.push_back(j);
      }
    near_.offsets.push_back(static_cast<std::uint32_t>(near_.atoms.size()));
  }
  evaluation_->near_changed();
}

void PairReboOpt::add_virials() {
  for (std::size_t i = 0; i < virials_.size(); ++i)
    for (int d = 0; d < 6; ++d) {
      if (vflag_atom) vatom[i][d] += virials_[i][d];
      if (vflag_global && !vflag_fdotr) virial[d] += virials_[i][d];
    }
}

void PairReboOpt::compute(int eflag, int vflag) {
  ev_init(eflag, vflag);
  if (!near_pairs_are_good()) find_near_pairs();
  const auto own = static_cast<std::uint32_t>(atom->nlocal);
  const potential::AtomsView atoms = {atom->x[0], elements_.data(), own,
                                      own + static_cast<std::uint32_t>(atom->nghost)};
  potential::AtomShares shares;
  if (eflag_atom) shares.energies = eatom;
  const bool needs_virials = vflag_atom || (vflag_global && !vflag_fdotr);
  if (needs_virials) {
    virials_.assign(atoms.all, potential::Virial{});
    shares.virials = virials_.data();
  }
  const double energy = evaluation_->evaluate(atoms, near_, atom->f[0], shares).total();
  std::fill_n(pvector, 3, 0.0);
  if (eflag) pvector[0] = energy;
  if (eflag_global) eng_vdwl += energy;
  if (needs_virials) add_virials();
  if (vflag_fdotr) virial_fdotr_compute();
}

double PairReboOpt::memory_usage() {
  return static_cast<double>(near_.atoms.capacity() * sizeof(std::uint32_t) +
                             listed_positions_.capacity() * sizeof(double)) +
         (evaluation_ ? static_cast<double>(evaluation_->memory()) : 0.0);
}

}  // namespace nanocarbon
