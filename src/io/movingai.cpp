// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How is a problem of the MovingAI benchmarks (N. Sturtevant 2012) read?
//
// https://movingai.com/benchmarks/formats.html: a map of characters, and a list of problems on it.
// Each line is a problem; cells are counted from the upper left corner.

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string_view>

#include "base/trigonometry.h"
#include "io/document.h"
#include "io/image.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

using namespace io;

[[noreturn]] void fail(const std::string& file, std::size_t line, const std::string& problem) {
  throw InputError(fmt::format("{}:{}", file, line), problem);
}

/// Lines of a text, read one by one.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}

  /// Next line without its end; empty after the last line.
  std::optional<std::string_view> next() {
    if (rest_.empty()) return std::nullopt;
    const std::size_t end = rest_.find('\n');
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    ++number_;
    return line;
  }
  /// Number of the line that `next` returned last, from 1.
  [[nodiscard]] std::size_t number() const { return number_; }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

using Words = std::vector<std::string>;

/// Words of a line, at most ten, which is more than a valid line has; none if there is no line.
Words words_of(std::optional<std::string_view> line) {
  constexpr std::string_view blanks = " \t\v\f\r";
  Words words;
  std::string_view rest = line.value_or("");
  while (words.size() < 10) {
    rest.remove_prefix(std::min(rest.find_first_not_of(blanks), rest.size()));
    if (rest.empty()) break;
    const std::string_view word = rest.substr(0, rest.find_first_of(blanks));
    words.emplace_back(word);
    rest.remove_prefix(word.size());
  }
  return words;
}

std::int32_t whole_number(const std::string& word, std::int32_t least, std::int32_t most) {
  std::int32_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool is_good = error == std::errc() && end == word.data() + word.size();
  return is_good && value >= least && value <= most ? value : least - 1;
}

/// Number after the word `name` on the next line, as in "height 256".
std::int32_t size_from(Lines& lines, const char* name, const std::string& file) {
  const Words words = words_of(lines.next());
  const std::int32_t size =
      words.size() == 2 && words[0] == name ? whole_number(words[1], 1, 100000) : 0;
  if (size < 1) {
    fail(file, name == std::string_view("height") ? 2 : 3,
         fmt::format("is no size, expected {} and 1 to 100000", name));
  }
  return size;
}

OccupancyGrid read_movingai_map(const std::string& file, double resolution) {
  const std::string text = read_file(file, largest_text);
  Lines lines(text);
  if (words_of(lines.next()) != Words{"type", "octile"}) {
    fail(file, 1, "is no map that can be read, expected \"type octile\"");
  }
  OccupancyGrid grid{.resolution = resolution, .unknown_is_free = false};
  grid.rows = size_from(lines, "height", file);
  grid.columns = size_from(lines, "width", file);
  const auto columns = static_cast<std::size_t>(grid.columns);
  const auto rows = static_cast<std::size_t>(grid.rows);
  if (std::int64_t{grid.rows} * grid.columns > most_map_cells) {
    fail(file, 2, fmt::format("is too large, expected at most {} cells", most_map_cells));
  }
  if (lines.next() != "map") fail(file, 4, "is no \"map\", expected that word");
  std::vector<Cell> cells;
  for (std::size_t row = 0; row < rows; ++row) {
    const std::optional<std::string_view> line = lines.next();
    if (!line) {
      fail(file, lines.number(), fmt::format("is the last line, expected {} rows of cells", rows));
    }
    if (line->size() != columns) {
      fail(file, lines.number(), fmt::format("has {} cells, expected {}", line->size(), columns));
    }
    for (const char c : *line) {
      const bool is_free = c == '.' || c == 'G' || c == 'S';
      if (!is_free && c != '@' && c != 'O' && c != 'T' && c != 'W') {
        fail(file, lines.number(), fmt::format("has a cell \"{}\", expected one of .GS@OTW", c));
      }
      cells.push_back(is_free ? Cell::free : Cell::occupied);
    }
  }
  turn_over(cells, grid.columns);
  grid.cells = std::move(cells);
  return grid;
}

/// Start x, y and goal x, y of a problem, in cells from the upper left corner.
std::vector<std::int32_t> cells_of_problem(const MovingAiProblem& problem,
                                           const OccupancyGrid& grid) {
  const std::string& file = problem.problems;
  const auto number = static_cast<std::size_t>(problem.number);
  const std::string text = read_file(file, largest_text);
  Lines lines(text);
  const Words version = words_of(lines.next());
  if (version.empty() || version[0] != "version") {
    fail(file, 1, "is no list of problems, expected \"version 1\"");
  }
  Words words;
  while (lines.number() <= number) {
    const std::optional<std::string_view> line = lines.next();
    words = words_of(line);
    if (line && (lines.number() <= number || !words.empty())) continue;
    throw InputError(
        file, fmt::format("has {} problems, expected at least {}", lines.number() - 1, number));
  }
  if (words.size() != 9) {
    fail(
        file, number + 1,
        fmt::format("has {}{} columns, expected bucket, map, width, height, start x, y, goal x, y, "
                    "length",
                    words.size() < 10 ? "" : "at least ", words.size()));
  }
  const std::string map = std::filesystem::path(problem.map).filename().string();
  if (std::filesystem::path(words[1]).filename() != map) {
    fail(file, number + 1, fmt::format("is on the map {}, expected {}", words[1], map));
  }
  if (whole_number(words[2], 1, 100000) != grid.columns ||
      whole_number(words[3], 1, 100000) != grid.rows) {
    fail(file, number + 1,
         fmt::format("is for a map of {} x {} cells, expected {} x {}", words[2], words[3],
                     grid.columns, grid.rows));
  }
  std::vector<std::int32_t> places;
  for (std::size_t i = 4; i < 8; ++i) {
    const std::int32_t most = (i % 2 == 0 ? grid.columns : grid.rows) - 1;
    places.push_back(whole_number(words[i], 0, most));
    if (places.back() < 0) {
      fail(file, number + 1, fmt::format("names the cell {}, expected 0 to {}", words[i], most));
    }
  }
  return places;
}

}  // namespace

Scenario read_movingai(const MovingAiProblem& problem) {
  if (!(problem.resolution > 0) || !std::isfinite(problem.resolution)) {
    throw InputError("resolution",
                     fmt::format("is {}, expected more than 0 m", problem.resolution));
  }
  if (problem.number < 1) {
    throw InputError("number", fmt::format("is {}, expected 1 or more", problem.number));
  }
  Scenario scenario;
  scenario.map = read_movingai_map(problem.map, problem.resolution);
  const OccupancyGrid& grid = *scenario.map;
  const auto places = cells_of_problem(problem, grid);
  const auto middle = [&](std::int32_t column, std::int32_t row) {
    return Point{(column + 0.5) * grid.resolution, (grid.rows - row - 0.5) * grid.resolution};
  };
  const Point start = middle(places[0], places[1]);
  const Point goal = middle(places[2], places[3]);
  const double heading = base::atan_2(goal.y - start.y, goal.x - start.x);
  scenario.name =
      fmt::format("{}-{}", std::filesystem::path(problem.problems).stem().string(), problem.number);
  scenario.description = "MovingAI; the headings at both ends are those from start to goal";
  scenario.vehicle = vehicle_named(problem.vehicle);
  scenario.start = {start.x, start.y, heading};
  scenario.goal = {goal.x, goal.y, heading};
  scenario.bounds = {0, grid.columns * grid.resolution, 0, grid.rows * grid.resolution};
  check_scenario(scenario);
  return scenario;
}

}  // namespace vandplan
