// SPDX-License-Identifier: GPL-2.0-or-later
#include "potential_option.h"

#include <algorithm>
#include <array>

namespace nanocarbon::cli {
namespace {

using building::PotentialChoice;

constexpr std::array choices = {PotentialChoice::rebo2, PotentialChoice::airebo, PotentialChoice::airebo_m};

template <class Choice>
void add_option(CLI::App& app, Choice& choice, const std::string& help) {
  const auto named = [](const std::string& text) {
    return std::find_if(choices.begin(), choices.end(),
                        [&](PotentialChoice c) { return building::name(c) == text; });
  };
  const auto check = [named](const std::string& text) {
    if (named(text) != choices.end()) return std::string();
    std::string message = "takes rebo2, airebo or airebo-m, not '" + text + "'";
    if (text.find_first_of("./") != std::string::npos) message += "; a file goes to --parameters FILE";
    return message;
  };
  app.add_option_function<std::string>(
         "--potential", [&choice, named](const std::string& text) { choice = *named(text); }, help)
      ->check(CLI::Validator(check, ""))
      ->type_name("NAME");
}

}  // namespace

void add_potential_option(CLI::App& app, PotentialChoice& choice, const std::string& help) {
  add_option(app, choice, help);
}

void add_potential_option(CLI::App& app, std::optional<PotentialChoice>& choice, const std::string& help) {
  add_option(app, choice, help);
}

}  // namespace nanocarbon::cli
