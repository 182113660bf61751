// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do numbers and lists become text?

#include <array>
#include <charconv>
#include <functional>
#include <string>
#include <string_view>

namespace vandplan::base {

/// The shortest decimal that reads back as `value` in its own type, whatever the locale.
template <class Number>
[[nodiscard]] std::string shortest_text(Number value) {
  std::array<char, 40> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

/// The names of `things` with commas between them. `name_of(thing)` is the name of a thing, by
/// default the thing itself.
template <class Things, class NameOf = std::identity>
[[nodiscard]] std::string joined(const Things& things, NameOf name_of = {}) {
  std::string text;
  for (const auto& thing : things) {
    if (!text.empty()) text += ", ";
    text += std::string_view(std::invoke(name_of, thing));
  }
  return text;
}

}  // namespace vandplan::base
