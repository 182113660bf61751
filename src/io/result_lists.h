// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which lists of a result file are too long for a tree of nodes, and what do they hold?

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

/// The angle between the vehicle and its one trailer that a pose states; none if it states none.
[[nodiscard]] std::optional<double> hitch_angle_from(const Document& file, const Node& node);

/// The long lists of one result: `path.poses`, `tree.poses` and `tree.parents`.
struct ResultLists {
  std::vector<StatedPose> poses;
  TreeSnapshot tree;
};

/// Takes the elements of the long lists as a parser comes across them, in results that stand alone
/// or in a row of goals.
class ListTaker {
 public:
  /// `where` is the name of the file.
  explicit ListTaker(std::string where) : where_(std::move(where)) {}

  /// For `TakeElement`. Throws InputError naming an element that is wrong or one too many.
  bool take(const std::vector<Node>& open, Node& element);
  /// The lists of the result number `goal` of a row, or of the one that stands alone.
  [[nodiscard]] ResultLists& of(std::size_t goal) { return lists_[goal]; }

  static constexpr std::size_t alone = static_cast<std::size_t>(-1);

 private:
  std::string where_;
  std::map<std::size_t, ResultLists> lists_;
  std::size_t poses_ = 0;  // of all results
  std::size_t nodes_ = 0;
};

}  // namespace vandplan::io
