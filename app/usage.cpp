// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "usage.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/nearest_word.h"
#include "vandplan/planner.h"

namespace vandplan::app {
namespace {

/// An argument that no command takes, and the command that it was given to.
struct Stray {
  const CLI::App& command;
  std::string text;
};

Stray stray_of(const CLI::App& app) {
  const CLI::App* command = &app;
  while (command->remaining_size() == 0 && !command->get_subcommands().empty()) {
    command = command->get_subcommands().front();
  }
  const std::vector<std::string> rest = command->remaining();
  const auto first = std::ranges::find_if(rest, [](const auto& text) { return text != "--"; });
  return {*command, first == rest.end() ? "" : *first};
}

/// Command line that prints the help on a command, such as "vandplan plan --help".
std::string help_of(const CLI::App& command) {
  const CLI::App* const parent = command.get_parent();
  const std::string name =
      parent == nullptr ? "vandplan" : parent->get_name() + " " + command.get_name();
  return name + " --help";
}

/// The keys that --set takes, whatever the planner.
std::vector<std::string_view> keys_of_set() {
  std::vector<std::string_view> keys;
  for (const CommonOption& option : style_and_common_options()) keys.push_back(option.name);
  for (const Planner& planner : planners()) {
    for (const OptionInfo& info : planner.options) keys.emplace_back(info.name);
  }
  return keys;
}

/// Value behind an unknown option, such as "0.3" of "--margin=0.3" or "--margin 0.3"; "VALUE" if
/// there is none.
std::string value_behind(const std::string& option, const std::vector<std::string>& arguments) {
  if (const std::size_t equals = option.find('='); equals != std::string::npos) {
    return option.substr(equals + 1);
  }
  const auto place = std::ranges::find(arguments, option);
  const bool has_value =
      place != arguments.end() && place + 1 != arguments.end() && !(place + 1)->starts_with("--");
  return has_value ? *(place + 1) : "VALUE";
}

/// Name of the command's option that is nearest to an unknown name. For a name of one letter it is
/// the first option that begins with the letter. Empty if there is none.
std::string option_meant(const CLI::App& command, std::string_view name) {
  std::vector<std::string_view> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& known : option->get_lnames()) names.emplace_back(known);
  }
  const auto begins = [&](std::string_view known) { return known.front() == name.front(); };
  if (name.size() == 1) {
    const auto found = std::ranges::find_if(names, begins);
    return found == names.end() ? "" : std::string(*found);
  }
  return std::string(base::nearest_word(name, names));
}

std::string unknown_option(const Stray& stray, const std::vector<std::string>& arguments) {
  const std::string typed = stray.text.substr(0, stray.text.find('='));
  const std::size_t dashes = typed.find_first_not_of('-');
  const std::string name = dashes == std::string::npos ? "" : typed.substr(dashes);
  const std::string help = help_of(stray.command);
  if (name.empty()) return fmt::format("{}: unknown option, see {}", typed, help);
  const bool sets_keys = stray.command.get_option_no_throw("--set") != nullptr;
  std::string as_key = name;
  std::ranges::replace(as_key, '-', '_');
  const std::vector<std::string_view> keys = keys_of_set();
  if (sets_keys && std::ranges::find(keys, as_key) != keys.end()) {
    return fmt::format("{}: unknown option, expected --set {}={}", typed, as_key,
                       value_behind(stray.text, arguments));
  }
  if (const std::string meant = option_meant(stray.command, name); !meant.empty()) {
    return fmt::format("{}: unknown option, did you mean --{}? See {}", typed, meant, help);
  }
  const std::string_view key = sets_keys ? base::nearest_word(as_key, keys) : "";
  if (!key.empty()) {
    return fmt::format("{}: unknown option, did you mean --set {}={}? See {}", typed, key,
                       value_behind(stray.text, arguments), help);
  }
  return fmt::format("{}: unknown option, see {}", typed, help);
}

std::string stray_problem(const Stray& stray, const std::vector<std::string>& arguments) {
  if (stray.text.starts_with('-') && stray.text.find_first_of("0123456789.") != 1) {
    return unknown_option(stray, arguments);
  }
  const auto all = stray.command.get_subcommands([](const CLI::App*) { return true; });
  if (!all.empty() && stray.command.get_subcommands().empty()) {
    return fmt::format("\"{}\" is no command, {}", stray.text,
                       base::expected_one_of(stray.text, all, &CLI::App::get_name));
  }
  return fmt::format("\"{}\" is one argument too many, see {}", stray.text, help_of(stray.command));
}

}  // namespace

std::string usage_problem(const CLI::App& app, const CLI::ParseError& error,
                          const std::vector<std::string>& arguments) {
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
    return stray_problem(stray_of(app), arguments);
  }
  std::string text = error.what();
  constexpr std::string_view no_number = "Could not convert: ";  // before "--runs = x"
  const std::size_t equals = text.find(" = ");
  if (text.starts_with(no_number) && equals != std::string::npos) {
    return fmt::format("{}: \"{}\" is not a number in range",
                       text.substr(no_number.size(), equals - no_number.size()),
                       text.substr(equals + 3));
  }
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) == nullptr) return text;
  const std::string option = text.substr(0, text.find(':'));
  if (text.find("At Most 1 required") != std::string::npos) {
    return option + ": is given more than once, expected one value";
  }
  if (text.ends_with(" missing")) return option + ": is given without a value, expected one";
  return text;
}

}  // namespace vandplan::app
