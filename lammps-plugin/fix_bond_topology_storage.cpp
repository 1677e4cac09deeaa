// SPDX-License-Identifier: GPL-2.0-or-later
//! \file
//! \brief The rest of fix bond/topology's interface to LAMMPS: what moves with atoms, restart files,
//! settings, pictures.

#include <bit>
#include <climits>

#include "atom.h"
#include "comm.h"
#include "compat/lammps_compat.h"
#include "error.h"
#include "fix_bond_topology.h"

using namespace LAMMPS_NS;

namespace nanocarbon {

void FixBondTopology::grow_arrays(int atoms) {
  storage_.grow(atoms);
  array_atom = storage_.output();
}

void FixBondTopology::copy_arrays(int from, int to, int) { storage_.copy(from, to); }
void FixBondTopology::set_arrays(int i) { storage_.clear(i); }
int FixBondTopology::pack_exchange(int i, double* buffer) { return storage_.pack(i, buffer); }
int FixBondTopology::unpack_exchange(int i, double* buffer) { return storage_.unpack(i, buffer); }

int FixBondTopology::pack_forward_comm(int n, int* atoms, double* buffer, int, int*) {
  for (int k = 0; k < n; ++k) buffer[k] = std::bit_cast<double>(storage_.ids[atoms[k]]);
  return n;
}

void FixBondTopology::unpack_forward_comm(int n, int first, double* buffer) {
  for (int k = 0; k < n; ++k) storage_.ids[first + k] = std::bit_cast<std::int64_t>(buffer[k]);
}

void FixBondTopology::write_restart(FILE* fp) {
  if (!is_root()) return;
  // Before the first run there is nothing to write; an empty record keeps the file's order.
  const std::string bytes =
      started_ ? to_bytes({watch_->start.atoms, watch_->adopted.bonds}) : std::string(sizeof(double), '\0');
  if (bytes.size() > INT_MAX)
    error->one(FLERR,
               std::string("Fix bond/topology watches more atoms than a restart file can hold for a fix"));
  const int size = static_cast<int>(bytes.size());
  std::fwrite(&size, sizeof size, 1, fp);
  std::fwrite(bytes.data(), 1, bytes.size(), fp);
}

void FixBondTopology::restart(char* bytes) {
  if (bytes[0] == '\0') return;
  restart_.emplace();
  if (!from_bytes(bytes, *restart_))
    error->all(
        FLERR,
        std::string("Fix bond/topology cannot read its part of the restart file: another version of the "
                    "plugin wrote it"));
}

// LAMMPS's format: the number of values first.
int FixBondTopology::pack_restart(int i, double* buffer) {
  buffer[0] = 2;
  buffer[1] = std::bit_cast<double>(storage_.ids[i]);
  return 2;
}

void FixBondTopology::unpack_restart(int i, int nth) {
  const double* values = atom->extra[i];
  for (int k = 0; k < nth; ++k) values += static_cast<int>(*values);
  storage_.clear(i);
  storage_.ids[i] = std::bit_cast<std::int64_t>(values[1]);
}

int FixBondTopology::size_restart(int) { return 2; }
int FixBondTopology::maxsize_restart() { return 2; }

int FixBondTopology::modify_param(int narg, char** arg) {
  const std::string keyword = arg[0];
  if (keyword != "halt" && keyword != "reset") return 0;
  if (narg < 2) error->all(FLERR, "Illegal fix_modify command: the value of " + keyword + " is missing");
  const bool value = read_yes_or_no(lmp, keyword, arg[1]);
  if (keyword == "halt") {
    options_.halt = value;
  } else if (value) {  // the next run starts the watch again
    started_ = halted_ = false;
    restart_.reset();
  }
  return 2;
}

// The bonds, for dump image: lines in the colour of the atom's type.
int FixBondTopology::image(int*& kinds, double**& places) {
  constexpr int line = 1;
  if (stale_) rebuild_candidates();
  image_lines_.clear();
  for (const CandidateBond& pair : candidates_.pairs) {
    if (!pair.now) continue;
    const double* const from = atom->x[pair.owned];
    const double* const to = atom->x[pair.other];
    image_lines_.push_back({double(atom->type[pair.owned]), from[0], from[1], from[2], to[0], to[1], to[2]});
  }
  image_kinds_.assign(image_lines_.size(), line);
  image_rows_.clear();
  for (auto& row : image_lines_) image_rows_.push_back(row.data());
  kinds = image_kinds_.data();
  places = image_rows_.data();
  return static_cast<int>(image_lines_.size());
}

double FixBondTopology::memory_usage() {
  return storage_.bytes() + static_cast<double>(candidates_.pairs.capacity() * sizeof(CandidateBond));
}

}  // namespace nanocarbon
