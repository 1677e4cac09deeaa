// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/airebo/lj/lj_sum.h"

#include <algorithm>

#include "nanocarbon/potential/airebo/lj/lj_dispatch.h"

namespace nanocarbon::airebo {

namespace {

constexpr std::size_t atoms_a_task = 4096;

Mat3 virial_of(const LjChunk& chunk) {
  Mat3 virial = Mat3::Zero();
  for (const LjCluster& cluster : chunk.clusters)
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b)
        for (int l = 0; l < lj_lanes; ++l) virial(a, b) += cluster.position[a][l] * cluster.force[b][l];
  return virial;
}

}  // namespace

LjSum::LjSum(const LjParameters& parameters, const LjSumOptions& options)
    : parameters_(parameters),
      options_(options),
      kernel_(&find_lj_kernel(options.instructions)),
      constants_(make_lj_constants(parameters)) {}

void LjSum::use_half_list(const LjHalfList& half, const double* positions, std::span<const Element> elements,
                          std::span<const std::array<std::uint32_t, 2>> exclusions) {
  lists_ = lists_from_half_list(half, positions, elements, exclusions);
}

void LjSum::find_pairs(std::span<const Vec3> positions, std::span<const Element> elements, const Cell* cell,
                       const NeighbourList& exclusions) {
  lists_ = find_lists(positions, elements, cell, exclusions, parameters_, *kernel_, options_.own_lists);
}

void LjSum::for_all(std::size_t count, const std::function<void(std::size_t)>& task) const {
  if (options_.parallel && count > 1)
    options_.parallel(count, task);
  else
    for (std::size_t index = 0; index < count; ++index) task(index);
}

bool LjSum::place(const double* positions, const Cell* cell) {
  const std::vector<Vec3> moves = translations(lists_, cell);
  std::vector<std::uint8_t> holds(lists_.chunks.size()), searched(lists_.chunks.size());
  for_all(lists_.chunks.size(), [&](std::size_t c) {
    LjChunk& chunk = lists_.chunks[c];
    const double moved = place_atoms(chunk, positions, moves);
    searched[c] = !(2.0 * moved <= options_.inner_margin);
    if (searched[c]) search_rows(chunk, *kernel_, parameters_, options_.inner_margin);
    // The rows hold whatever was in the list; the list holds as long as nothing has come from beyond it.
    holds[c] = 2.0 * (chunk.strayed + (searched[c] ? 0.0 : moved)) <= lists_.margin;
  });
  searches_ += static_cast<std::size_t>(std::count(searched.begin(), searched.end(), 1));
  return std::count(holds.begin(), holds.end(), 0) == 0;
}

LjResult LjSum::evaluate(double* forces, LjWanted wanted) {
  chunk_results_.assign(lists_.chunks.size(), {});
  for_all(lists_.chunks.size(), [&](std::size_t c) {
    LjChunk& chunk = lists_.chunks[c];
    const LjData data = {&constants_, chunk.clusters.data(), chunk.rows.data(), chunk.rows.size(),
                         chunk.entries.data()};
    chunk_results_[c].energy = kernel_->evaluate(data, lj_variant(parameters_, wanted.energy, chunk.mixed));
    if (wanted.virial) chunk_results_[c].virial = virial_of(chunk);
  });
  const std::size_t atoms = lists_.offsets.empty() ? 0 : lists_.offsets.size() - 1;
  for_all((atoms + atoms_a_task - 1) / atoms_a_task, [&](std::size_t task) {
    for (std::size_t a = task * atoms_a_task; a < std::min(atoms, (task + 1) * atoms_a_task); ++a)
      for (std::uint32_t k = lists_.offsets[a]; k < lists_.offsets[a + 1]; ++k) {
        const LjLists::Share share = lists_.shares[k];
        const LjCluster& cluster = lists_.chunks[share.chunk].clusters[share.place / lj_lanes];
        for (int d = 0; d < 3; ++d) forces[3 * a + d] += cluster.force[d][share.place % lj_lanes];
      }
  });
  LjResult result;
  for (const LjResult& part : chunk_results_) {
    result.energy += part.energy;
    result.virial += part.virial;
  }
  return result;
}

void LjSum::add_shares(std::span<double> energies, std::span<Mat3> virials) const {
  for (const LjChunk& chunk : lists_.chunks)
    for (const LjRow& row : chunk.rows)
      for (std::uint32_t k = row.begin; k < row.end; ++k)
        for (std::uint32_t l = 0; l < lj_lanes; ++l) {
          const LjEntry entry = chunk.entries[k];
          if (!(entry >> l & 1)) continue;
          const std::uint32_t other = lj_lanes * (entry >> lj_number_bit) + l;
          Vec3 delta;
          for (int d = 0; d < 3; ++d)
            delta[d] = chunk.clusters[row.place / lj_lanes].position[d][row.place % lj_lanes] -
                       chunk.clusters[other / lj_lanes].position[d][l];
          const double r = delta.norm();
          const LjValue value = lj_value(parameters_, row.element + (entry >> lj_kind_bit >> l & 1), r);
          const Mat3 virial = (-value.slope / r) * delta * delta.transpose();
          for (const std::uint32_t place : {row.place, other}) {
            if (!energies.empty()) energies[chunk.atoms[place]] += 0.5 * value.energy;
            if (!virials.empty()) virials[chunk.atoms[place]] += 0.5 * virial;
          }
        }
}

}  // namespace nanocarbon::airebo
