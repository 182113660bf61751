// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which values does a text contain, and on which lines?
//
// YAML and JSON become the same tree of nodes. A query for a missing or wrong value throws an
// InputError "file:line: key.path: what is wrong, what was expected".

#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vandplan::io {

/// A value and the line on which it begins.
struct Node {
  enum class Kind { nothing, scalar, list, map };
  struct Key {
    std::string text;
    int line = 0;

    bool operator==(const Key&) const = default;
  };

  Kind kind = Kind::nothing;
  /// Whether a scalar is in quotes, and so is a string whatever it looks like.
  bool is_quoted = false;
  int line = 1;
  std::string text;         ///< Text of a scalar.
  std::vector<Key> keys;    ///< Keys of a map.
  std::vector<Node> items;  ///< Elements of a list, or values of a map in the order of `keys`.

  bool operator==(const Node&) const = default;
};

/// Tree of nodes of a text.
class Document {
 public:
  /// `where`: name of the file. `path`: path of the root, "path.poses[5]" if it is a part of a
  /// file.
  Document(std::string where, Node root, std::string path = "")
      : where_(std::move(where)), root_(std::move(root)), path_(std::move(path)) {}

  [[nodiscard]] const Node& root() const { return root_; }

  /// Value of a key; null if there is no such key. Throws if `node` is no map.
  [[nodiscard]] const Node* find(const Node& node, std::string_view key) const;
  /// Value of a key. Throws if there is no such key.
  [[nodiscard]] const Node& at(const Node& node, std::string_view key) const;
  /// Throws if the map has any other key.
  void allow_only(const Node& node, std::initializer_list<std::string_view> keys) const;

  /// Elements of a list; throws if `node` is no list. `expected` describes the list, "a list of
  /// polygons".
  [[nodiscard]] const std::vector<Node>& list(const Node& node, std::string_view expected) const;
  /// A finite number; throws if `node` is none. `integer`, `count`, `text` and `truth`, which reads
  /// true or false, throw in the same way.
  [[nodiscard]] double number(const Node& node) const;
  [[nodiscard]] std::int64_t integer(const Node& node) const;
  [[nodiscard]] std::uint64_t count(const Node& node) const;
  [[nodiscard]] const std::string& text(const Node& node) const;
  [[nodiscard]] bool truth(const Node& node) const;

  /// Throws an InputError that names the node.
  [[noreturn]] void fail(const Node& node, const std::string& problem) const;
  /// Throws an InputError about the node at a path, "goals[3].obstacles[0]". If that node does not
  /// exist, about the nearest one above it.
  [[noreturn]] void fail(std::string_view path, const std::string& problem) const;

  /// Begin of errors about a node: "yard.yaml:5: goal.heading".
  [[nodiscard]] std::string place_of(const Node& node) const;

 private:
  /// Path of a node with a colon, "vehicle.width: "; empty for the root.
  [[nodiscard]] std::string prefix_for(const Node& node) const;
  /// Text of a node that should be a number.
  [[nodiscard]] const std::string& scalar(const Node& node, const std::string& expected) const;

  std::string where_;
  Node root_;
  std::string path_;
};

/// Largest number of values in a text, keys included. The tree takes far more memory than the text.
inline constexpr std::size_t most_values = 4'000'000;

/// Takes an element of a list out of the tree; true if it did. `open`: the unfinished nodes around
/// the element, the root first and the list last.
using TakeElement = std::function<bool(const std::vector<Node>& open, Node& element)>;

/// Builds a tree of nodes from the events of a parser. Throws InputError if more than `most_values`
/// values stay in the tree.
class NodeBuilder {
 public:
  explicit NodeBuilder(std::string where, TakeElement take = {})
      : where_(std::move(where)), take_(std::move(take)) {}

  void begin(Node::Kind kind, int line);
  void end();
  /// Adds a scalar, or the next key of a map.
  void scalar(std::string text, bool is_quoted, int line);
  /// Adds an empty value, on the line of its key if it has one.
  void nothing(int line);
  /// The finished root; an empty node if nothing was added.
  [[nodiscard]] Node finish() { return std::move(root_); }
  [[noreturn]] void fail(int line, const std::string& problem) const;
  /// Throws InputError if so many values are too many.
  void expect_room(std::size_t values, int line) const;

 private:
  /// `before`: number of values before the node.
  void add(Node node, std::size_t before);
  void count(int line);

  std::string where_;
  TakeElement take_;
  std::vector<Node> open_;          // Unfinished nodes, the root first.
  std::vector<std::size_t> began_;  // Number of values before each of them.
  std::size_t values_ = 0;
  Node root_;
};

/// Largest text file that is read [bytes].
inline constexpr std::size_t largest_text = std::size_t{64} << 20;

/// Text as a double-quoted YAML scalar.
[[nodiscard]] std::string yaml_scalar(const std::string& text);

[[nodiscard]] Document parse_yaml(const std::string& text, const std::string& where);
/// Result of `parse_yaml`, read by the YAML parser alone. It is many times slower for long lists.
[[nodiscard]] Document parse_yaml_slowly(const std::string& text, const std::string& where);
/// `first_line`: number of the text's first line in its file. `expected`: what the file should be,
/// for errors.
[[nodiscard]] Document parse_json(std::string_view text, const std::string& where, int first_line,
                                  const TakeElement& take,
                                  const std::string& expected = "a result file");
/// Gives the next piece of a text. A piece is valid until the next call; an empty piece ends the
/// text.
using NextPiece = std::function<std::string_view()>;

/// Parses a text that may be larger than memory, provided that `take` takes most of its elements.
[[nodiscard]] Document parse_json(const NextPiece& next, const std::string& where, int first_line,
                                  const TakeElement& take,
                                  const std::string& expected = "a result file");

}  // namespace vandplan::io
