// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a text hold, and on which line?
//
// YAML and JSON become the same tree of nodes. Whoever asks it for something that is not there gets
// an InputError "file:line: key.path: what is wrong, what was expected".

#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vandplan::io {

/// A value and the line it begins on.
struct Node {
  enum class Kind { nothing, scalar, list, map };
  struct Key {
    std::string text;
    int line = 0;

    bool operator==(const Key&) const = default;
  };

  Kind kind = Kind::nothing;
  bool is_quoted = false;  ///< a scalar that is a string whatever it looks like
  int line = 1;
  std::string text;         ///< of a scalar
  std::vector<Key> keys;    ///< of a map
  std::vector<Node> items;  ///< of a list, or the values of a map in the order of `keys`

  bool operator==(const Node&) const = default;
};

/// A text as a tree of nodes.
class Document {
 public:
  /// `where` is the name of the file, `path` that of the root: "path.poses[5]" if it is a part.
  Document(std::string where, Node root, std::string path = "")
      : where_(std::move(where)), root_(std::move(root)), path_(std::move(path)) {}

  [[nodiscard]] const Node& root() const { return root_; }

  /// Null if there is no such key. Throws if `node` is no map.
  [[nodiscard]] const Node* find(const Node& node, std::string_view key) const;
  /// Throws if there is no such key.
  [[nodiscard]] const Node& at(const Node& node, std::string_view key) const;
  /// Throws if the map has any other key.
  void allow_only(const Node& node, std::initializer_list<std::string_view> keys) const;

  /// The elements; throws if `node` is no list. `expected` says of what, "a list of polygons".
  [[nodiscard]] const std::vector<Node>& list(const Node& node, std::string_view expected) const;
  /// A finite number; throws if `node` is none. The next three throw likewise.
  [[nodiscard]] double number(const Node& node) const;
  [[nodiscard]] std::int64_t integer(const Node& node) const;
  [[nodiscard]] std::uint64_t count(const Node& node) const;
  [[nodiscard]] const std::string& text(const Node& node) const;

  /// Throws an InputError that names the node.
  [[noreturn]] void fail(const Node& node, const std::string& problem) const;
  /// Throws an InputError about the node of a path, "goals[3].obstacles[0]", or the nearest node
  /// above it.
  [[noreturn]] void fail(std::string_view path, const std::string& problem) const;

  /// "yard.yaml:5: goal.heading", which is how errors about a node begin.
  [[nodiscard]] std::string place_of(const Node& node) const;

 private:
  /// "vehicle.width: ", empty for the root.
  [[nodiscard]] std::string prefix_for(const Node& node) const;
  /// What stands there, for a number.
  [[nodiscard]] const std::string& scalar(const Node& node, const std::string& expected) const;

  std::string where_;
  Node root_;
  std::string path_;
};

/// The most values that a text may have, keys among them: what a tree of them takes is far more
/// than their text.
inline constexpr std::size_t most_values = 4'000'000;

/// Whether somebody keeps this element of a list, so that the tree needs not: `open` are the nodes
/// that it is in, the root first and the list last. Those nodes are not whole yet.
using TakeElement = std::function<bool(const std::vector<Node>& open, Node& element)>;

/// Puts a tree together from what a parser comes across. Throws InputError for more than
/// `most_values` that nobody takes.
class NodeBuilder {
 public:
  explicit NodeBuilder(std::string where, TakeElement take = {})
      : where_(std::move(where)), take_(std::move(take)) {}

  void begin(Node::Kind kind, int line);
  void end();
  /// A scalar, or the next key of a map.
  void scalar(std::string text, bool is_quoted, int line);
  /// Stands on the line of its key, if it has one.
  void nothing(int line);
  /// The root; nothing if there was none.
  [[nodiscard]] Node finish() { return std::move(root_); }
  [[noreturn]] void fail(int line, const std::string& problem) const;
  /// Throws InputError if so many values are too many.
  void expect_room(std::size_t values, int line) const;

 private:
  /// `before` is how many values there were before it.
  void add(Node node, std::size_t before);
  void count(int line);

  std::string where_;
  TakeElement take_;
  std::vector<Node> open_;          // the root first
  std::vector<std::size_t> began_;  // how many values there were before each of them
  std::size_t values_ = 0;
  Node root_;
};

/// The largest file of text that is read [bytes].
inline constexpr std::size_t largest_text = std::size_t{64} << 20;

[[nodiscard]] Document parse_yaml(const std::string& text, const std::string& where);
/// What `parse_yaml` gives, all of it by a parser of YAML, which takes many times as long for long
/// lists.
[[nodiscard]] Document parse_yaml_slowly(const std::string& text, const std::string& where);
/// `first_line` is the number of the text's first line in its file; `expected` is what the file was
/// to be.
[[nodiscard]] Document parse_json(std::string_view text, const std::string& where, int first_line,
                                  const TakeElement& take,
                                  const std::string& expected = "a result file");
/// Text that comes in pieces: each is valid until the next one is asked for, the last one is empty.
using NextPiece = std::function<std::string_view()>;

/// Reads text that may be longer than memory has room for, as long as somebody takes most of it.
[[nodiscard]] Document parse_json(const NextPiece& next, const std::string& where, int first_line,
                                  const TakeElement& take,
                                  const std::string& expected = "a result file");

}  // namespace vandplan::io
