// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How does YAML text become a document?
//
// From the events of the parser instead of its own tree: they tell quoted scalars from plain ones,
// show aliases before anything multiplies, and have a line for everything.

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <sstream>

#include "io/document.h"
#include "vandplan/input_error.h"

namespace vandplan::io {
namespace {

/// Length of the UTF-8 character that a text begins with, 0 if it is none.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
  }
  // Overlong forms, surrogates, and what lies beyond Unicode.
  const bool is_wrong = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xED && byte(1) > 0x9F) ||
                        (first == 0xF0 && byte(1) < 0x90) || (first == 0xF4 && byte(1) > 0x8F);
  return is_wrong ? 0 : length;
}

/// Throws at what YAML forbids and the parser would take for an end of the file or worse.
void check_characters(std::string_view text, const NodeBuilder& builder) {
  int line = 1;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    const bool is_control = (c >= 0 && c < ' ' && c != '\n' && c != '\r' && c != '\t') || c == 127;
    const std::size_t length = is_control ? 0 : character_length(text.substr(i));
    if (length == 0) builder.fail(line, "is not a text file, expected YAML in UTF-8");
    if (c == '\n') ++line;
    i += length;
  }
}

class Events : public YAML::EventHandler {
 public:
  explicit Events(NodeBuilder& builder) : builder_(builder) {}

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t) override { builder_.nothing(line(mark)); }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    builder_.fail(line(mark), "uses an alias (*name), expected the value itself");
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                const std::string& value) override {
    check_tag(mark, tag);
    builder_.scalar(value, tag == "!", line(mark));
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

 private:
  static int line(const YAML::Mark& mark) { return mark.is_null() ? 1 : mark.line + 1; }

  /// "?" is a plain value and "!" a quoted one.
  void check_tag(const YAML::Mark& mark, const std::string& tag) const {
    if (tag.empty() || tag == "?" || tag == "!") return;
    builder_.fail(line(mark), "has a tag (!name), expected the value alone");
  }

  NodeBuilder& builder_;
};

}  // namespace

Document parse_yaml(const std::string& text, const std::string& where) {
  NodeBuilder builder(where);
  check_characters(text, builder);
  try {
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    Events events(builder);
    if (!parser.HandleNextDocument(events)) builder.fail(1, "is empty, expected keys and values");
    NodeBuilder rest(where);
    Events more(rest);
    if (parser.HandleNextDocument(more)) {
      rest.fail(rest.finish().line, "begins a second document, expected one");
    }
  } catch (const YAML::Exception& error) {
    const int line = error.mark.is_null() ? 1 : error.mark.line + 1;
    builder.fail(line, "is not YAML (" + error.msg + "), expected keys and values");
  }
  return {where, builder.finish()};
}

}  // namespace vandplan::io
