// SPDX-License-Identifier: GPL-2.0-or-later
#include "bond_topology/atom_storage.h"

#include <algorithm>
#include <bit>

namespace nanocarbon {

void AtomStorage::grow(int atoms) {
  ids.resize(atoms, 0);
  partners.resize(atoms);
  values_.resize(static_cast<std::size_t>(atoms) * columns, 0.0);
  rows_.resize(atoms);
  for (int atom = 0; atom < atoms; ++atom)
    rows_[atom] = values_.data() + static_cast<std::size_t>(atom) * columns;
}

void AtomStorage::copy(int from, int to) {
  ids[to] = ids[from];
  partners[to] = partners[from];
  std::copy_n(rows_[from], columns, rows_[to]);
}

void AtomStorage::clear(int atom) {
  ids[atom] = 0;
  partners[atom].count = 0;
  std::fill_n(rows_[atom], columns, 0.0);
}

int AtomStorage::pack(int atom, double* buffer) const {
  const Partners& own = partners[atom];
  double* to = buffer;
  *to++ = std::bit_cast<double>(ids[atom]);
  to = std::copy_n(rows_[atom], columns, to);
  *to++ = own.count;
  for (int k = 0; k < own.count; ++k) *to++ = std::bit_cast<double>(own.ids[k]);
  return static_cast<int>(to - buffer);
}

int AtomStorage::unpack(int atom, const double* buffer) {
  const double* from = buffer;
  ids[atom] = std::bit_cast<std::int64_t>(*from++);
  std::copy_n(from, columns, rows_[atom]);
  from += columns;
  Partners& own = partners[atom];
  own.count = static_cast<std::int32_t>(*from++);
  for (int k = 0; k < own.count; ++k) own.ids[k] = std::bit_cast<std::int64_t>(*from++);
  return static_cast<int>(from - buffer);
}

double AtomStorage::bytes() const {
  return static_cast<double>(ids.capacity() * sizeof(ids[0]) + partners.capacity() * sizeof(partners[0]) +
                             values_.capacity() * sizeof(values_[0]) + rows_.capacity() * sizeof(rows_[0]));
}

}  // namespace nanocarbon
