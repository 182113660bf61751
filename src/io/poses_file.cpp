// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How is a list of starts and goals read? (docs/formats.md)

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>

#include "io/document.h"
#include "vandplan/input_error.h"
#include "vandplan/io.h"

namespace vandplan {
namespace {

constexpr std::array<const char*, 6> columns = {"start x", "start y", "start heading",
                                                "goal x",  "goal y",  "goal heading"};

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  while (true) {
    const std::size_t comma = line.find(',');
    cells.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

bool read_number(std::string_view text, double& value) {
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  return error == std::errc() && end == last && std::isfinite(value);
}

PosePair pair_from(std::string_view line, const std::string& where) {
  const std::vector<std::string_view> cells = cells_of(line);
  if (cells.size() != columns.size()) {
    throw InputError(where, fmt::format("has {} values, expected x, y, heading of the start and of "
                                        "the goal",
                                        cells.size()));
  }
  std::array<double, 6> values{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (read_number(cells[i], values[i])) continue;
    throw InputError(where, fmt::format("{}: is \"{}\", expected a finite number", columns[i],
                                        cells[i].substr(0, 40)));
  }
  return {{values[0], values[1], values[2]}, {values[3], values[4], values[5]}};
}

}  // namespace

std::vector<PosePair> read_pose_pairs(const std::string& file) {
  const std::string text = read_file(file, largest_text);
  const std::string name = file == "-" ? "standard input" : file;
  std::vector<PosePair> pairs;
  int number = 0;
  bool may_be_header = true;
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t end = rest.find('\n');
    const std::string_view line = trimmed(rest.substr(0, end));
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    ++number;
    if (line.empty() || line.front() == '#') continue;
    double first = 0.0;
    const bool is_header = may_be_header && !read_number(cells_of(line).front(), first) &&
                           cells_of(line).size() == columns.size();
    may_be_header = false;
    if (!is_header) pairs.push_back(pair_from(line, fmt::format("{}:{}", name, number)));
  }
  if (pairs.empty()) throw InputError(name, "has no poses, expected a start and a goal on a line");
  return pairs;
}

}  // namespace vandplan
