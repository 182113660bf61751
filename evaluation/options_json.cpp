// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/options_json.h"

#include <nlohmann/json.hpp>

#include "vandplan/input_error.h"

namespace vandplan::evaluation {
namespace {

std::string typed_json_of(const OptionValue& value) {
  std::string text = vandplan::json_of(value);
  const bool looks_whole = text.find_first_of(".en") == std::string::npos;
  return std::holds_alternative<double>(value) && looks_whole ? text + ".0" : text;
}

OptionValue value_of(const std::string& name, const nlohmann::json& json) {
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_number_integer()) return json.get<std::int64_t>();
  if (json.is_number()) return json.get<double>();
  if (json.is_string()) return json.get<std::string>();
  throw InputError("options", name + " is no number, word, true or false");
}

void set(PlanOptions& options, const std::string& name, const nlohmann::json& value) {
  if (name == processor_clock.first) {
    options.budget.processor_time = true;
    return;
  }
  const CommonOption* const common = find_common_option(name);
  if (common == nullptr) {
    options.planner.set(name, value_of(name, value));
  } else {
    common->set(options, value.is_string() ? value.get<std::string>() : value.dump());
  }
}

}  // namespace

std::vector<std::pair<std::string, std::string>> option_values(const PlanOptions& options) {
  std::vector<std::pair<std::string, std::string>> values;
  for (const CommonOption& option : common_options())
    if (option.name != "seed") values.emplace_back(option.name, option.get(options));
  for (const auto& [name, value] : options.planner.values())
    values.emplace_back(name, typed_json_of(value));
  return values;
}

std::string options_to_json(const PlanOptions& options) {
  std::string json;
  std::vector<std::pair<std::string, std::string>> values = option_values(options);
  if (options.budget.processor_time) values.push_back(processor_clock);
  for (const auto& [name, value] : values)
    json += (json.empty() ? "{\"" : ", \"") + name + "\": " + value;
  return json + "}";
}

PlanOptions options_from_json(const std::string& json) {
  PlanOptions options{.cost = shortest_style};  // older runs do not name all prices
  try {
    const nlohmann::json object = nlohmann::json::parse(json);
    for (const auto& [name, value] : object.items()) set(options, name, value);
  } catch (const nlohmann::json::exception& error) {
    throw InputError("options", error.what());
  }
  return options;
}

}  // namespace vandplan::evaluation
