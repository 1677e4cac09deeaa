// SPDX-License-Identifier: GPL-2.0-or-later
#include "bond_topology/restart_data.h"

#include <array>
#include <cstring>

namespace nanocarbon {
namespace {

constexpr std::array<char, 8> format = {'b', 'o', 'n', 'd', 't', 'o', 'p', '1'};

template <typename Value>
void append(std::string& bytes, const Value& value) {
  static_assert(std::is_trivially_copyable_v<Value>);
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <typename Value>
Value take(const char*& bytes) {
  Value value;
  std::memcpy(&value, bytes, sizeof value);
  bytes += sizeof value;
  return value;
}

}  // namespace

std::string to_bytes(const RestartData& data) {
  std::string bytes;
  append(bytes, format);
  append(bytes, static_cast<std::uint64_t>(data.start.ids.size()));
  append(bytes, static_cast<std::uint64_t>(data.start.bonds.size()));
  append(bytes, static_cast<std::uint64_t>(data.bonds.size()));
  for (const std::int64_t id : data.start.ids) append(bytes, id);
  for (const Element element : data.start.elements) append(bytes, element);
  for (const topology::BondEnd& bond : data.start.bonds) {
    append(bytes, bond.atom);
    append(bytes, bond.neighbour);
    for (int axis = 0; axis < 3; ++axis) append(bytes, bond.vector[axis]);
  }
  for (const topology::BondedIds& bond : data.bonds) {
    append(bytes, bond.first);
    append(bytes, bond.second);
  }
  return bytes;
}

bool from_bytes(const char* bytes, RestartData& data) {
  if (take<std::array<char, 8>>(bytes) != format) return false;
  const auto atoms = take<std::uint64_t>(bytes);
  const auto start_bonds = take<std::uint64_t>(bytes);
  const auto bonds = take<std::uint64_t>(bytes);
  data = {};
  for (std::uint64_t a = 0; a < atoms; ++a) data.start.ids.push_back(take<std::int64_t>(bytes));
  for (std::uint64_t a = 0; a < atoms; ++a) data.start.elements.push_back(take<Element>(bytes));
  for (std::uint64_t b = 0; b < start_bonds; ++b) {
    topology::BondEnd bond;
    bond.atom = take<std::int64_t>(bytes);
    bond.neighbour = take<std::int64_t>(bytes);
    for (int axis = 0; axis < 3; ++axis) bond.vector[axis] = take<double>(bytes);
    data.start.bonds.push_back(bond);
  }
  for (std::uint64_t b = 0; b < bonds; ++b) {
    const auto first = take<std::int64_t>(bytes);
    data.bonds.push_back({first, take<std::int64_t>(bytes)});
  }
  return true;
}

}  // namespace nanocarbon
