// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do values of options become text, and text values?

#include <algorithm>
#include <array>
#include <charconv>
#include <concepts>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "base/text.h"
#include "vandplan/input_error.h"
#include "vandplan/plan_options.h"

namespace vandplan::problem {

/// Names of the enumerators of a type, in their order.
template <typename Enum>
inline constexpr std::array<std::string_view, 0> words_of = {};
template <>
inline constexpr std::array<std::string_view, 3> words_of<InitialGear> = {"any", "forward",
                                                                          "reverse"};
template <>
inline constexpr std::array<std::string_view, 3> words_of<AllowedGears> = {"both", "forward",
                                                                           "reverse"};
template <>
inline constexpr std::array<std::string_view, 2> words_of<CostMeasure> = {"prices", "time"};
template <>
inline constexpr std::array<std::string_view, 2> words_of<Style> = {"shortest", "driver"};
template <>
inline constexpr std::array<std::string_view, 3> words_of<Steering> = {
    "reeds-shepp", "continuous-between-stops", "continuous"};

template <typename Value>
concept Word = std::is_enum_v<Value>;
template <typename Value>
concept Number = std::is_arithmetic_v<Value> && !std::same_as<Value, bool>;

/// Words as alternatives: "prices or time", "both, forward or reverse".
template <typename Words>
[[nodiscard]] std::string either(const Words& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    text += i == 0 ? "" : i + 1 == words.size() ? " or " : ", ";
    text += words[i];
  }
  return text;
}

/// The range of numbers as text: "0 to 1", ">= 0", "any number".
[[nodiscard]] std::string range_of(double least, double most, bool is_whole);

// ---- the JSON of a value ----

[[nodiscard]] inline std::string json_text(bool value) { return value ? "true" : "false"; }

[[nodiscard]] inline std::string json_text(std::string_view value) {
  return "\"" + std::string(value) + "\"";
}

template <Number Value>
[[nodiscard]] std::string json_text(Value value) {
  return base::shortest_text(value);
}

template <Word Value>
[[nodiscard]] std::string json_text(Value value) {
  return json_text(words_of<Value>[static_cast<std::size_t>(value)]);
}

template <typename Value>
[[nodiscard]] std::string json_text(const std::optional<Value>& value) {
  return value ? json_text(*value) : "null";
}

// ---- the value of a text ----
// Throws InputError with an empty key: the caller adds the name of the option.

[[noreturn]] inline void reject(std::string_view text, const std::string& expected) {
  throw InputError("", json_text(text) + " is not " + expected);
}

inline void parse(std::string_view text, std::string& field) { field = text; }

inline void parse(std::string_view text, bool& field) {
  if (text != "true" && text != "false") reject(text, "true or false");
  field = text == "true";
}

template <Number Value>
void parse(std::string_view text, Value& field) {
  Value number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  if (!whole) reject(text, std::is_integral_v<Value> ? "a whole number in range" : "a number");
  field = number;
}

template <Word Value>
void parse(std::string_view text, Value& field) {
  const auto& words = words_of<Value>;
  const auto* const found = std::find(words.begin(), words.end(), text);
  if (found == words.end()) reject(text, either(words));
  field = static_cast<Value>(found - words.begin());
}

template <typename Value>
void parse(std::string_view text, std::optional<Value>& field) {
  if (text == "null") {
    field.reset();
  } else {
    parse(text, field.emplace());
  }
}

}  // namespace vandplan::problem
