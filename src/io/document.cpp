// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "io/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "base/nearest_word.h"
#include "vandplan/input_error.h"

namespace vandplan::io {
namespace {

constexpr std::size_t deepest = 64;  // Levels of nested lists and maps.

std::string quoted(std::string_view text) {
  constexpr std::size_t longest = 40;
  if (text.size() <= longest) return '"' + std::string(text) + '"';
  std::size_t cut = longest;
  while (cut > 0 && (text[cut] & 0xC0) == 0x80) --cut;  // A UTF-8 character must not be cut.
  return '"' + std::string(text.substr(0, cut)) + "...\"";
}

/// Description of a node, to end "expected a number, not ...".
std::string description_of(const Node& node) {
  switch (node.kind) {
    case Node::Kind::nothing:
      return "empty";
    case Node::Kind::list:
      return "a list";
    case Node::Kind::map:
      return "a map of keys";
    case Node::Kind::scalar:
      break;
  }
  return quoted(node.text);
}

bool is_digits(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// Hint for a number like "0,5": ", with a point instead of the comma"; otherwise empty.
std::string comma_hint(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos || !is_digits(text.substr(comma + 1))) return "";
  return ", with a point instead of the comma";
}

std::string wrong_kind(const Node& node, std::string_view expected) {
  return "is " + description_of(node) + ", expected " + std::string(expected);
}

/// Path from one node down to another; empty if it is not below.
std::optional<std::string> path_between(const Node& from, const Node* to) {
  if (&from == to) return "";
  for (std::size_t i = 0; i < from.items.size(); ++i) {
    const auto rest = path_between(from.items[i], to);
    if (!rest) continue;
    const std::string step =
        from.kind == Node::Kind::map ? "." + from.keys[i].text : "[" + std::to_string(i) + "]";
    return step + *rest;
  }
  return {};
}

/// Child of `node` that the path begins with, or null. Removes its step from the path.
const Node* step_into(const Node& node, std::string_view& path) {
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    const std::string step =
        node.kind == Node::Kind::map ? node.keys[i].text : "[" + std::to_string(i) + "]";
    if (!path.starts_with(step)) continue;
    std::string_view rest = path.substr(step.size());
    if (!rest.empty() && rest.front() != '.' && rest.front() != '[') continue;
    if (rest.starts_with('.')) rest.remove_prefix(1);
    path = rest;
    return &node.items[i];
  }
  return nullptr;
}

/// Reads the whole text as a number, in any locale. Returns the error, if any.
template <typename Value>
std::errc parse(std::string_view text, Value& value) {
  if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  return end == last ? error : std::errc::invalid_argument;
}

/// Whether a text is one of YAML's words for infinity or not-a-number.
bool is_infinite_word(std::string_view text) {
  if (text.starts_with('+') || text.starts_with('-')) text.remove_prefix(1);
  for (const std::string_view word : {".inf", ".Inf", ".INF", ".nan", ".NaN", ".NAN"}) {
    if (text == word) return true;
  }
  return false;
}

std::string in_file(const std::string& where, int line) {
  return where + ":" + std::to_string(line);
}

}  // namespace

std::string Document::prefix_for(const Node& node) const {
  std::string path = path_ + path_between(root_, &node).value_or("");
  if (path.starts_with('.')) path.erase(0, 1);
  return path.empty() ? "" : path + ": ";
}

std::string Document::place_of(const Node& node) const {
  std::string place = in_file(where_, node.line) + ": " + prefix_for(node);
  return place.substr(0, place.size() - 2);
}

void Document::fail(const Node& node, const std::string& problem) const {
  throw InputError(in_file(where_, node.line), prefix_for(node) + problem);
}

void Document::fail(std::string_view path, const std::string& problem) const {
  const Node* node = &root_;
  std::string_view rest = path;
  while (!rest.empty()) {
    const Node* const next = step_into(*node, rest);
    if (next == nullptr) break;
    node = next;
  }
  throw InputError(in_file(where_, node->line), std::string(path) + ": " + problem);
}

const Node* Document::find(const Node& node, std::string_view key) const {
  if (node.kind != Node::Kind::map) fail(node, wrong_kind(node, "a map of keys"));
  for (std::size_t i = 0; i < node.keys.size(); ++i) {
    if (node.keys[i].text == key) return &node.items[i];
  }
  return nullptr;
}

const Node& Document::at(const Node& node, std::string_view key) const {
  const Node* const found = find(node, key);
  if (found == nullptr) fail(node, "key \"" + std::string(key) + "\" is missing, expected it");
  return *found;
}

void Document::allow_only(const Node& node, std::initializer_list<std::string_view> keys) const {
  (void)find(node, "");
  for (std::size_t i = 0; i < node.keys.size(); ++i) {
    const std::string& key = node.keys[i].text;
    if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
    if (is_digits(key) && node.items[i].kind == Node::Kind::nothing) {
      throw InputError(in_file(where_, node.keys[i].line),
                       prefix_for(node) + "has the digits " + quoted(key) +
                           " behind a comma, expected a number with a point");
    }
    throw InputError(
        in_file(where_, node.keys[i].line),
        prefix_for(node) + "unknown key " + quoted(key) + ", " + base::expected_one_of(key, keys));
  }
}

