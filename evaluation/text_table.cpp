// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/text_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace vandplan::evaluation {

std::string TextTable::markdown() const {
  std::vector<std::size_t> widths(rows_.front().size(), 3);
  for (const auto& row : rows_)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  std::string text;
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    for (std::size_t i = 0; i < rows_[r].size(); ++i)
      text += fmt::format(fmt::runtime(i == 0 ? "| {:<{}} " : "| {:>{}} "), rows_[r][i], widths[i]);
    text += "|\n";
    if (r > 0) continue;
    for (std::size_t i = 0; i < widths.size(); ++i)
      text += fmt::format("|{}{:-<{}}{}", i == 0 ? ":" : "-", "", widths[i], i == 0 ? "-" : ":");
    text += "|\n";
  }
  return text;
}

}  // namespace vandplan::evaluation
