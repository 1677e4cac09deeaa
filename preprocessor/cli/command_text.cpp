// SPDX-License-Identifier: GPL-2.0-or-later
#include "command_text.h"

#include <algorithm>

namespace nanocarbon::cli {
namespace {

// Outputs tell the command that made them. How many threads it had is not said: it does not change them.
constexpr const char* changes_no_output = "--threads";

std::string quoted(const std::string& word) {
  const bool plain = !word.empty() && std::all_of(word.begin(), word.end(), [](unsigned char c) {
    return std::isalnum(c) || std::string("-_./+=:,@%").find(static_cast<char>(c)) != std::string::npos;
  });
  return plain ? word : "'" + word + "'";
}

void append_options(std::string& text, const CLI::App& command, bool positional) {
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() == 0 || option->get_positional() != positional) continue;
    if (option->get_name() == changes_no_output) continue;
    if (!positional) text += " " + option->get_name();
    if (positional || option->get_items_expected_max() > 0)
      for (const std::string& word : option->results()) text += " " + quoted(word);
  }
  // Groups of options are subcommands without a name.
  for (const CLI::App* group :
       command.get_subcommands([](const CLI::App* app) { return app->get_name().empty(); }))
    append_options(text, *group, positional);
}

}  // namespace

std::string command_text(const CLI::App& subcommand) {
  std::string text = subcommand.get_parent() ? command_text(*subcommand.get_parent()) + " " : std::string();
  text += subcommand.get_name();
  append_options(text, subcommand, true);
  append_options(text, subcommand, false);
  return text;
}

}  // namespace nanocarbon::cli
