// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which known word did somebody mean?

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.h"

namespace vandplan::base {

/// The known word that takes the fewest changes of letters; the first one of several. Empty if
/// every word takes more changes than a third of its letters. Case does not count, and "-" is "_".
[[nodiscard]] std::string_view nearest_word(std::string_view word,
                                            std::span<const std::string_view> known);

/// "did you mean heading? Expected one of x, y, heading", or without the question if no name is
/// near the word. `name_of(thing)` is the name of a thing, by default the thing itself.
template <class Things, class NameOf = std::identity>
[[nodiscard]] std::string expected_one_of(std::string_view word, const Things& things,
                                          NameOf name_of = {}) {
  std::vector<std::string_view> names;
  names.reserve(std::size(things));
  for (const auto& thing : things) names.emplace_back(std::invoke(name_of, thing));
  const std::string_view meant = nearest_word(word, names);
  if (meant.empty()) return "expected one of " + joined(names);
  return "did you mean " + std::string(meant) + "? Expected one of " + joined(names);
}

}  // namespace vandplan::base
