#include "command_text.h"

#include <algorithm>

namespace nanocarbon {
namespace {

std::string quoted(const std::string& word) {
  const bool plain = !word.empty() && std::all_of(word.begin(), word.end(), [](unsigned char c) {
    return std::isalnum(c) || std::string("-_./+=:,@%").find(static_cast<char>(c)) != std::string::npos;
  });
  return plain ? word : "'" + word + "'";
}

}  // namespace

std::string command_text(const CLI::App& subcommand) {
  std::string text = subcommand.get_parent() ? command_text(*subcommand.get_parent()) + " " : std::string();
  text += subcommand.get_name();
  for (const bool positional : {true, false})
    for (const CLI::Option* option : subcommand.get_options()) {
      if (option->count() == 0 || option->get_positional() != positional) continue;
      if (!positional) text += " " + option->get_name();
      if (positional || option->get_items_expected_max() > 0)
        for (const std::string& word : option->results()) text += " " + quoted(word);
    }
  return text;
}

}  // namespace nanocarbon
