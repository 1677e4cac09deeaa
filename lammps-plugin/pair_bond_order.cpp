// SPDX-License-Identifier: GPL-2.0-or-later
#include "pair_bond_order.h"

#include <algorithm>
#include <cstring>

#include "atom.h"
#include "compat/lammps_compat.h"
#include "force.h"
#include "memory.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "update.h"
#include "utils.h"

using namespace LAMMPS_NS;

namespace nanocarbon {

PairBondOrder::PairBondOrder(LAMMPS* lammps, std::string style) : Pair(lammps), style_(std::move(style)) {
  single_enable = 0;
  restartinfo = 0;
  one_coeff = 1;
  manybody_flag = 1;
  ghostneigh = 1;
  centroidstressflag = CENTROID_NOTAVAIL;
  // As of rebo and airebo: the REBO energy, that of Lennard-Jones or Morse, and that of torsion.
  nextra = 3;
  pvector = new double[3]{};
}

PairBondOrder::~PairBondOrder() {
  delete[] pvector;
  if (!allocated) return;
  memory->destroy(setflag);
  memory->destroy(cutsq);
  memory->destroy(cutghost);
}

void PairBondOrder::stop(const std::string& message) const {
  error->all(FLERR, message);
  std::abort();  // not reached; older headers do not say so
}

void PairBondOrder::allocate() {
  allocated = 1;
  const int n = atom->ntypes + 1;
  memory->create(setflag, n, n, "pair:setflag");
  memory->create(cutsq, n, n, "pair:cutsq");
  memory->create(cutghost, n, n, "pair:cutghost");
}

std::string PairBondOrder::read_path(const char* file) const {
  const std::string path = utils::get_potential_file_path(file);
  return path.empty() ? file : path;
}

void PairBondOrder::coeff(int narg, char** arg) {
  if (std::strcmp(update->unit_style, "metal") != 0)
    stop("Pair style " + style_ + " requires metal units, not " + update->unit_style);
  if (!allocated) allocate();
  const int types = atom->ntypes;
  if (narg != 3 + types || std::strcmp(arg[0], "*") != 0 || std::strcmp(arg[1], "*") != 0)
    stop("Incorrect args for pair coefficients: " + style_ +
         " needs pair_coeff * * FILE and an element (C, H or NULL) for each atom type");
  element_of_type_.assign(types + 1, -1);
  for (int type = 1; type <= types; ++type) {
    const std::string name = arg[2 + type];
    if (name == "NULL") continue;
    const auto known = element_from_symbol(name);
    if (!known)
      stop("Incorrect args for pair coefficients: " + style_ + " knows C, H and NULL, not '" + name + "'");
    element_of_type_[type] = static_cast<int>(*known);
  }
  const std::array<rebo2::PairParameters, 3>& bonds = take_file(arg[2]);
  longest_bond_ = 0.0;
  for (int p = 0; p < 3; ++p) {
    bond_cutoff_[p] = bonds[p].cutoff_end;
    longest_bond_ = std::max(longest_bond_, bond_cutoff_[p]);
  }
  listed_positions_.clear();

  int pairs = 0;
  for (int i = 1; i <= types; ++i)
    for (int j = i; j <= types; ++j) {
      setflag[i][j] = element_of_type_[i] >= 0 && element_of_type_[j] >= 0;
      pairs += setflag[i][j];
    }
  if (pairs == 0) stop("Incorrect args for pair coefficients: every type is NULL");
}

void* PairBondOrder::extract(const char* name, int& dimension) {
  dimension = 1;
  return std::strcmp(name, "nanocarbon/elements") == 0 && !element_of_type_.empty() ? element_of_type_.data()
                                                                                    : nullptr;
}

void PairBondOrder::request_near_list() {
  if (atom->tag_enable == 0) stop("Pair style " + style_ + " requires atom IDs");
  if (force->newton_pair == 0) stop("Pair style " + style_ + " requires newton pair on");
  // Only binned lists can have a cut-off of their own.
  const double cutoff = neighbor->style == Neighbor::BIN ? longest_bond_ + neighbor->skin : 0.0;
  request_full_list(*neighbor, this, instance_me, true, cutoff);
  listed_positions_.clear();
}

void PairBondOrder::set_bond_cutoff(int i, int j) {
  if (setflag[i][j] == 0) stop("All pair coeffs are not set");
  cutghost[i][j] = cutghost[j][i] = bond_cutoff_[rebo2::pair_index(element(i), element(j))];
}

bool PairBondOrder::elements_are_same() const {
  for (std::size_t i = 0; i < elements_.size(); ++i)
    if (has_element(atom->type[i]) && elements_[i] != element(atom->type[i])) return false;
  return true;
}

bool PairBondOrder::moved_far() const {
  const double* now = atom->x[0];
  const double* then = listed_positions_.data();
  const double most = 0.25 * listed_margin_ * listed_margin_;
  bool near = true;
  for (std::size_t i = 0; i < listed_positions_.size(); i += 3) {
    const double x = now[i] - then[i], y = now[i + 1] - then[i + 1], z = now[i + 2] - then[i + 2];
    near &= x * x + y * y + z * z <= most;
  }
  return !near;
}

PairBondOrder::Lists PairBondOrder::update_near() {
  const std::size_t all = static_cast<std::size_t>(atom->nlocal) + atom->nghost;
  // LAMMPS's own list may be new, and with it the order of the atoms.
  const bool new_lists = neighbor->ago == 0 || listed_positions_.size() != 3 * all || !elements_are_same();
  if (!new_lists && !moved_far()) return Lists::good;
  find_near_pairs();
  return new_lists ? Lists::all_changed : Lists::near_changed;
}

// Pairs that a data file's bonds and special_bonds take out of the lists are those that matter most here.
// What is left depends on which rank holds an atom, and rebo and airebo compute something without meaning
// from it.
void PairBondOrder::refuse_missing_neighbours() const {
  if (atom->molecular != Atom::MOLECULAR) return;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!has_element(atom->type[i])) continue;
    for (int from = 0, shell = 0; shell < 3; from = atom->nspecial[i][shell++]) {
      if (neighbor->special_flag[shell + 1] != 0) continue;  // kept in the lists
      for (int k = from; k < atom->nspecial[i][shell]; ++k) {
        const int j = atom->map(atom->special[i][k]);
        if (j < 0 || !has_element(atom->type[j])) continue;
        error->one(FLERR, "Pair style " + style_ +
                              " needs the neighbors that special_bonds takes out, such as atoms " +
                              std::to_string(atom->tag[i]) + " and " + std::to_string(atom->tag[j]) +
                              ": use special_bonds lj/coul 1 1 1");
      }
    }
  }
}

