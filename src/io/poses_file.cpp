// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How are lists of poses read, and of starts with goals? (docs/formats.md)

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>
#include <vector>

#include "io/document.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "vandplan/problem.h"

namespace vandplan {
namespace {

using namespace io;

using Columns = std::span<const std::string_view>;

constexpr std::array<std::string_view, 6> columns_of_pairs = {"start_x", "start_y", "start_heading",
                                                              "goal_x",  "goal_y",  "goal_heading"};
constexpr std::array<std::string_view, 3> columns_of_poses = {"x", "y", "heading"};

std::string name_in_errors(const std::string& file) {
  return file == "-" ? "standard input" : file;
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Cells of a line between commas, without blanks and quotation marks; at most one more than
/// `count`.
std::vector<std::string_view> cells_of(std::string_view line, std::size_t count) {
  std::vector<std::string_view> cells;
  while (cells.size() <= count) {
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
bool is_header(Columns columns, const std::vector<std::string_view>& cells,
               const std::string& where) {
  double value = 0.0;
  if (cells.size() != columns.size()) return false;
  for (const std::string_view cell : cells) {
    if (read_number(cell, value)) return false;
  }
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto ours = std::find(columns.begin(), columns.end(), cells[i]);
    if (ours == columns.end() || static_cast<std::size_t>(ours - columns.begin()) == i) continue;
    throw InputError(where, fmt::format("has {} in column {}, expected {}", cells[i], i + 1,
                                        fmt::join(columns, ",")));
  }
  return true;
}

std::vector<double> numbers_in(Columns columns, const std::vector<std::string_view>& cells,
                               const std::string& where) {
  if (cells.size() != columns.size()) {
    const std::string count = cells.size() > columns.size()
                                  ? fmt::format("more than {}", columns.size())
                                  : fmt::format("{}", cells.size());
    throw InputError(where, fmt::format("has {} value{}, expected {}", count,
                                        cells.size() == 1 ? "" : "s", fmt::join(columns, ",")));
  }
  std::vector<double> values(columns.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (read_number(cells[i], values[i])) continue;
    throw InputError(where, fmt::format("{}: is \"{}\", expected a finite number", columns[i],
                                        cells[i].substr(0, 40)));
  }
  return values;
}

/// Calls `take(numbers, line, where)` for each line of a file that holds numbers.
template <typename Take>
void read_rows(const std::string& file, Columns columns, Take take) {
  const std::string text = read_file(file, largest_text);
  const std::string name = name_in_errors(file);
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
    const std::vector<std::string_view> cells = cells_of(line, columns.size());
    if (!may_be_header || !is_header(columns, cells, where)) {
      take(numbers_in(columns, cells, where), number, where);
    }
    may_be_header = false;
  }
}

void check(const Pose& start, const Pose& goal, const std::string& where) {
  try {
    check_poses(start, goal);
  } catch (const InputError& error) {
    throw InputError(where, error.what());
  }
}

/// Adds a warning for a heading that looks like degrees, unless there is a warning.
void warn_of_degrees(const Pose& pose, const std::string& column, const std::string& where,
                     std::vector<std::string>& warnings) {
  const std::string doubt = heading_doubt(pose.heading);
  if (warnings.empty() && !doubt.empty()) {
    warnings.push_back(where + ": " + column + ": " + doubt);
  }
}

}  // namespace

PosePairs read_pose_pairs(const std::string& file) {
  PosePairs read;
  const auto take = [&read](const std::vector<double>& n, int line, const std::string& where) {
    const PosePair& pair =
        read.pairs.emplace_back(PosePair{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}});
    read.lines.push_back(line);
    check(pair.start, pair.goal, where);
    warn_of_degrees(pair.start, "start_heading", where, read.warnings);
    warn_of_degrees(pair.goal, "goal_heading", where, read.warnings);
  };
  read_rows(file, columns_of_pairs, take);
  if (read.pairs.empty()) {
    throw InputError(name_in_errors(file), "has no poses, expected a start and a goal on a line");
  }
  return read;
}

Poses read_poses(const std::string& file) {
  Poses read;
  const auto take = [&read](const std::vector<double>& n, int line, const std::string& where) {
    const Pose& pose = read.poses.emplace_back(Pose{n[0], n[1], n[2]});
    read.lines.push_back(line);
    check(pose, pose, where);
    warn_of_degrees(pose, "heading", where, read.warnings);
  };
  read_rows(file, columns_of_poses, take);
  if (read.poses.empty()) {
    throw InputError(name_in_errors(file), "has no poses, expected x,y,heading on a line");
  }
  return read;
}

}  // namespace vandplan
