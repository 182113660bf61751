// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "option_flags.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <sstream>

#include "vandplan/input_error.h"

namespace vandplan::app {
namespace {

/// An option that has a flag of its own.
struct Flag {
  const char* flag;
  const char* option;
  const char* value;
};

constexpr Flag flags[] = {
    {"--time", "time_limit", "S"},     {"--max-iterations", "max_iterations", "N"},
    {"--max-nodes", "max_nodes", "N"}, {"--seed", "seed", "N"},
    {"--threads", "threads", "N"},     {"--region", "region", "bounds|scene"}};

/// A JSON value as a user types it: without quotes.
std::string typed_text(std::string json) {
  std::erase(json, '"');
  return json;
}

std::string default_of(const CommonOption& option) {
  PlanOptions options = complete(default_planner());
  options.style = default_planner().properties.style;
  return typed_text(option.get(options));
}

/// An option as the help shows it.
struct OptionText {
  std::string name;
  std::string default_value;
  std::string summary;
  bool operator==(const OptionText&) const = default;
};

OptionText option_text(const CommonOption& option) {
  return {std::string(option.name), default_of(option), option.text()};
}

OptionText option_text(const OptionInfo& info) {
  return {info.name, typed_text(vandplan::json_of(info.default_value)),
          info.summary + "; " + info.range()};
}

/// Help on the option of that name: of the table, or of the first planner that has it.
OptionText option_text(std::string_view name) {
  if (const CommonOption* const option = find_common_option(name)) return option_text(*option);
  for (const Planner& planner : planners()) {
    const auto found = std::ranges::find(planner.options, name, &OptionInfo::name);
    if (found != planner.options.end()) return option_text(*found);
  }
  return {std::string(name), "", ""};
}

/// An option and its summary in two columns, at most 100 wide.
std::string line_of(const OptionText& text) {
  constexpr std::size_t column = 30;
  constexpr std::size_t widest = 100;
  std::string lines = fmt::format("  {:<28}", text.name + "=" + text.default_value);
  std::size_t at = lines.size();  // length of the current line
  const auto break_line = [&] {
    lines += "\n" + std::string(column, ' ');
    at = column;
  };
  if (at > column) break_line();
  std::istringstream words(text.summary);
  for (std::string word; words >> word;) {
    if (at + word.size() + 1 > widest) break_line();
    if (at > column) word.insert(0, " ");
    lines += word;
    at += word.size();
  }
  return lines + "\n";
}

/// Adds an option of a planner to the options of its family. Different defaults become "a|b".
void add_to(std::vector<OptionText>& texts, const OptionText& text) {
  const auto known = std::ranges::find(texts, text.name, &OptionText::name);
  if (known == texts.end()) {
    texts.push_back(text);
    return;
  }
  const bool is_listed =
      ("|" + known->default_value + "|").find("|" + text.default_value + "|") != std::string::npos;
  if (!is_listed) known->default_value += "|" + text.default_value;
}

/// Planners that are built alike, with the own options of them all.
struct Family {
  std::string name;  ///< "prm", or "hrrt-... (3)" for several planners
  std::vector<OptionText> options;

