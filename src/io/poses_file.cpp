// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How is a list of starts and goals read? (docs/formats.md)

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "io/document.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "vandplan/problem.h"

namespace vandplan {
namespace {

using namespace io;

constexpr std::array<std::string_view, 6> columns = {"start_x", "start_y", "start_heading",
                                                     "goal_x",  "goal_y",  "goal_heading"};
constexpr const char* all_columns = "start_x,start_y,start_heading,goal_x,goal_y,goal_heading";

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Cells of a line between commas, without blanks and quotation marks. At most one more than there
/// are columns.
std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  while (cells.size() <= columns.size()) {
    const std::size_t comma = line.find(',');
    std::string_view cell = trimmed(line.substr(0, comma));
    if (cell.size() > 1 && cell.front() == '"' && cell.back() == '"') {
      cell = trimmed(cell.substr(1, cell.size() - 2));
    }
    cells.push_back(cell);
    if (comma == std::string_view::npos) break;
    line.remove_prefix(comma + 1);
  }
  return cells;
}

bool read_number(std::string_view text, double& value) {
  if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  return error == std::errc() && end == last && std::isfinite(value);
}

/// Whether a line is a header: as many words as columns, and no number. Throws InputError if known
/// columns are in another order.
bool is_header(const std::vector<std::string_view>& cells, const std::string& where) {
  double value = 0.0;
  if (cells.size() != columns.size()) return false;
  for (const std::string_view cell : cells) {
    if (read_number(cell, value)) return false;
  }
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto* const ours = std::find(columns.begin(), columns.end(), cells[i]);
    if (ours == columns.end() || ours == columns.begin() + i) continue;
    throw InputError(where,
                     fmt::format("has {} in column {}, expected {}", cells[i], i + 1, all_columns));
  }
  return true;
}

PosePair pair_from(const std::vector<std::string_view>& cells, const std::string& where) {
  if (cells.size() != columns.size()) {
    const std::string count = cells.size() > columns.size()
                                  ? fmt::format("more than {}", columns.size())
                                  : fmt::format("{}", cells.size());
    throw InputError(where, fmt::format("has {} value{}, expected {}", count,
                                        cells.size() == 1 ? "" : "s", all_columns));
  }
  std::array<double, 6> values{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (read_number(cells[i], values[i])) continue;
    throw InputError(where, fmt::format("{}: is \"{}\", expected a finite number", columns[i],
                                        cells[i].substr(0, 40)));
  }
  const PosePair pair{{values[0], values[1], values[2]}, {values[3], values[4], values[5]}};
  try {
    check_poses(pair.start, pair.goal);
  } catch (const InputError& error) {
    throw InputError(where, error.what());
  }
  return pair;
}

/// Adds a warning for the first heading that looks like degrees. Others need no second warning.
void warn_of_degrees(const PosePair& pair, const std::string& where,
                     std::vector<std::string>& warnings) {
  const std::string start = heading_doubt(pair.start.heading);
  const std::string goal = heading_doubt(pair.goal.heading);
  if (!start.empty()) {
    warnings.push_back(where + ": start_heading: " + start);
  } else if (!goal.empty()) {
    warnings.push_back(where + ": goal_heading: " + goal);
  }
}

}  // namespace

PosePairs read_pose_pairs(const std::string& file) {
  const std::string text = read_file(file, largest_text);
  const std::string name = file == "-" ? "standard input" : file;
  PosePairs read;
  int number = 0;
  bool may_be_header = true;
  std::string_view rest = text;
  if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);  // byte order mark
  while (!rest.empty()) {
    const std::size_t end = rest.find('\n');
    const std::string_view line = trimmed(rest.substr(0, end));
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    ++number;
    if (line.empty() || line.front() == '#') continue;
    const std::string where = fmt::format("{}:{}", name, number);
    const std::vector<std::string_view> cells = cells_of(line);
    if (!may_be_header || !is_header(cells, where)) {
      read.pairs.push_back(pair_from(cells, where));
      if (read.warnings.empty()) warn_of_degrees(read.pairs.back(), where, read.warnings);
    }
    may_be_header = false;
  }
  if (read.pairs.empty())
    throw InputError(name, "has no poses, expected a start and a goal on a line");
  return read;
}

}  // namespace vandplan