const std::vector<Node>& Document::list(const Node& node, std::string_view expected) const {
  if (node.kind != Node::Kind::list) fail(node, wrong_kind(node, expected));
  return node.items;
}

double Document::number(const Node& node) const {
  double value = 0.0;
  const std::string& text = scalar(node, "a number");
  const std::errc error = parse(text, value);
  if (error == std::errc() && std::isfinite(value)) return value;
  if (is_infinite_word(text) || error == std::errc()) {
    fail(node, wrong_kind(node, "a finite number"));
  }
  if (error == std::errc::result_out_of_range) {
    fail(node, wrong_kind(node, "a number that fits a double"));
  }
  fail(node, wrong_kind(node, "a number" + comma_hint(text)));
}

std::int64_t Document::integer(const Node& node) const {
  std::int64_t value = 0;
  if (parse(scalar(node, "a whole number"), value) != std::errc()) {
    fail(node, wrong_kind(node, "a whole number"));
  }
  return value;
}

std::uint64_t Document::count(const Node& node) const {
  std::uint64_t value = 0;
  const std::string expected = "a whole number, 0 or more";
  if (parse(scalar(node, expected), value) != std::errc()) fail(node, wrong_kind(node, expected));
  return value;
}

const std::string& Document::scalar(const Node& node, const std::string& expected) const {
  if (node.kind != Node::Kind::scalar) fail(node, wrong_kind(node, expected));
  if (node.is_quoted) fail(node, wrong_kind(node, expected + " without quotes"));
  return node.text;
}

const std::string& Document::text(const Node& node) const {
  if (node.kind != Node::Kind::scalar) fail(node, wrong_kind(node, "a text"));
  return node.text;
}

bool Document::truth(const Node& node) const {
  const std::string& word = text(node);
  if (word != "true" && word != "false") {
    fail(node, "is \"" + word.substr(0, 40) + "\", expected true or false");
  }
  return word == "true";
}

void NodeBuilder::fail(int line, const std::string& problem) const {
  throw InputError(in_file(where_, line), problem);
}

void NodeBuilder::begin(Node::Kind kind, int line) {
  if (open_.size() == deepest) {
    fail(line, "lists and maps are nested too deep, expected at most " + std::to_string(deepest) +
                   " levels");
  }
  Node node;
  node.kind = kind;
  node.line = line;
  began_.push_back(values_);
  count(line);
  open_.push_back(std::move(node));
}

void NodeBuilder::end() {
  Node node = std::move(open_.back());
  open_.pop_back();
  std::vector<const Node::Key*> keys;
  for (const Node::Key& key : node.keys) keys.push_back(&key);
  std::stable_sort(keys.begin(), keys.end(),
                   [](const auto* a, const auto* b) { return a->text < b->text; });
  const auto twin = std::adjacent_find(
      keys.begin(), keys.end(), [](const auto* a, const auto* b) { return a->text == b->text; });
  if (twin != keys.end()) {
    fail((*(twin + 1))->line, "key " + quoted((*twin)->text) +
                                  " is given again, expected it once (" + "first on line " +
                                  std::to_string((*twin)->line) + ")");
  }
  const std::size_t before = began_.back();
  began_.pop_back();
  add(std::move(node), before);
}

void NodeBuilder::count(int line) { expect_room(++values_, line); }

void NodeBuilder::expect_room(std::size_t values, int line) const {
  if (values <= most_values) return;
  fail(line, "has more than " + std::to_string(most_values) + " values, expected no more");
}

void NodeBuilder::scalar(std::string text, bool is_quoted, int line) {
  count(line);
  Node node;
  node.kind = Node::Kind::scalar;
  node.is_quoted = is_quoted;
  node.line = line;
  node.text = std::move(text);
  add(std::move(node), values_ - 1);
}

void NodeBuilder::nothing(int line) {
  count(line);
  const bool has_key = !open_.empty() && open_.back().keys.size() > open_.back().items.size();
  Node node;
  node.line = has_key ? open_.back().keys.back().line : line;
  add(std::move(node), values_ - 1);
}

void NodeBuilder::add(Node node, std::size_t before) {
  if (open_.empty()) {
    root_ = std::move(node);
    return;
  }
  Node& parent = open_.back();
  if (parent.kind == Node::Kind::list && take_ && take_(open_, node)) {
    values_ = before;
    return;
  }
  if (parent.kind != Node::Kind::map || parent.keys.size() > parent.items.size()) {
    parent.items.push_back(std::move(node));
  } else if (node.kind == Node::Kind::scalar) {
    parent.keys.push_back({std::move(node.text), node.line});
  } else {
    fail(node.line, "a key is " + description_of(node) + ", expected a word");
  }
}

std::string yaml_scalar(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (static_cast<unsigned char>(c) < ' ' || c == 127) {
      result += fmt::format("\\x{:02x}", static_cast<int>(c));
    } else {
      result += c;
    }
  }
  return result + '"';
}

}  // namespace vandplan::io
