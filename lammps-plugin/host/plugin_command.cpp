// SPDX-License-Identifier: GPL-2.0-or-later
#include "host/plugin_command.h"

#include <dlfcn.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "comm.h"
#include "compute.h"
#include "error.h"
#include "fix.h"
#include "force.h"
#include "host/plugin_file.h"
#include "input.h"
#include "modify.h"
#include "plugin/lammps_plugin_abi.h"
#include "utils.h"
// A parameter of LAMMPS's own has the name of a member.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
#include "command.h"
#pragma GCC diagnostic pop

using namespace LAMMPS_NS;

namespace nanocarbon {
namespace {

// What was ever loaded into this process. Whether a LAMMPS has a style from it is asked of that LAMMPS's own
// maps, which `clear` empties.
std::vector<PluginStyle>& known_styles() {
  static std::vector<PluginStyle> styles;
  return styles;
}

// Calls action(map, creator) with LAMMPS's map for the style's kind; false for a kind that has none here.
template <typename Action>
bool with_map(LAMMPS& lmp, const PluginStyle& style, const Action& action) {
  const std::string kind = style.kind;
  if (kind == "pair")
    action(*lmp.force->pair_map, reinterpret_cast<Force::PairCreator>(style.make_one));
  else if (kind == "command")
    action(*lmp.input->command_map, reinterpret_cast<Input::CommandCreator>(style.make_one));
  else if (kind == "fix")
    action(*lmp.modify->fix_map, reinterpret_cast<Modify::FixCreator>(style.make_with_arguments));
  else if (kind == "compute")
    action(*lmp.modify->compute_map, reinterpret_cast<Modify::ComputeCreator>(style.make_with_arguments));
  else
    return false;
  return true;
}

bool loaded(LAMMPS& lmp, const PluginStyle& style) {
  bool found = false;
  with_map(lmp, style, [&](auto& map, auto creator) {
    const auto entry = map.find(style.name);
    found = entry != map.end() && entry->second == creator;
  });
  return found;
}

void say(LAMMPS& lmp, const std::string& text) {
  if (lmp.comm->me == 0) utils::logmesg(&lmp, text);
}

std::string full_name(const PluginStyle& style) { return std::string(style.kind) + " style " + style.name; }

// The callback that a plugin's entry point gets.
void register_style(PluginStyle* style, void* lammps) {
  LAMMPS& lmp = *static_cast<LAMMPS*>(lammps);
  if (loaded(lmp, *style)) {
    say(lmp, "Ignoring load of " + full_name(*style) + ": it is loaded\n");
    return;
  }
  bool replaces = false;
  const bool supported = with_map(lmp, *style, [&](auto& map, auto creator) {
    replaces = map.count(style->name) > 0;
    map[style->name] = creator;
  });
  if (!supported) {
    say(lmp, "Ignoring load of " + full_name(*style) + ": no plugins of this kind\n");
    return;
  }
  say(lmp, "Loading plugin: " + std::string(style->info) + " by " + style->author + "\n");
  if (replaces && lmp.comm->me == 0)
    lmp.error->warning(FLERR, "Overriding built-in " + full_name(*style) + " from plugin");
  auto& known = known_styles();
  const auto same = [&](const PluginStyle& other) {
    return std::strcmp(other.kind, style->kind) == 0 && std::strcmp(other.name, style->name) == 0;
  };
  known.erase(std::remove_if(known.begin(), known.end(), same), known.end());
  known.push_back(*style);
}

void load(LAMMPS& lmp, const std::string& name) {
  const PluginFile file = find_plugin_file(name);
  if (file.path.empty()) {
    std::string message = "plugin load: no file " + name + ". Looked for:";
    for (const auto& path : file.looked) message.append(" ").append(path.string());
    lmp.error->all(FLERR, message);
  }
  // Never closed: styles made from it may live as long as the process, and loading it again costs nothing.
  void* const object = dlopen(file.path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (object == nullptr) {
    const char* const why = dlerror();
    lmp.error->all(FLERR,
                   "plugin load: cannot open " + file.path.string() + ": " + (why ? why : "no reason given"));
  }
  void* const entry = dlsym(object, plugin_entry_point);
  if (entry == nullptr)
    lmp.error->all(FLERR, "plugin load: " + file.path.string() + " is not a LAMMPS plugin: it has no function " +
                              plugin_entry_point);
  (*reinterpret_cast<PluginInit*>(entry))(&lmp, object, reinterpret_cast<void*>(&register_style));
}

// Deletes what is made from the style before the style goes.
void delete_instances(LAMMPS& lmp, const PluginStyle& style) {
  const std::string kind = style.kind;
  if (kind == "fix")
    for (int i = lmp.modify->nfix - 1; i >= 0; --i) {
      if (std::strcmp(lmp.modify->fix[i]->style, style.name) == 0) lmp.modify->delete_fix(i);
    }
  if (kind == "compute")
    for (int i = lmp.modify->ncompute - 1; i >= 0; --i) {
      if (std::strcmp(lmp.modify->compute[i]->style, style.name) == 0) lmp.modify->delete_compute(i);
    }
  if (kind == "pair" && lmp.force->pair_match(style.name, 1, 1) != nullptr) lmp.force->create_pair("none", 0);
}

void unload(LAMMPS& lmp, const std::string& kind, const std::string& name) {
  for (const PluginStyle& style : known_styles())
    if (style.kind == kind && style.name == name && loaded(lmp, style)) {
      say(lmp, "Unloading " + full_name(style) + "\n");
      delete_instances(lmp, style);
      with_map(lmp, style, [&](auto& map, auto) { map.erase(style.name); });
      return;
    }
  say(lmp, "Ignoring unload of " + kind + " style " + name + ": it is not from a plugin\n");
}

class PluginCommand : public Command {
 public:
  explicit PluginCommand(LAMMPS* lammps) : Command(lammps) {}

  void command(int narg, char** arg) override {
    const std::string what = narg > 0 ? arg[0] : "";
    if (what == "load" && narg > 1) {
      const std::vector<std::string> names(arg + 1, arg + narg);
      for (const std::string& name : names) load(*lmp, name);
    } else if (what == "unload" && narg == 3) {
      unload(*lmp, arg[1], arg[2]);
    } else if (what == "clear" && narg == 1) {
      for (const PluginStyle& style : known_styles())
        if (loaded(*lmp, style)) unload(*lmp, style.kind, style.name);
    } else if (what == "list" && narg == 1) {
      list();
    } else {
      error->all(FLERR,
                 std::string("Illegal plugin command: use load FILE..., unload STYLE NAME, list or clear"));
    }
  }

 private:
  void list() {
    std::string text = "Currently loaded plugins\n";
    int count = 0;
    for (const PluginStyle& style : known_styles())
      if (loaded(*lmp, style))
        text += "   " + std::to_string(++count) + ": " + style.kind + " style plugin " + style.name + "\n";
    say(*lmp, text);
  }
};

Command* make_plugin_command(LAMMPS* lmp) { return new PluginCommand(lmp); }

}  // namespace

void add_plugin_command(LAMMPS& lmp) { lmp.input->command_map->emplace("plugin", make_plugin_command); }

}  // namespace nanocarbon
