// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a foreign text written where some of its characters would act as commands?
//
// Names come from files and command lines and may hold anything. Each target has one function.

#include <cstddef>
#include <string>
#include <string_view>

namespace vandplan::base {

/// Length of the UTF-8 character that a text begins with [bytes]; 0 if it begins with none.
[[nodiscard]] std::size_t character_length(std::string_view text);

/// The text in a form that is safe on a terminal, on one line. Control characters and bytes that
/// are no UTF-8 become "\x1b", characters that turn the direction of writing become "\u202e".
[[nodiscard]] std::string printable(std::string_view text);

/// The JSON in a form that is safe on a terminal. Control characters from U+007F on, which JSON
/// allows, and those that turn the direction of writing become "\u009b".
[[nodiscard]] std::string json_text(std::string_view json);

/// The text for use inside Markdown, on one line. A backslash stands before characters that would
/// begin another cell, code, a link or HTML; the rest is `printable`.
[[nodiscard]] std::string markdown(std::string_view text);

/// A cell of CSV (RFC 4180). A text that begins like a formula gets an apostrophe in front, because
/// a spreadsheet would run it.
[[nodiscard]] std::string csv_cell(std::string_view text);

/// A word of a shell's command line, in quotes where it needs them.
[[nodiscard]] std::string shell_word(std::string_view text);

/// The name of a file as a word of a shell's command line that is not taken for an option.
[[nodiscard]] std::string shell_file(std::string_view file);

}  // namespace vandplan::base
