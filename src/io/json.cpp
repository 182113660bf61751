// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How does JSON text become a document?

#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "io/document.h"

namespace vandplan::io {
namespace {

/// Position of the parser in the text.
class Cursor {
 public:
  Cursor(const NextPiece& next, int line) : next_(next), piece_(next()), line_(line) {}

  [[nodiscard]] bool is_at_end() const { return piece_.empty(); }
  [[nodiscard]] const char& character() const { return piece_.front(); }
  void advance() {
    last_ = piece_.front();
    if (last_ == '\n') ++line_;
    ++passed_;
    piece_.remove_prefix(1);
    if (piece_.empty()) piece_ = next_();
  }

  [[nodiscard]] int line() const { return line_; }
  /// Line of the text before the last character that was passed.
  [[nodiscard]] int line_before() const { return line_ - (last_ == '\n' ? 1 : 0); }
  [[nodiscard]] std::size_t passed() const { return passed_; }

 private:
  const NextPiece& next_;
  std::string_view piece_;  // Rest of the current piece.
  int line_;
  std::size_t passed_ = 0;  // Characters passed.
  char last_ = '\0';
};

/// Iterator over the characters of a cursor, for the parser.
class Characters {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  /// Without a cursor it is the end iterator.
  explicit Characters(Cursor* cursor = nullptr) : cursor_(cursor) {}
  const char& operator*() const { return cursor_->character(); }
  Characters& operator++() {
    cursor_->advance();
    return *this;
  }
  bool operator==(const Characters& other) const { return is_at_end() == other.is_at_end(); }
  bool operator!=(const Characters& other) const { return !(*this == other); }

 private:
  [[nodiscard]] bool is_at_end() const { return cursor_ == nullptr || cursor_->is_at_end(); }

  Cursor* cursor_;
};

class JsonEvents : public nlohmann::json_sax<nlohmann::json> {
 public:
  JsonEvents(NodeBuilder& builder, const Cursor& cursor, const std::string& expected)
      : builder_(builder), cursor_(cursor), expected_(expected) {}

  bool null() override { return builder_.nothing(cursor_.line()), true; }
  bool boolean(bool value) override { return scalar(value ? "true" : "false", cursor_.line()); }
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
    return builder_.scalar(std::move(value), true, cursor_.line()), true;
  }
  bool binary(binary_t&) override { return false; }
  bool key(string_t& value) override { return string(value); }
  bool start_object(std::size_t) override {
    return builder_.begin(Node::Kind::map, cursor_.line()), true;
  }
  bool end_object() override { return builder_.end(), true; }
  bool start_array(std::size_t) override {
    return builder_.begin(Node::Kind::list, cursor_.line()), true;
  }
  bool end_array() override { return builder_.end(), true; }
  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception& error) override {
    // The message is "[json.exception.parse_error.101] parse error at line 1, column 2: what; last
    // read: '...'", or "[json.exception.out_of_range.406] what". Only `what` is passed on.
    const std::string_view message = error.what();
    const bool has_place = message.find("parse error at line") != std::string_view::npos;
    const std::size_t begin = has_place ? message.find(": ") + 2 : message.find("] ") + 2;
    const std::string reason(message.substr(begin, message.find(';') - begin));
    // The parser has read one character too many, except at the end.
    const int line = position > cursor_.passed() ? cursor_.line() : cursor_.line_before();
    builder_.fail(line, "is not JSON (" + reason + "), expected " + expected_);
  }

 private:
  bool scalar(std::string text, int line) {
    return builder_.scalar(std::move(text), false, line), true;
  }
  /// Line of a number. The parser sees the end of a number by reading one more character.
  [[nodiscard]] int line_of_number() const { return cursor_.line_before(); }

  NodeBuilder& builder_;
  const Cursor& cursor_;
  const std::string& expected_;
};

}  // namespace

Document parse_json(const NextPiece& next, const std::string& where, int first_line,
                    const TakeElement& take, const std::string& expected) {
  NodeBuilder builder(where, take);
  Cursor cursor(next, first_line);
  JsonEvents events(builder, cursor, expected);
  (void)nlohmann::json::sax_parse(Characters(&cursor), Characters(), &events);
  return {where, builder.finish()};
}

Document parse_json(std::string_view text, const std::string& where, int first_line,
                    const TakeElement& take, const std::string& expected) {
  return parse_json([&text] { return std::exchange(text, {}); }, where, first_line, take, expected);
}

}  // namespace vandplan::io
