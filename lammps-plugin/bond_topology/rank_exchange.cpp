// SPDX-License-Identifier: GPL-2.0-or-later
#include "bond_topology/rank_exchange.h"

#include <algorithm>
#include <numeric>

namespace nanocarbon {
namespace {

// An MPI type of one record, so that counts count records and not bytes.
class RecordType {
 public:
  explicit RecordType(std::size_t bytes) {
    MPI_Type_contiguous(static_cast<int>(bytes), MPI_BYTE, &type_);
    MPI_Type_commit(&type_);
  }
  ~RecordType() { MPI_Type_free(&type_); }
  RecordType(const RecordType&) = delete;
  RecordType& operator=(const RecordType&) = delete;
  MPI_Datatype get() const { return type_; }

 private:
  MPI_Datatype type_ = MPI_DATATYPE_NULL;
};

std::vector<int> starts_of(const std::vector<int>& counts) {
  std::vector<int> starts(counts.size(), 0);
  if (!counts.empty()) std::partial_sum(counts.begin(), counts.end() - 1, starts.begin() + 1);
  return starts;
}

template <typename Record>
std::vector<Record> gather_records(MPI_Comm world, const std::vector<Record>& own, std::vector<int>& counts) {
  int rank = 0;
  int ranks = 1;
  MPI_Comm_rank(world, &rank);
  MPI_Comm_size(world, &ranks);
  counts.assign(rank == 0 ? ranks : 0, 0);
  const int count = static_cast<int>(own.size());
  MPI_Gather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, world);
  const std::vector<int> starts = starts_of(counts);
  std::vector<Record> all(std::accumulate(counts.begin(), counts.end(), std::size_t{0}));
  const RecordType type(sizeof(Record));
  MPI_Gatherv(own.data(), count, type.get(), all.data(), counts.data(), starts.data(), type.get(), 0, world);
  return all;
}

struct AtomRecord {
  std::int64_t id;
  std::int64_t element;
};

struct BondRecord {
  std::int64_t atom;
  std::int64_t neighbour;
  std::array<double, 3> vector;
};

}  // namespace

Gathered gather(MPI_Comm world, const RankAtoms& atoms, const CandidateBonds& candidates) {
  std::vector<AtomRecord> own_atoms;
  for (int atom = 0; atom < atoms.owned; ++atom)
    if (atoms.ids[atom] != 0)
      own_atoms.push_back(
          {atoms.ids[atom], static_cast<std::int64_t>(atoms.element_of_type[atoms.types[atom]])});
  std::vector<BondRecord> own_bonds;
  for (const CandidateBond& pair : candidates.pairs) {
    if (!pair.now) continue;
    const double* const from = atoms.positions + 3 * static_cast<std::ptrdiff_t>(pair.owned);
    const double* const to = atoms.positions + 3 * static_cast<std::ptrdiff_t>(pair.other);
    own_bonds.push_back(
        {atoms.ids[pair.owned], atoms.ids[pair.other], {to[0] - from[0], to[1] - from[1], to[2] - from[2]}});
  }

  Gathered result;
  std::vector<int> bond_counts;
  const std::vector<AtomRecord> records = gather_records(world, own_atoms, result.counts);
  const std::vector<BondRecord> bonds = gather_records(world, own_bonds, bond_counts);

  std::vector<std::size_t> order(records.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return records[a].id < records[b].id; });
  result.place.resize(records.size());
  for (std::size_t place = 0; place < order.size(); ++place) {
    result.place[order[place]] = place;
    result.atoms.ids.push_back(records[order[place]].id);
    result.atoms.elements.push_back(static_cast<Element>(records[order[place]].element));
  }
  for (const BondRecord& bond : bonds)
    result.atoms.bonds.push_back({bond.atom, bond.neighbour, Vec3::Map(bond.vector.data())});
  return result;
}

std::vector<AtomState> scatter(MPI_Comm world, const Gathered& gathered, std::span<const AtomState> states,
                               std::size_t own) {
  std::vector<AtomState> by_rank;
  by_rank.reserve(gathered.place.size());
  for (const std::size_t place : gathered.place) by_rank.push_back(states[place]);
  const std::vector<int> starts = starts_of(gathered.counts);
  std::vector<AtomState> result(own);
  const RecordType type(sizeof(AtomState));
  MPI_Scatterv(by_rank.data(), gathered.counts.data(), starts.data(), type.get(), result.data(),
               static_cast<int>(own), type.get(), 0, world);
  return result;
}

}  // namespace nanocarbon
