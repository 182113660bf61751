// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How does JSON text become a document?

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "io/document.h"

namespace vandplan::io {
namespace {

/// Where the parser reads.
struct Cursor {
  const char* at;
  int line = 1;
};

/// Counts the lines as the parser goes through the text.
class LineCounter {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  LineCounter(const char* at, Cursor* cursor) : at_(at), cursor_(cursor) {}
  const char& operator*() const { return *at_; }
  LineCounter& operator++() {
    if (*at_ == '\n') ++cursor_->line;
    cursor_->at = ++at_;
    return *this;
  }
  bool operator==(const LineCounter& other) const { return at_ == other.at_; }
  bool operator!=(const LineCounter& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  Cursor* cursor_;
};

class Events : public nlohmann::json_sax<nlohmann::json> {
 public:
  Events(NodeBuilder& builder, const Cursor& cursor, std::string_view text)
      : builder_(builder), cursor_(cursor), text_(text), first_line_(cursor.line) {}

  bool null() override { return builder_.nothing(cursor_.line), true; }
  bool boolean(bool value) override { return scalar(value ? "true" : "false", cursor_.line); }
  bool number_integer(number_integer_t value) override {
    return scalar(std::to_string(value), line_of_number());
  }
  bool number_unsigned(number_unsigned_t value) override {
    return scalar(std::to_string(value), line_of_number());
  }
  bool number_float(number_float_t, const string_t& text) override {
    return scalar(text, line_of_number());
  }
  bool string(string_t& value) override {
    return builder_.scalar(std::move(value), true, cursor_.line), true;
  }
  bool binary(binary_t&) override { return false; }
  bool key(string_t& value) override { return string(value); }
  bool start_object(std::size_t) override {
    return builder_.begin(Node::Kind::map, cursor_.line), true;
  }
  bool end_object() override { return builder_.end(), true; }
  bool start_array(std::size_t) override {
    return builder_.begin(Node::Kind::list, cursor_.line), true;
  }
  bool end_array() override { return builder_.end(), true; }
  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception& error) override {
    // "[json.exception.parse_error.101] parse error at line 1, column 2: what; last read: '...'",
    // or
    // "[json.exception.out_of_range.406] what": ours is what.
    const std::string_view message = error.what();
    const bool has_place = message.find("parse error at line") != std::string_view::npos;
    const std::size_t begin = has_place ? message.find(": ") + 2 : message.find("] ") + 2;
    const std::string reason(message.substr(begin, message.find(';') - begin));
    const auto end = text_.begin() + static_cast<std::ptrdiff_t>(
                                         std::min(position == 0 ? 0 : position - 1, text_.size()));
    const auto line = first_line_ + static_cast<int>(std::count(text_.begin(), end, '\n'));
    builder_.fail(line, "is not JSON (" + reason + "), expected a result file");
  }

 private:
  bool scalar(std::string text, int line) {
    return builder_.scalar(std::move(text), false, line), true;
  }
  /// The parser sees the end of a number by reading one character more.
  [[nodiscard]] int line_of_number() const {
    return cursor_.line - (cursor_.at[-1] == '\n' ? 1 : 0);
  }

  NodeBuilder& builder_;
  const Cursor& cursor_;
  std::string_view text_;
  int first_line_;
};

}  // namespace

Document parse_json(std::string_view text, const std::string& where, int first_line) {
  NodeBuilder builder(where);
  Cursor cursor{text.data(), first_line};
  Events events(builder, cursor, text);
  (void)nlohmann::json::sax_parse(LineCounter(text.data(), &cursor),
                                  LineCounter(text.data() + text.size(), &cursor), &events);
  return {where, builder.finish()};
}

}  // namespace vandplan::io
