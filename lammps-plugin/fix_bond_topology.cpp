// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_bond_topology.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "atom.h"
#include "bond_topology/rank_exchange.h"
#include "comm.h"
#include "compat/lammps_compat.h"
#include "error.h"
#include "force.h"
#include "neighbor.h"
#include "pair.h"
#include "timer.h"
#include "update.h"
#include "utils.h"

using namespace LAMMPS_NS;

namespace nanocarbon {

FixBondTopology::FixBondTopology(LAMMPS* lammps, int narg, char** arg)
    : Fix(lammps, narg, arg), options_(read_options(lammps, narg, arg)) {
  if (!atom->tag_enable)
    error->all(FLERR, std::string("Fix bond/topology needs atom IDs: leave out atom_modify id no"));
  const std::string units = update->unit_style;
  if (units != "metal" && units != "real")
    error->all(FLERR,
               "Fix bond/topology needs units metal or real, whose lengths are in Angstrom, not " + units);
  nevery = options_.every;
  scalar_flag = 1;
  extscalar = 0;
  vector_flag = 1;
  size_vector = WatchFigures::count;
  extvector = 0;
  global_freq = 1;
  peratom_flag = 1;
  size_peratom_cols = AtomStorage::columns;
  peratom_freq = 1;
  restart_global = 1;
  restart_peratom = 1;
  create_attribute = 1;
  stores_ids = 1;
  comm_forward = 1;
  maxexchange = AtomStorage::most_packed;

  FixBondTopology::grow_arrays(atom->nmax);
  atom->add_callback(Atom::GROW);
  atom->add_callback(Atom::RESTART);

  if (!options_.file.empty() && is_root()) {
    file_ = std::fopen(options_.file.c_str(), options_.append ? "a" : "w");
    if (file_ == nullptr)
      error->one(FLERR, "Fix bond/topology cannot open file " + options_.file + ": " + std::strerror(errno));
  }
}

FixBondTopology::~FixBondTopology() {
  atom->delete_callback(id, Atom::GROW);
  atom->delete_callback(id, Atom::RESTART);
  if (file_ != nullptr) std::fclose(file_);
}

int FixBondTopology::setmask() {
  using namespace FixConst;
  return END_OF_STEP | POST_NEIGHBOR | POST_RUN | MIN_POST_NEIGHBOR | MIN_POST_FORCE;
}

void FixBondTopology::init() { element_of_type_.assign(atom->ntypes + 1, Element::carbon); }

// Watched already, or about to be.
bool FixBondTopology::is_watched(int i) const {
  return started_ || restart_ ? storage_.ids[i] != 0 : (atom->mask[i] & groupbit) != 0;
}

// The keyword goes before pair_coeff of a pair style of this plugin, which is what the forces are made by.
SaidElements FixBondTopology::said_elements() const {
  if (!options_.elements.empty()) return {options_.elements, "element"};
  int dimension = 0;
  const auto* of_type = force->pair == nullptr
                            ? nullptr
                            : static_cast<const int*>(force->pair->extract("nanocarbon/elements", dimension));
  if (of_type == nullptr) return {};
  SaidElements said{{}, "pair_coeff"};
  said.of_type.resize(static_cast<std::size_t>(atom->ntypes) + 1);
  for (int type = 1; type <= atom->ntypes; ++type)
    if (of_type[type] >= 0)
      said.of_type[static_cast<std::size_t>(type)] = static_cast<Element>(of_type[type]);
  return said;
}

// Collective. Says in the log what the types are taken for, and again where that has changed.
void FixBondTopology::identify_types() {
  std::vector<int> types;
  std::vector<double> masses;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!is_watched(i)) continue;
    types.push_back(atom->type[i]);
    masses.push_back(atom->rmass != nullptr ? atom->rmass[i] : atom->mass[atom->type[i]]);
  }
  const TypeElements elements =
      type_elements(atom->ntypes, watched_types(world, atom->ntypes, types, masses), said_elements());
  const std::string name = std::string("bond/topology ") + id;
  if (!elements.problem.empty())
    error->all(FLERR, "Fix " + name + " watches carbon and hydrogen: " + elements.problem);
  element_of_type_ = elements.of_type;
  if (elements.summary == types_said_) return;
  types_said_ = elements.summary;
  if (is_root()) utils::logmesg(lmp, "fix " + name + ": " + elements.summary + "\n");
}

