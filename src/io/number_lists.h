// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which lists in a YAML text are plain enough to be read without a parser of YAML?
//
// Large scenarios are lists of numbers, one polygon a line, and a parser of all of YAML takes forty
// times as long for them as they need.

#include <string>
#include <string_view>
#include <vector>

#include "io/document.h"

namespace vandplan::io {

/// Begins a mark; stands in no YAML text.
inline constexpr char mark_of_lists = '\x01';

/// Lines that hold lists of numbers in brackets and nothing else, "  - [[0, 1], [2, 3]]" each: one
/// after the other at the same depth, or one of them behind "key: ".
struct NumberLists {
  std::string_view lines;
  int line = 1;  ///< of the first one
};

/// A YAML text without its lists of numbers. It has as many lines as before.
struct ShortenedText {
  /// A scalar in quotes, `mark_of(0)` for the first, stands for each of `lists` on its line. Like a
  /// list in brackets, and unlike a scalar without quotes, it ends where it ends.
  std::string text;
  std::vector<NumberLists> lists;
};

/// The text refers to `text`. Lines are judged by themselves: within a longer text in quotes, for
/// example, a mark becomes part of that, which is for whoever parses it to notice.
[[nodiscard]] ShortenedText without_number_lists(std::string_view text);

/// The scalar that stands for a number of the lists.
[[nodiscard]] std::string mark_of(std::size_t number);

/// Hands the lists to `builder`, as a parser of YAML would.
void replay(const NumberLists& lists, NodeBuilder& builder);

}  // namespace vandplan::io
