// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/refused_switches.h"

#include <algorithm>
#include <vector>

namespace nanocarbon::annealing {

namespace {

constexpr int lifetime = 3;  // blocks

// A step of FNV-1a on whole words, mixed as in SplitMix64 (Steele et al. 2014).
std::uint64_t mixed(std::uint64_t hash, std::uint64_t value) {
  std::uint64_t z = (hash ^ value) + 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

}  // namespace

std::uint64_t switch_key(const NetworkEdit& edit, std::span<const std::uint32_t> identity) {
  // A bond is known by its ends, other edits by the atoms whose bonds or rings they change.
  std::vector<std::uint32_t> atoms;
  if (edit.kind == NetworkEdit::Kind::flip || edit.kind == NetworkEdit::Kind::collapse) {
    atoms = {identity[edit.centre[0]], identity[edit.centre[1]]};
  } else {
    for (const auto& change : edit.atoms)
      if (change.atom < identity.size()) atoms.push_back(identity[change.atom]);
  }
  std::sort(atoms.begin(), atoms.end());
  if (edit.kind == NetworkEdit::Kind::close) atoms.push_back(static_cast<std::uint32_t>(edit.added));
  std::uint64_t hash = mixed(0, static_cast<std::uint64_t>(edit.kind));
  for (const std::uint32_t a : atoms) hash = mixed(hash, a);
  return hash;
}

bool RefusedSwitches::contains(std::uint64_t key, double allowance, std::uint64_t since) const {
  const auto found = refusals_.find(key);
  return found != refusals_.end() && allowance <= found->second.allowance && since < found->second.now;
}

void RefusedSwitches::add(std::uint64_t key, double allowance, std::uint64_t now) {
  // What was known before was lower or out of date, or the switch would not have been tried again.
  refusals_[key] = {allowance, now, block_};
}

void RefusedSwitches::next_block() {
  ++block_;
  std::erase_if(refusals_, [&](const auto& entry) { return entry.second.block + lifetime <= block_; });
}

}  // namespace nanocarbon::annealing
