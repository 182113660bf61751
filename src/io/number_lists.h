// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which lists in a YAML text are simple enough to be read without a YAML parser?
//
// Large scenarios are lists of numbers, one polygon a line. A YAML parser is forty times slower for
// them.

#include <string>
#include <string_view>
#include <vector>

#include "io/document.h"

namespace vandplan::io {

/// First character of a mark; it occurs in no YAML text.
inline constexpr char mark_of_lists = '\x01';

/// Lines that contain only lists of numbers in brackets: "  - [[0, 1], [2, 3]]" on consecutive
/// lines at one depth, or a single line "key: [...]".
struct NumberLists {
  std::string_view lines;
  int line = 1;  ///< Number of the first line.
};

/// YAML text in which marks replace the lists of numbers. It has as many lines as before.
struct ShortenedText {
  /// Text with marks. Each of `lists` is replaced by a scalar in quotes on its line, `mark_of(0)`
  /// for the first. In quotes a scalar ends where a list in brackets would.
  std::string text;
  std::vector<NumberLists> lists;
};

/// Shortens a text; the result refers to `text`. Each line is judged alone: a line within a longer
/// quoted text is also replaced, which the parser has to notice.
[[nodiscard]] ShortenedText without_number_lists(std::string_view text);

/// Scalar that replaces the list of this number.
[[nodiscard]] std::string mark_of(std::size_t number);

/// Passes the lists to `builder`, as a YAML parser would.
void replay(const NumberLists& lists, NodeBuilder& builder);

}  // namespace vandplan::io
