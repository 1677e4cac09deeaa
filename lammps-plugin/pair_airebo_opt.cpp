// SPDX-License-Identifier: GPL-2.0-or-later
#include "pair_airebo_opt.h"

#include <algorithm>
#include <limits>

#include "atom.h"
#include "compat/lammps_compat.h"
#include "nanocarbon/potential/airebo/parameter_file.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "utils.h"

using namespace LAMMPS_NS;

namespace nanocarbon {

using airebo::AireboEnergyParts;
using potential::NearPairs;

namespace {

constexpr int half_list_id = 2;

}  // namespace

PairAireboOpt::PairAireboOpt(LAMMPS* lammps, std::string style, airebo::LjForm form)
    : PairBondOrder(lammps, style), style_(std::move(style)), form_(form) {
  margin = 0.6;  // more work at each step, but lists for twice as many
}

void PairAireboOpt::settings(int narg, char** arg) {
  const auto number = [&](int n) { return utils::numeric(FLERR, arg[n], false, lmp); };
  const auto flag = [&](int n) { return utils::inumeric(FLERR, arg[n], false, lmp) != 0; };
  if (narg != 1 && narg != 3 && narg != 4)
    error->all(FLERR,
               "Illegal pair_style command: " + style_ + " takes cutoff [LJ_flag TORSION_flag [cutoff_min]]");
  terms_ = {};
  terms_.cutoff = number(0);
  if (!(terms_.cutoff > 0.0))
    error->all(FLERR, "Illegal pair_style command: " + style_ + " needs a cutoff above 0");
  if (narg >= 3) {
    terms_.long_range = flag(1);
    terms_.torsion = flag(2);
  }
  if (narg == 4) {
    terms_.switch_begin = number(3);
    terms_.switch_end = terms_.cutoff;
    if (!(terms_.switch_begin > 0.0 && terms_.switch_begin < terms_.switch_end))
      error->all(FLERR,
                 "Illegal pair_style command: " + style_ + " needs a cutoff_min between 0 and the cutoff");
  }
}

const std::array<rebo2::PairParameters, 3>& PairAireboOpt::take_file(const char* file) {
  parameters_ = read_for_all(
      file, form_ == airebo::LjForm::morse ? airebo::airebo_m_parameters() : airebo::airebo_parameters(),
      [&](const std::string& path) { return airebo::read_airebo_parameters(path, form_); });
  return parameters_.rebo.pairs;
}

void PairAireboOpt::init_style() {
  request_near_list();
  if (terms_.long_range) request_half_list(*neighbor, this, instance_me, half_list_id);
  evaluation_ = std::make_unique<Evaluation>(parameters_, terms_);
}

void PairAireboOpt::init_list(int id, NeighList* given) {
  if (id == half_list_id)
    half_list_ = given;
  else
    Pair::init_list(id, given);
}

double PairAireboOpt::init_one(int i, int j) {
  set_bond_cutoff(i, j);
  if (!terms_.long_range) return 3.0 * longest_bond();
  // How far an atom feels forces; it decides which atoms there are ghosts of.
  const double sigma = parameters_.long_range[rebo2::pair_index(element(i), element(j))].potential.sigma;
  return std::max(airebo::bond_reach(parameters_), terms_.cutoff * sigma);
}

NearPairs PairAireboOpt::half_pairs(double cutoff) const {
  NearPairs pairs;
  const double* x = atom->nlocal > 0 ? atom->x[0] : nullptr;
  std::vector<char> has_row(atom->nlocal, 0);
  for (int n = 0; n < half_list_->inum; ++n) has_row[half_list_->ilist[n]] = 1;
  for (int i = 0; i < atom->nlocal; ++i) {
    const int* row = half_list_->firstneigh[i];
    const int count = has_row[i] ? half_list_->numneigh[i] : 0;
    std::size_t end = pairs.atoms.size();
    pairs.atoms.resize(end + count);
    for (int n = 0; n < count; ++n) {  // without branches
      const int j = row[n] & NEIGHMASK;
      const double a = x[3 * j] - x[3 * i], b = x[3 * j + 1] - x[3 * i + 1], c = x[3 * j + 2] - x[3 * i + 2];
      pairs.atoms[end] = static_cast<std::uint32_t>(j);
      end += a * a + b * b + c * c < cutoff * cutoff;
    }
    pairs.atoms.resize(end);
    pairs.offsets.push_back(static_cast<std::uint32_t>(end));
  }
  return pairs;
}

void PairAireboOpt::take_lists() {
  if (!terms_.long_range) {
    evaluation_->fast.lists_changed(atoms(), near(), {}, margin);
    return;
  }
  const double reach = airebo::longest_hypothetical_bond(parameters_) + neighbor->skin;
  evaluation_->fast.lists_changed(atoms(), near(), half_pairs(reach), margin);
  const NearPairs& excluded = evaluation_->fast.exclusions();
  std::vector<std::array<std::uint32_t, 2>> exclusions;
  exclusions.reserve(excluded.atoms.size());
  for (std::uint32_t i = 0; i < atoms().own; ++i)
    for (const std::uint32_t j : excluded.of(i)) exclusions.push_back({i, j});
  const airebo::LjHalfList half = {static_cast<std::size_t>(half_list_->inum), half_list_->ilist,
                                   half_list_->firstneigh, half_list_->numneigh, NEIGHMASK};
  evaluation_->plain.use_half_list(half, atoms().positions, {atoms().elements, atoms().all}, exclusions);
}

AireboEnergyParts PairAireboOpt::evaluate_in_general() {
  potential::AtomShares shares;
  if (eflag_atom) shares.energies = eatom;
  const bool virials = vflag_atom || (vflag_global && !vflag_fdotr);
  if (virials) shares.virials = start_virials();
  const NearPairs pairs =
      terms_.long_range ? half_pairs(std::numeric_limits<double>::infinity()) : NearPairs{};
  const AireboEnergyParts parts = airebo::evaluate_general(atoms(), near(), pairs, evaluation_->model,
                                                           evaluation_->workspace, atom->f[0], shares);
  if (virials) add_virials();
  return parts;
}

AireboEnergyParts PairAireboOpt::evaluate_fast(bool energy) {
  AireboEnergyParts parts = evaluation_->fast.evaluate(atoms(), near(), atom->f[0]);
  if (!terms_.long_range) return parts;
  evaluation_->plain.place(atoms().positions);
  parts.long_range += evaluation_->plain.evaluate(atom->f[0], {.energy = energy, .virial = false}).energy;
  return parts;
}

void PairAireboOpt::compute(int eflag, int vflag) {
  ev_init(eflag, vflag);
  std::fill_n(pvector, 3, 0.0);
  const Lists lists = update_near();
  choose_loops(evaluation_->fast.bonds());
  if (atoms().all > 0) {
    if (lists == Lists::all_changed)
      take_lists();
    else if (lists == Lists::near_changed)
      evaluation_->fast.near_changed(atoms(), near());
    const bool shared_out = eflag_atom || vflag_atom || (vflag_global && !vflag_fdotr);
    const AireboEnergyParts parts = shared_out ? evaluate_in_general() : evaluate_fast(eflag != 0);
    if (eflag) {
      pvector[0] = parts.rebo();
      pvector[1] = parts.long_range;
      pvector[2] = parts.torsion();
    }
    if (eflag_global) eng_vdwl += parts.total();
  }
  if (vflag_fdotr) virial_fdotr_compute();
}

double PairAireboOpt::memory_usage() {
  return static_cast<double>(lists_memory() + (evaluation_ ? evaluation_->fast.memory() : 0));
}

}  // namespace nanocarbon