//! Adds the neighbours of an atom that are near enough.
void PairBondOrder::add_near_row(int i, const std::vector<char>& is_listed,
                                 std::vector<std::uint32_t>& to) const {
  if (!is_listed[i]) return;
  const double* x = atom->x[0];
  const double* at = x + 3 * std::size_t(i);
  const int* neighbours = list->firstneigh[i];
  const int count = list->numneigh[i];
  std::array<double, 2> squared_reach;
  for (const Element other : {Element::carbon, Element::hydrogen}) {
    const double reach = bond_cutoff_[rebo2::pair_index(elements_[i], other)] + margin;
    squared_reach[static_cast<std::size_t>(other)] = reach * reach;
  }
  std::size_t n = to.size();
  to.resize(n + count);
  for (int k = 0; k < count; ++k) {
    const int j = neighbours[k] & NEIGHMASK;
    const double* p = x + 3 * std::size_t(j);
    const double a = p[0] - at[0], b = p[1] - at[1], c = p[2] - at[2];
    to[n] = static_cast<std::uint32_t>(j);
    n += a * a + b * b + c * c < squared_reach[static_cast<std::size_t>(elements_[j])];
  }
  to.resize(n);
}

void PairBondOrder::find_near_pairs() {
  if (neighbor->ago == 0) refuse_missing_neighbours();
  const int own = atom->nlocal;
  const int all = own + atom->nghost;
  const double* x = all > 0 ? atom->x[0] : nullptr;
  listed_positions_.assign(x, x + 3 * std::size_t(all));
  listed_margin_ = margin;
  elements_.resize(all);
  for (int i = 0; i < all; ++i)
    elements_[i] = static_cast<Element>(std::max(0, element_of_type_[atom->type[i]]));
  std::vector<char> is_listed(all, 0);
  for (int n = 0; n < list->inum + list->gnum; ++n) is_listed[list->ilist[n]] = 1;

  near_.offsets.assign(1, 0);
  near_.atoms.clear();
  const auto close_row = [&] { near_.offsets.push_back(static_cast<std::uint32_t>(near_.atoms.size())); };
  for (int i = 0; i < own; ++i) {
    add_near_row(i, is_listed, near_.atoms);
    close_row();
  }
  if (all_ghosts_have_bonds) {
    for (int i = own; i < all; ++i) {
      add_near_row(i, is_listed, near_.atoms);
      close_row();
    }
    return;
  }
  // Ghosts that own atoms see, then those that these see.
  std::vector<std::uint32_t> pairs, begin(all - own, 0), end(all - own, 0);
  std::vector<std::uint32_t> shell, next;
  std::vector<char> has_row(all - own, 0);
  const auto reach = [&](std::uint32_t j) {
    if (j < static_cast<std::uint32_t>(own) || has_row[j - own]) return;
    has_row[j - own] = 1;
    next.push_back(j);
  };
  for (const std::uint32_t j : near_.atoms) reach(j);
  for (int step = 0; step < 2; ++step) {
    shell.swap(next);
    next.clear();
    for (const std::uint32_t i : shell) {
      begin[i - own] = static_cast<std::uint32_t>(pairs.size());
      add_near_row(static_cast<int>(i), is_listed, pairs);
      end[i - own] = static_cast<std::uint32_t>(pairs.size());
      if (step == 0)
        for (std::uint32_t k = begin[i - own]; k < end[i - own]; ++k) reach(pairs[k]);
    }
  }
  for (int i = 0; i < all - own; ++i) {
    near_.atoms.insert(near_.atoms.end(), pairs.begin() + begin[i], pairs.begin() + end[i]);
    close_row();
  }
}

