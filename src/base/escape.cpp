// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "base/escape.h"

#include <algorithm>
#include <cstdint>

namespace vandplan::base {
namespace {

unsigned byte_at(std::string_view text, std::size_t i) {
  return static_cast<unsigned char>(text[i]);
}

/// Code point of the first character of a text, `length` bytes long.
std::uint32_t code_of(std::string_view text, std::size_t length) {
  if (length == 1) return byte_at(text, 0);
  std::uint32_t code = byte_at(text, 0) & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) code = code << 6 | (byte_at(text, i) & 0x3FU);
  return code;
}

bool is_control(std::uint32_t code) { return code < 0x20 || (code >= 0x7F && code < 0xA0); }

/// Whether a character ends a line or paragraph, turns the direction of writing, or marks byte
/// order.
bool is_invisible(std::uint32_t code) {
  return (code >= 0x200E && code <= 0x200F) || (code >= 0x2028 && code <= 0x202E) ||
         (code >= 0x2066 && code <= 0x2069) || code == 0x61C || code == 0xFEFF;
}

std::string in_hex(std::uint32_t value, int digits) {
  std::string text;
  for (int i = digits - 1; i >= 0; --i) text += "0123456789abcdef"[value >> (4 * i) & 15U];
  return text;
}

/// Calls `keep(bytes)` for each character that can be shown, and `escape(code, bytes)` for each
/// that cannot. A byte that is no UTF-8 is its own code.
template <class Keep, class Escape>
void for_each_character(std::string_view text, Keep keep, Escape escape) {
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    const std::string_view bytes = text.substr(0, std::max<std::size_t>(length, 1));
    const std::uint32_t code = code_of(bytes, bytes.size());
    if (length == 0 || is_control(code) || is_invisible(code)) {
      escape(code, bytes);
    } else {
      keep(bytes);
    }
    text.remove_prefix(bytes.size());
  }
}

/// The text with a backslash before each of `characters`.
std::string with_backslashes(std::string_view text, std::string_view characters) {
  std::string result;
  for (const char c : text) {
    if (characters.find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

bool is_plain_in_shell(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("_@%+=:,./-").find(c) != std::string_view::npos;
}

}  // namespace

std::size_t character_length(std::string_view text) {
  if (text.empty()) return 0;
  const unsigned first = byte_at(text, 0);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte_at(text, i) & 0xC0) != 0x80) return 0;
  }
  // Wrong are overlong forms, surrogates, and numbers beyond Unicode.
  const unsigned second = byte_at(text, 1);
  const bool is_wrong = (first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) ||
                        (first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F);
  return is_wrong ? 0 : length;
}

std::string printable(std::string_view text) {
  std::string result;
  for_each_character(
      text, [&](std::string_view bytes) { result += bytes; },
      [&](std::uint32_t code, std::string_view) {
        result += code < 0x100 ? "\\x" + in_hex(code, 2) : "\\u" + in_hex(code, 4);
      });
  return result;
}

std::string json_text(std::string_view json) {
  std::string result;
  for_each_character(
      json, [&](std::string_view bytes) { result += bytes; },
      [&](std::uint32_t code, std::string_view bytes) {
        result += code < 0x20 ? std::string(bytes) : "\\u" + in_hex(code, 4);
      });
  return result;
}

std::string markdown(std::string_view text) {
  return printable(with_backslashes(text, "\\|`*[]<"));
}

std::string csv_cell(std::string_view text) {
  std::string cell(text);
  if (!cell.empty() && std::string_view("=+-@\t\r").find(cell[0]) != std::string_view::npos) {
    cell.insert(0, 1, '\'');
  }
  if (cell.find_first_of(",\"\n\r") == std::string::npos) return cell;
  std::string quoted = "\"";
  for (const char c : cell) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

std::string shell_word(std::string_view text) {
  if (!text.empty() && std::all_of(text.begin(), text.end(), is_plain_in_shell)) {
    return std::string(text);
  }
  std::string in_quotes, in_dollar_quotes;
  bool is_shown = true;
  for_each_character(
      text,
      [&](std::string_view bytes) {
        in_quotes += bytes == "'" ? "'\\''" : std::string(bytes);
        in_dollar_quotes += with_backslashes(bytes, "\\'");
      },
      [&](std::uint32_t, std::string_view bytes) {
        is_shown = false;
        for (std::size_t i = 0; i < bytes.size(); ++i)
          in_dollar_quotes += "\\x" + in_hex(byte_at(bytes, i), 2);
      });
  return is_shown ? "'" + in_quotes + "'" : "$'" + in_dollar_quotes + "'";
}

std::string shell_file(std::string_view file) {
  const bool looks_like_option = file.size() > 1 && file.front() == '-';
  return shell_word(looks_like_option ? "./" + std::string(file) : std::string(file));
}

}  // namespace vandplan::base
