// SPDX-License-Identifier: GPL-2.0-or-later
//! \file
//! \brief The object's one exported function. It may use nothing of LAMMPS that could differ between versions
//! until it knows that it runs in the version it was built for.

#include <dlfcn.h>
#include <mpi.h>

#include <cstdio>
#include <string>

#include "lammps_version.h"
#include "lmptype.h"
#include "plugin/lammps_plugin_abi.h"
#include "plugin/styles.h"

// LAMMPS's C library interface, the part of LAMMPS that stays; weak, so that a missing one can be told.
extern "C" {
[[gnu::weak]] int lammps_version(void* lmp);
[[gnu::weak]] int lammps_extract_setting(void* lmp, const char* keyword);
[[gnu::visibility("default")]] void lammpsplugin_init(void* lmp, void* handle, void* plugin_register);
}

namespace nanocarbon {
namespace {

std::string version_text(int number) {
  static const char* const months[] = {"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                       "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
  const int month = number / 100 % 100;
  if (month < 1 || month > 12) return "of unknown version";
  return std::to_string(number % 100) + " " + months[month - 1] + " " + std::to_string(number / 10000);
}

// Why the object cannot be used here; empty when it can.
std::string reason_to_refuse(void* lmp) {
  const int running = lammps_version != nullptr ? lammps_version(lmp) : 0;
  if (running != NANOCARBON_LAMMPS_VERSION)
    return "nanocarbonplugin.so was built for LAMMPS " NANOCARBON_LAMMPS_DATE ", but this is LAMMPS " +
           version_text(running) + ": build it again for this LAMMPS";
  if (lammps_extract_setting == nullptr) return {};
  for (const auto& [name, ours] : {std::pair{"tagint", sizeof(LAMMPS_NS::tagint)},
                                   {"imageint", sizeof(LAMMPS_NS::imageint)},
                                   {"bigint", sizeof(LAMMPS_NS::bigint)}}) {
    const int theirs = lammps_extract_setting(lmp, name);
    if (theirs != static_cast<int>(ours))
      return std::string("nanocarbonplugin.so was built for a LAMMPS whose ") + name + " has " +
             std::to_string(8 * ours) + " bits, but this one's has " + std::to_string(8 * theirs) +
             ": build it again with the same LAMMPS_SMALLBIG, LAMMPS_BIGBIG or LAMMPS_SMALLSMALL";
  }
  return {};
}

// LAMMPS's error class, whichever it is: its member functions are looked up by name, for headers of newer
// versions make one of them inline, and this object's own copy would call what an older LAMMPS does not have.
class AnyError;
using Text = std::string;

template <typename Function>
Function* find(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}

// Stops LAMMPS as its own errors do. The error class has been the second member of class LAMMPS since before
// there were plugins; where its function has changed, a message and no styles must do.
void refuse(void* lmp, const std::string& message) {
  auto* const error = static_cast<AnyError**>(lmp)[1];
  const std::string file = "plugin_init.cpp";
  // Error::all(file, line, message), and since 2025 (file, line, place of the wrong word, message).
  if (auto* const stop = find<void(AnyError*, const Text&, int, const Text&)>(
          "_ZN9LAMMPS_NS5Error3allERKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEEiS8_"))
    stop(error, file, __LINE__, message);
  constexpr int no_word = -2;
  if (auto* const stop = find<void(AnyError*, const Text&, int, int, const Text&)>(
          "_ZN9LAMMPS_NS5Error3allERKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEEiiS8_"))
    stop(error, file, __LINE__, no_word, message);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0) std::fprintf(stderr, "ERROR: %s\n", message.c_str());
}

}  // namespace
}  // namespace nanocarbon

void lammpsplugin_init(void* lmp, void* handle, void* plugin_register) {
  using namespace nanocarbon;
  const std::string reason = reason_to_refuse(lmp);
  if (!reason.empty()) {
    refuse(lmp, reason);
    return;
  }
  auto* const register_style = reinterpret_cast<PluginRegister*>(plugin_register);
  for (PluginStyle style : plugin_styles()) {
    style.handle = handle;
    register_style(&style, lmp);
  }
}