potential::AtomsView PairBondOrder::atoms() const {
  const auto own = static_cast<std::uint32_t>(atom->nlocal);
  const std::uint32_t all = own + static_cast<std::uint32_t>(atom->nghost);
  return {all > 0 ? atom->x[0] : nullptr, elements_.data(), own, all};
}

void PairBondOrder::choose_loops(rebo2::MixedEvaluation& evaluation) const {
  if (neighbor->ago != 0) return;
  std::array<long long, 2> counts = {static_cast<long long>(evaluation.outside_fast_case(atoms(), near())),
                                     atom->nlocal};
  MPI_Allreduce(MPI_IN_PLACE, counts.data(), 2, MPI_LONG_LONG, MPI_SUM, world);
  evaluation.choose(rebo2::MixedEvaluation::lanes_pay(static_cast<std::size_t>(counts[0]),
                                                      static_cast<std::size_t>(counts[1])));
}

potential::Virial* PairBondOrder::start_virials() {
  virials_.assign(elements_.size(), potential::Virial{});
  return virials_.data();
}

void PairBondOrder::add_virials() {
  for (std::size_t i = 0; i < virials_.size(); ++i)
    for (int d = 0; d < 6; ++d) {
      if (vflag_atom) vatom[i][d] += virials_[i][d];
      if (vflag_global && !vflag_fdotr) virial[d] += virials_[i][d];
    }
}

std::size_t PairBondOrder::lists_memory() const {
  return near_.atoms.capacity() * sizeof(std::uint32_t) + listed_positions_.capacity() * sizeof(double);
}

}  // namespace nanocarbon