void FixBondTopology::setup(int) {
  stale_ = true;
  identify_types();
  check_reach();
  if (!started_) begin();
  // At steps that are not looked at, only atoms that have gone since the last run make a look needed, so that
  // a run in components sees what the same run in one component does.
  const bool due = update->ntimestep % nevery == 0;
  if (due || tally({})[2] != adopted_atoms_) {
    look_at_bonds();
    adopt_bonds();
  }
}

// A minimiser tries places that it gives up again. Its bonds are looked at, but not adopted before it is
// done.
void FixBondTopology::min_setup(int) {
  stale_ = true;
  identify_types();
  check_reach();
  if (!started_) begin();
  look_at_bonds();
}

void FixBondTopology::setup_post_neighbor() { stale_ = true; }
void FixBondTopology::post_neighbor() { stale_ = true; }
void FixBondTopology::min_post_neighbor() { stale_ = true; }

void FixBondTopology::min_post_force(int) {
  if (update->ntimestep % nevery == 0) look_at_bonds();
}

void FixBondTopology::end_of_step() {
  look_at_bonds();
  adopt_bonds();
}

void FixBondTopology::post_run() {
  if (!started_) return;
  if (update->whichflag == 2) {
    look_at_bonds();
    adopt_bonds();
  }
  if (is_root()) utils::logmesg(lmp, summary(std::string("fix bond/topology ") + id, when_, watch_->latest));
}

bool FixBondTopology::is_root() const { return comm->me == 0; }

RankAtoms FixBondTopology::rank_atoms() const {
  return {atom->x[0], atom->type, atom->nlocal, atom->nlocal + atom->nghost, storage_.ids, element_of_type_};
}

std::size_t FixBondTopology::own_watched() const {
  std::size_t count = 0;
  for (int i = 0; i < atom->nlocal; ++i) count += storage_.ids[i] != 0;
  return count;
}

FixBondTopology::Tally FixBondTopology::tally(const LocalChanges& changes) const {
  const Tally own = {changes.count, changes.hash, own_watched()};
  Tally sum = {};
  MPI_Allreduce(own.data(), sum.data(), static_cast<int>(own.size()), MPI_UINT64_T, MPI_SUM, world);
  return sum;
}

SimulationTime FixBondTopology::now() const {
  const bigint since = update->ntimestep - update->atimestep;
  return {update->ntimestep, update->atime + static_cast<double>(since) * update->dt};
}

void FixBondTopology::check_reach() const {
  const double need = options_.distances.carbon_carbon.breaking + neighbor->skin;
  const double have = comm->get_comm_cutoff();
  if (have < need)
    error->all(FLERR, "Fix bond/topology needs ghost atoms within " + std::to_string(need) +
                          " (break and the neighbor skin), but they reach " + std::to_string(have) +
                          ": use comm_modify cutoff");
}

void FixBondTopology::rebuild_candidates() {
  forward_comm_of_fix(*comm, this);
  candidates_ = find_candidates(rank_atoms(), storage_.partners, options_.distances, neighbor->skin);
  stale_ = false;
}

void FixBondTopology::begin() {
  started_ = true;
  if (is_root()) watch_.emplace();
  if (restart_)
    begin_from_restart();
  else
    begin_afresh();
  shown_ = tally({});
  adopted_atoms_ = shown_[2];
}

