// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a text of others shown where some of its characters would do more than stand there?
//
// Names come from files and command lines and may hold anything. Each target has one function.

#include <cstddef>
#include <string>
#include <string_view>

namespace vandplan::base {

/// Length of the UTF-8 character that a text begins with [bytes]; 0 if it is none.
[[nodiscard]] std::size_t character_length(std::string_view text);

/// A text as a terminal may have it, on one line: control characters and bytes that are no UTF-8
/// are written as "\x1b", those that turn the direction of writing as "\u202e".
[[nodiscard]] std::string printable(std::string_view text);

/// JSON as a terminal may have it: control characters, which JSON lets stand from U+007F on, and
/// those that turn the direction of writing become "\u009b".
[[nodiscard]] std::string json_text(std::string_view json);

/// A text inside Markdown, on one line: a backslash stands before what would begin another cell,
/// code, a link or HTML, and the rest is printable.
[[nodiscard]] std::string markdown(std::string_view text);

/// A cell of CSV (RFC 4180). A spreadsheet would run a text that begins like a formula: an
/// apostrophe stands before that.
[[nodiscard]] std::string csv_cell(std::string_view text);

/// A word of a shell's command line, in quotes where it needs them.
[[nodiscard]] std::string shell_word(std::string_view text);

/// The name of a file as a word of a shell's command line that is not taken for an option.
[[nodiscard]] std::string shell_file(std::string_view file);

}  // namespace vandplan::base
