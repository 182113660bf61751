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
  if (option.name == "time_limit") return fmt::format("{}", default_time_limit);
  return typed_text(option.get(complete(default_planner())));
}

/// An option as the help shows it.
struct OptionText {
  std::string name;
  std::string default_value;
  std::string summary;
};

OptionText option_text(const CommonOption& option) {
  return {std::string(option.name), default_of(option), std::string(option.summary)};
}

OptionText option_text(const OptionInfo& info) {
  return {info.name, typed_text(vandplan::json_of(info.default_value)),
          info.summary + "; " + info.range()};
}

/// Help on the option of that name: a common option, or that of the first planner that has it.
OptionText option_text(std::string_view name) {
  for (const CommonOption& option : common_options()) {
    if (option.name == name) return option_text(option);
  }
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

/// Help on the own options of all planners of a family.
std::string help_on_family(const std::string& family) {
  std::vector<OptionText> texts;
  int members = 0;
  for (const Planner& planner : planners()) {
    if (planner.properties.family != family) continue;
    ++members;
    for (const OptionInfo& info : planner.options) add_to(texts, option_text(info));
  }
  const std::string who =
      members > 1 ? fmt::format("the {} planners {}-...", members, family) : family;
  std::string help = fmt::format("Keys of {}:\n", who);
  for (const OptionText& text : texts) help += line_of(text);
  return help;
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
  std::stable_partition(in_order.begin(), in_order.end(),
                        [](const TypedOption& given) { return is_set_first(given.option); });
  for (const TypedOption& given : in_order) {
    try {
      set_option(options, planner, given.option, given.value);
    } catch (const InputError& error) {
      throw InputError(given.typed, error.problem());
    }
  }
}

std::string help_on_common_options() {
  std::string help =
      line_of({"style", "driver",
               "driver: prices and steering as below; shortest: length only; other options "
               "override it"});
  for (const CommonOption& option : common_options()) help += line_of(option_text(option));
  return help;
}

std::string help_on_options_of(const Planner& planner) {
  std::string help;
  for (const OptionInfo& info : planner.options) help += line_of(option_text(info));
  return help;
}

std::string help_on_own_options() {
  std::string help;
  std::vector<std::string> families;
  for (const Planner& planner : planners()) {
    const std::string& family = planner.properties.family;
    if (std::ranges::find(families, family) != families.end()) continue;
    families.push_back(family);
    help += help_on_family(family);
  }
  return help;
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
