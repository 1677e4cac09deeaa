// SPDX-License-Identifier: GPL-2.0-or-later
#include "plugin/styles.h"

#include "fix_bond_topology.h"
#include "lammps_version.h"
#include "pair.h"
#include "pair_airebo_opt.h"
#include "pair_rebo_opt.h"

using LAMMPS_NS::Fix;
using LAMMPS_NS::LAMMPS;
using LAMMPS_NS::Pair;

namespace nanocarbon {
namespace {

constexpr const char* author = "the nanocarbon authors";

// LAMMPS casts what these return to the base class, so the base class's address it must be.
template <typename Style>
void* make_fix(void* lmp, int narg, char** arg) {
  return static_cast<Fix*>(new Style(static_cast<LAMMPS*>(lmp), narg, arg));
}

template <typename Style>
void* make_pair(void* lmp) {
  return static_cast<Pair*>(new Style(static_cast<LAMMPS*>(lmp)));
}

template <typename Style>
constexpr PluginStyle fix_style(const char* name, const char* info) {
  return {
      NANOCARBON_LAMMPS_DATE, "fix", name, info, author, {.make_with_arguments = make_fix<Style>}, nullptr};
}

template <typename Style>
constexpr PluginStyle pair_style(const char* name, const char* info) {
  return {NANOCARBON_LAMMPS_DATE, "pair", name, info, author, {.make_one = make_pair<Style>}, nullptr};
}

}  // namespace

std::span<const PluginStyle> plugin_styles() {
  static constexpr PluginStyle table[] = {
      fix_style<FixBondTopology>("bond/topology",
                                 "fix bond/topology: bonds, rings and repelled atoms of sp2 carbon"),
      pair_style<PairAireboOpt>("airebo/opt", "pair airebo/opt: AIREBO for carbon and hydrogen, fast"),
      pair_style<PairAireboMorseOpt>("airebo/morse/opt", "pair airebo/morse/opt: AIREBO-M, fast"),
      pair_style<PairReboOpt>("rebo/opt", "pair rebo/opt: REBO2 for carbon and hydrogen, fast"),
  };
  return table;
}

}  // namespace nanocarbon