  [[nodiscard]] bool has(const OptionText& text) const {
    return std::ranges::find(options, text) != options.end();
  }
};

Family family_named(const std::string& name) {
  Family family{name, {}};
  int members = 0;
  for (const Planner& planner : planners()) {
    if (planner.properties.family != name) continue;
    ++members;
    for (const OptionInfo& info : planner.options) add_to(family.options, option_text(info));
  }
  if (members > 1) family.name = fmt::format("{}-... ({})", name, members);
  return family;
}

/// The families of all planners, in the order of their first members.
std::vector<Family> families() {
  std::vector<Family> found;
  std::vector<std::string> names;
  for (const Planner& planner : planners()) {
    const std::string& name = planner.properties.family;
    if (std::ranges::find(names, name) != names.end()) continue;
    names.push_back(name);
    found.push_back(family_named(name));
  }
  return found;
}

}  // namespace

TypedOption typed_setting(const std::string& setting) {
  const std::size_t equals = setting.find('=');
  if (equals == std::string::npos) {
    throw InputError("--set", "\"" + setting + "\" is not KEY=VALUE");
  }
  const std::string key = setting.substr(0, equals);
  return {key, key, setting.substr(equals + 1)};
}

void add_option_flags(CLI::App& command, std::vector<TypedOption>& typed) {
  for (const Flag& flag : flags) {
    const OptionText text = option_text(flag.option);
    const auto add = [&typed, flag](const std::string& value) {
      typed.push_back({flag.flag, flag.option, value});
    };
    command.add_option_function<std::string>(flag.flag, add, text.summary)
        ->type_name(flag.value)
        ->default_str(text.default_value);
  }
  const auto add = [&typed](const std::vector<std::string>& settings) {
    for (const std::string& setting : settings) typed.push_back(typed_setting(setting));
  };
  command
      .add_option_function<std::vector<std::string>>("--set", add,
                                                     "Set an option by its key (below)")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

CLI::Option* add_seed(CLI::App& command, std::uint64_t& seed, const std::string& about) {
  const auto problem_of = [](const std::string& text) -> std::string {
    std::uint64_t value = 0;
    const char* const end = text.data() + text.size();
    const auto [last, error] = std::from_chars(text.data(), end, value);
    if (error == std::errc() && last == end) return "";
    return fmt::format("\"{}\" is not a whole number from 0 to {}", text,
                       std::numeric_limits<std::uint64_t>::max());
  };
  return command.add_option("--seed", seed, about)
      ->type_name("N")
      ->check(CLI::Validator(problem_of, ""))
      ->capture_default_str();
}

PlanOptions options_for(const Planner& planner, std::span<const Setting> wanted_by_file,
                        const std::vector<TypedOption>& typed) {
  PlanOptions options;
  set_honoured(options, planner, wanted_by_file);
  set_typed(options, planner, typed);
  return options;
}

void set_typed(PlanOptions& options, const Planner& planner,
               const std::vector<TypedOption>& typed) {
  std::vector<TypedOption> in_order = typed;
  std::stable_sort(in_order.begin(), in_order.end(),
                   [](const TypedOption& a, const TypedOption& b) {
                     return setting_order(a.option) < setting_order(b.option);
                   });
  for (const TypedOption& given : in_order) {
    try {
      set_option(options, planner, given.option, given.value);
    } catch (const InputError& error) {
      throw InputError(given.typed, error.problem());
    }
  }
}

std::string help_on_common_options() {
  std::string help;
  for (const CommonOption& option : style_and_common_options())
    help += line_of(option_text(option));
  return help;
}

std::string help_on_options_of(const Planner& planner) {
  std::string help;
  for (const OptionInfo& info : planner.options) help += line_of(option_text(info));
  return help;
}

std::string help_on_own_options() {
  const std::vector<Family> all = families();
  std::vector<OptionText> told;
  std::string shared;
  std::string own;
  for (const Family& family : all) {
    std::string lines;
    for (const OptionText& text : family.options) {
      if (std::ranges::find(told, text) != told.end()) continue;
      std::vector<std::string> owners;
      for (const Family& other : all) {
        if (other.has(text)) owners.push_back(other.name);
      }
      if (owners.size() == 1) {
        lines += line_of(text);
        continue;
      }
      told.push_back(text);
      const std::string of = fmt::format(" ({})", fmt::join(owners, ", "));
      shared += line_of({text.name, text.default_value, text.summary + of});
    }
    if (!lines.empty()) own += fmt::format("Keys of {} alone:\n{}", family.name, lines);
  }
  return "Keys of several planners, with who has them:\n" + shared + own;
}

evaluation::Shard shard_in(const std::string& text) {
  evaluation::Shard shard{0, 0};
  const char* const end = text.data() + text.size();
  const auto [slash, first_error] = std::from_chars(text.data(), end, shard.number);
  if (first_error == std::errc() && slash != end && *slash == '/') {
    const auto [last, error] = std::from_chars(slash + 1, end, shard.of);
    if (error == std::errc() && last == end && shard.number >= 1 && shard.number <= shard.of)
      return shard;
  }
  throw InputError("--shard", "\"" + text + "\" is not I/N with I from 1 to N");
}

}  // namespace vandplan::app
