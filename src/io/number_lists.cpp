// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "io/number_lists.h"

#include <algorithm>
#include <cstddef>

namespace vandplan::io {
namespace {

constexpr int deepest_list = 8;  // Deeper lists are left to the YAML parser.

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

constexpr bool is_of_number(char c) {
  return is_digit(c) || c == '.' || c == 'e' || c == 'E' || c == '+' || c == '-';
}

constexpr bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// Removes a character from the front of the text, if it is `c`.
bool take(std::string_view& text, char c) {
  if (!text.starts_with(c)) return false;
  text.remove_prefix(1);
  return true;
}

void take_blanks(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
}

/// Removes a text that looks like a number from the front; empty if there is none.
std::string_view take_number(std::string_view& text) {
  const std::size_t sign = text.starts_with('-') || text.starts_with('+') ? 1 : 0;
  if (text.size() == sign || !(is_digit(text[sign]) || text[sign] == '.')) return {};
  const auto* const end = std::find_if_not(text.begin(), text.end(), is_of_number);
  const std::string_view number = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(number.size());
  return number;
}

/// Removes a list of numbers and nested lists from the front of the text. Calls begin(),
/// number(text) and end() of `events`. False if there is no list, or one nested deeper than
/// `levels`.
template <typename Events>
bool take_list(std::string_view& text, int levels, Events& events) {
  if (levels == 0 || !take(text, '[')) return false;
  events.begin();
  take_blanks(text);
  while (!text.starts_with(']')) {
    if (text.starts_with('[')) {
      if (!take_list(text, levels - 1, events)) return false;
    } else {
      const std::string_view number = take_number(text);
      if (number.empty()) return false;
      events.number(number);
    }
    take_blanks(text);
    if (!take(text, ',')) break;
    take_blanks(text);
    if (text.starts_with(']')) return false;
  }
  if (!take(text, ']')) return false;
  events.end();
  return true;
}

struct NoEvents {
  void begin() {}
  void number(std::string_view) {}
  void end() {}
};

struct BuilderEvents {
  NodeBuilder& builder;
  int line;

  void begin() { builder.begin(Node::Kind::list, line); }
  void number(std::string_view text) { builder.scalar(std::string(text), false, line); }
  void end() { builder.end(); }
};

/// Text before the list, "  - " or "  key: ", of a line that otherwise contains only a list. Empty
/// for other lines.
std::string_view before_list(std::string_view line) {
  std::string_view rest = line;
  take_blanks(rest);
  if (!take(rest, '-')) {
    std::size_t letters = 0;
    while (letters < rest.size() && (is_letter(rest[letters]) || rest[letters] == '_')) ++letters;
    rest.remove_prefix(letters);
    if (letters == 0 || !take(rest, ':')) return {};
  }
  if (!rest.starts_with(' ')) return {};
  take_blanks(rest);
  const std::string_view prefix = line.substr(0, line.size() - rest.size());
  NoEvents nobody;
  if (!take_list(rest, deepest_list, nobody)) return {};
  take_blanks(rest);
  return rest.empty() ? prefix : std::string_view();
}

/// Removes a line from the front of the text, with its end.
std::string_view take_line(std::string_view& text) {
  const std::string_view line = text.substr(0, text.find('\n'));
  text.remove_prefix(std::min(line.size() + 1, text.size()));
  return line;
}

std::string_view without_return(std::string_view line) {
  return line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
}

}  // namespace

std::string mark_of(std::size_t number) { return mark_of_lists + std::to_string(number); }

ShortenedText without_number_lists(std::string_view text) {
  ShortenedText result;
  std::string_view before;  // Prefix of the lists that the last line belongs to, or empty.
  std::string_view rest = text;
  for (int number = 1; !rest.empty(); ++number) {
    const char* const begin = rest.data();
    const std::string_view line = take_line(rest);
    const bool is_whole = rest.data() > begin + line.size();  // Whether the line has an end.
    const std::string_view prefix = before_list(is_whole ? without_return(line) : line);
    const bool goes_on = !prefix.empty() && prefix == before && prefix.find('-') != prefix.npos;
    if (prefix.empty()) {
      result.text += line;
    } else if (!goes_on) {
      result.text += std::string(prefix) + '"' + mark_of(result.lists.size()) + '"';
      result.lists.push_back({std::string_view(begin, 0), number});
    }
    if (!prefix.empty()) {
      std::string_view& lines = result.lists.back().lines;
      lines = {lines.data(), static_cast<std::size_t>(rest.data() - lines.data())};
    }
    before = prefix;
    if (is_whole) result.text += '\n';
  }
  return result;
}

void replay(const NumberLists& lists, NodeBuilder& builder) {
  std::string_view rest = lists.lines;
  for (int line = lists.line; !rest.empty(); ++line) {
    std::string_view list = take_line(rest);
    list.remove_prefix(list.find('['));
    BuilderEvents events{builder, line};
    (void)take_list(list, deepest_list, events);
  }
}

}  // namespace vandplan::io
