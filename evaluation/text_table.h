// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a table written as Markdown whose columns line up in a terminal?

#include <string>
#include <vector>

namespace vandplan::evaluation {

class TextTable {
 public:
  explicit TextTable(std::vector<std::string> head) : rows_{std::move(head)} {}
  /// Adds a row, which must have as many cells as the head.
  void add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
  /// Markdown of the table; the first column is left-aligned, the others are right-aligned.
  [[nodiscard]] std::string markdown() const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace vandplan::evaluation
