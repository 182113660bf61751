// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which lists of a result file are too long for a tree of nodes, and what do they contain?

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/document.h"
#include "vandplan/result_file.h"

namespace vandplan::io {

[[nodiscard]] Pose pose_from(const Document& file, const Node& node);

/// Hitch angle that a pose states for its one trailer [rad]; empty if it states none.
[[nodiscard]] std::optional<double> hitch_angle_from(const Document& file, const Node& node);

/// Long lists of one result: `path.poses`, `tree.poses` and `tree.parents`.
struct ResultLists {
  std::vector<StatedPose> poses;
  TreeSnapshot tree;
};

/// Takes the elements of the long lists while a parser reads them, from a single result or a row of
/// goals.
class ListTaker {
 public:
  /// `where`: name of the file.
  explicit ListTaker(std::string where) : where_(std::move(where)) {}

  /// Function for `TakeElement`. Throws InputError naming an element that is wrong or exceeds the
  /// limit.
  bool take(const std::vector<Node>& open, Node& element);
  /// Lists of result `goal` of a row, or of the single result with `alone`.
  [[nodiscard]] ResultLists& of(std::size_t goal) { return lists_[goal]; }

  static constexpr std::size_t alone = static_cast<std::size_t>(-1);

 private:
  std::string where_;
  std::map<std::size_t, ResultLists> lists_;
  std::size_t poses_ = 0;  // Number of poses in all results.
  std::size_t nodes_ = 0;
};

}  // namespace vandplan::io