void FixBondTopology::begin_afresh() {
  for (int i = 0; i < atom->nlocal; ++i) {
    storage_.clear(i);
    if (atom->mask[i] & groupbit) storage_.ids[i] = atom->tag[i];
  }
  rebuild_candidates();
  look(candidates_, rank_atoms());
  const Gathered gathered = gather(world, rank_atoms(), candidates_);
  if (is_root()) {
    watch_->start = start_watch(gathered.atoms, options_.topology);
    write_line(start_line(now(), watch_->start));
    if (gathered.atoms.ids.empty())
      error->warning(FLERR, std::string("Fix bond/topology ") + id + " has no atoms to watch");
  }
  adopt(candidates_, rank_atoms(), options_.distances, storage_.partners);
  evaluate();
  if (is_root()) watch_->adopted = watch_->latest;
}

void FixBondTopology::begin_from_restart() {
  const std::vector<topology::BondedIds>& bonds = restart_->bonds;
  for (int i = 0; i < atom->nlocal; ++i) {
    Partners& partners = storage_.partners[i];
    partners.count = 0;
    if (storage_.ids[i] == 0) continue;
    auto bond = std::lower_bound(bonds.begin(), bonds.end(), topology::BondedIds{storage_.ids[i], 0});
    for (; bond != bonds.end() && bond->first == storage_.ids[i]; ++bond) partners.add(bond->second);
  }
  if (is_root()) watch_->start = start_watch(restart_->start, options_.topology);
  rebuild_candidates();
  evaluate();
  if (is_root()) {
    watch_->adopted = watch_->latest;
    watch_->adopted.bonds = bonds;
  }
  restart_.reset();
}

// Collective. Sees what the bonds are, without making them those that hysteresis is told from.
void FixBondTopology::look_at_bonds() {
  if (stale_) rebuild_candidates();
  const Tally seen = tally(look(candidates_, rank_atoms()));
  when_ = now();
  if (seen == shown_) return;
  shown_ = seen;
  evaluate();
}

void FixBondTopology::adopt_bonds() {
  if (shown_[0] == 0 && shown_[2] == adopted_atoms_) return;
  adopt(candidates_, rank_atoms(), options_.distances, storage_.partners);
  adopted_atoms_ = shown_[2];
  shown_ = {0, 0, adopted_atoms_};
  if (is_root()) {
    write_line(change_line(when_, watch_->adopted, watch_->latest));
    watch_->adopted = watch_->latest;
  }
  const bool any_broken = figures_.vector[1] > 0.0;
  if (options_.halt && any_broken && !halted_) {
    halted_ = true;
    if (is_root())
      utils::logmesg(lmp, std::string("Fix bond/topology ") + id + ": the first bond is broken at step " +
                              std::to_string(when_.step) + ", the run is stopped\n");
    timer->force_timeout();
  }
}

// Collective. Brings the bonds to rank 0, and what they make back to all.
void FixBondTopology::evaluate() {
  when_ = now();
  const Gathered gathered = gather(world, rank_atoms(), candidates_);
  if (is_root()) {
    watch_->latest = report(watch_->start, gathered.atoms, options_.topology);
    figures_ = figures(watch_->latest);
  }
  MPI_Bcast(&figures_, sizeof figures_, MPI_BYTE, 0, world);
  const std::vector<AtomState> empty;
  const std::vector<AtomState> states =
      scatter(world, gathered, is_root() ? watch_->latest.atoms : empty, own_watched());
  std::size_t next = 0;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (storage_.ids[i] == 0) continue;
    const AtomState& state = states[next++];
    const std::array<double, AtomStorage::columns> row = {double(state.state), double(state.coordination),
                                                          double(state.smallest_ring)};
    std::copy(row.begin(), row.end(), storage_.output()[i]);
  }
}

void FixBondTopology::write_line(const std::string& line) {
  if (file_ == nullptr) return;
  if (std::fprintf(file_, "%s\n", line.c_str()) < 0 || std::fflush(file_) != 0)
    error->one(FLERR,
               "Fix bond/topology cannot write to file " + options_.file + ": " + std::strerror(errno));
}

double FixBondTopology::compute_scalar() { return figures_.verdict; }
double FixBondTopology::compute_vector(int n) { return figures_.vector[n]; }

}  // namespace nanocarbon
