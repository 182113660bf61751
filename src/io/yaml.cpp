// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How does YAML text become a document?
//
// Built from the parser's events, not from its tree. The events tell quoted scalars from plain
// ones, show aliases before anything is copied, and have a line for everything.

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "base/escape.h"
#include "io/document.h"
#include "io/number_lists.h"
#include "vandplan/input_error.h"

namespace vandplan::io {
namespace {

/// Throws InputError for characters that YAML forbids, which the parser could take for the end of
/// the file. Also throws for too many values, since the parser may store a whole line before its
/// first event.
void check_characters(std::string_view text, const NodeBuilder& builder) {
  int line = 1;
  std::size_t values = 0;  // Lower bound on the values in bracketed lists and maps.
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    const auto byte = static_cast<unsigned char>(c);
    const bool is_control = (byte < ' ' && c != '\n' && c != '\r' && c != '\t') || c == 127;
    const std::size_t length = is_control ? 0 : base::character_length(text.substr(i));
    if (length == 0) builder.fail(line, "is not a text file, expected YAML in UTF-8");
    if (c == '\n') ++line;
    if (c == ',' || c == '[' || c == '{') builder.expect_room(++values, line);
    i += length;
  }
}

/// Thrown if the mark of number lists is not a value of its own.
class MisplacedMark : public std::runtime_error {
 public:
  MisplacedMark() : std::runtime_error("lists of numbers within a scalar") {}
};

class YamlEvents : public YAML::EventHandler {
 public:
  YamlEvents(NodeBuilder& builder, const std::vector<NumberLists>& lists)
      : builder_(builder), lists_(lists) {}

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t) override { builder_.nothing(line(mark)); }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    builder_.fail(line(mark), "uses an alias (*name), expected the value itself");
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                const std::string& value) override {
    check_tag(mark, tag);
    if (!lists_.empty() && value.find(mark_of_lists) != std::string::npos) {
      replay_lists(value, tag == "!", line(mark));
    } else {
      builder_.scalar(value, tag == "!", line(mark));
    }
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {
    check_tag(mark, tag);
    builder_.begin(Node::Kind::list, line(mark));
  }
  void OnSequenceEnd() override { builder_.end(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {
    check_tag(mark, tag);
    builder_.begin(Node::Kind::map, line(mark));
  }
  void OnMapEnd() override { builder_.end(); }

  [[nodiscard]] bool all_lists_came() const { return replayed_ == lists_.size(); }

 private:
  static int line(const YAML::Mark& mark) { return mark.is_null() ? 1 : mark.line + 1; }

  /// Throws for tags. "?" marks a plain value and "!" a quoted one.
  void check_tag(const YAML::Mark& mark, const std::string& tag) const {
    if (tag.empty() || tag == "?" || tag == "!") return;
    builder_.fail(line(mark), "has a tag (!name), expected the value alone");
  }

  /// Passes on the lists that a mark replaces.
  void replay_lists(const std::string& value, bool is_quoted, int line) {
    std::size_t number = 0;
    (void)std::from_chars(value.data() + 1, value.data() + value.size(), number);
    const bool is_mark = is_quoted && number < lists_.size() && value == mark_of(number);
    if (!is_mark || lists_[number].line != line) throw MisplacedMark();
    replay(lists_[number], builder_);
    ++replayed_;
  }

  NodeBuilder& builder_;
  const std::vector<NumberLists>& lists_;
  std::size_t replayed_ = 0;
};

/// First line up to `last` that has a tab in its indentation; 0 if there is none.
int line_with_tab(std::string_view text, int last) {
  for (int line = 1; line <= last && !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view indent = text.substr(0, text.find_first_not_of(" \t"));
    if (indent.substr(0, end).find('\t') != std::string_view::npos) return line;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return 0;
}

/// `lists`: the lists that marks in the text stand for.
Document parse(const std::string& text, const std::vector<NumberLists>& lists,
               const std::string& where) {
  NodeBuilder builder(where);
  try {
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    YamlEvents events(builder, lists);
    if (!parser.HandleNextDocument(events)) builder.fail(1, "is empty, expected keys and values");
    NodeBuilder rest(where);
    YamlEvents more(rest, lists);
    if (parser.HandleNextDocument(more)) {
      rest.fail(rest.finish().line, "begins a second document, expected one");
    }
    if (!events.all_lists_came()) throw MisplacedMark();
  } catch (const YAML::Exception& error) {
    const int line = error.mark.is_null() ? 1 : error.mark.line + 1;
    if (const int tab = line_with_tab(text, line + 1); tab > 0) {
      builder.fail(tab, "begins with a tab, expected spaces");
    }
    builder.fail(line, "is not YAML (" + error.msg + "), expected keys and values");
  }
  return {where, builder.finish()};
}

/// Document of a text, read with its number lists replaced by marks. Empty if that fails for any
/// reason.
std::optional<Document> parse_shortened(const std::string& text, const std::string& where) {
  try {
    const ShortenedText shortened = without_number_lists(text);
    return parse(shortened.text, shortened.lists, where);
  } catch (const MisplacedMark&) {
    return std::nullopt;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace

Document parse_yaml(const std::string& text, const std::string& where) {
  check_characters(text, NodeBuilder(where));
  if (std::optional<Document> document = parse_shortened(text, where)) return *std::move(document);
  return parse(text, {}, where);
}

Document parse_yaml_slowly(const std::string& text, const std::string& where) {
  check_characters(text, NodeBuilder(where));
  return parse(text, {}, where);
}

}  // namespace vandplan::io
