// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How is a case of the Trajectory Planning Competition for Automated Parking 2022 read?
//
// Numbers separated by commas: start x, y, heading; goal x, y, heading; number of obstacles; number
// of corners of each obstacle; x, y of the corners. The file has no vehicle and no bounds.

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>

#include "io/document.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

using namespace io;

constexpr double margin = 20.0;  // Distance between the contents of the file and the bounds [m].

/// Values of a file, read one by one.
class Values {
 public:
  Values(const std::string& text, std::string file) : text_(text), file_(std::move(file)) {}

  double number(const std::string& name) {
    const std::string_view word = next(name);
    double value = 0.0;
    const char* const last = word.data() + word.size();
    const auto [end, error] = std::from_chars(word.data(), last, value);
    if (error != std::errc() || end != last || !std::isfinite(value)) {
      fail(name, word, "a finite number");
    }
    return value;
  }

  /// A whole number, at most the number of characters left in the file.
  std::size_t count(const std::string& name) {
    const double value = number(name);
    if (!(value >= 0 && value == std::floor(value) &&
          value <= static_cast<double>(rest().size()))) {
      fail(name, fmt::format("{}", value), "a whole number that the rest of the file has room for");
    }
    return static_cast<std::size_t>(value);
  }

  void expect_end() {
    if (rest().empty()) return;
    throw InputError(where(), fmt::format("goes on after value {}, expected its end", read_));
  }

 private:
  static bool separates(char c) {
    return c == ',' || c == ' ' || c == '\t' || c == '\r' || c == '\n';
  }

  [[nodiscard]] std::string where() const { return fmt::format("{}:{}", file_, line_); }

  /// Text from the next value on.
  std::string_view rest() {
    while (at_ < text_.size() && separates(text_[at_])) {
      if (text_[at_] == '\n') ++line_;
      ++at_;
    }
    return std::string_view(text_).substr(at_);
  }

  std::string_view next(const std::string& name) {
    const std::string_view left = rest();
    if (read_ == most_values) {
      throw InputError(where(), fmt::format("has more than {} values, expected no more", read_));
    }
    if (left.empty()) {
      throw InputError(where(), fmt::format("ends after value {}, expected {}", read_, name));
    }
    const auto end = std::find_if(left.begin(), left.end(), separates);
    const auto size = static_cast<std::size_t>(end - left.begin());
    at_ += size;
    ++read_;
    return left.substr(0, size);
  }

  [[noreturn]] void fail(const std::string& name, std::string_view word,
                         const std::string& expected) const {
    throw InputError(where(), fmt::format("value {} ({}) is \"{}\", expected {}", read_, name,
                                          word.substr(0, 40), expected));
  }

  const std::string& text_;
  std::string file_;
  std::size_t at_ = 0;
  int line_ = 1;
  std::size_t read_ = 0;  // Values read so far.
};

Pose pose_from(Values& values, const std::string& name) {
  const double x = values.number("x of the " + name);
  const double y = values.number("y of the " + name);
  return {x, y, values.number("heading of the " + name)};
}

std::vector<Polygon> obstacles_from(Values& values) {
  const std::size_t count = values.count("number of obstacles");
  std::vector<std::size_t> counts;
  for (std::size_t i = 0; i < count; ++i) {
    counts.push_back(values.count(fmt::format("number of corners of obstacle {}", i)));
  }
  std::vector<Polygon> obstacles;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const std::string name = fmt::format("corner of obstacle {}", i);
    Polygon& obstacle = obstacles.emplace_back();
    for (std::size_t k = 0; k < counts[i]; ++k) {
      const double x = values.number(name);
      obstacle.push_back({x, values.number(name)});
    }
  }
  return obstacles;
}

/// Box around everything in the scenario plus `margin`, rounded to millimetres.
Bounds bounds_around(const Scenario& scenario) {
  std::vector<Point> points = {{scenario.start.x, scenario.start.y},
                               {scenario.goal.x, scenario.goal.y}};
  for (const Polygon& obstacle : scenario.obstacles) {
    points.insert(points.end(), obstacle.begin(), obstacle.end());
  }
  const Bounds box = bounding_box(points);
  const auto rounded = [](double metres) { return std::round(metres * 1000) / 1000; };
  return {rounded(box.x_min - margin), rounded(box.x_max + margin), rounded(box.y_min - margin),
          rounded(box.y_max + margin)};
}

}  // namespace

Scenario read_tpcap(const std::string& file) {
  const std::string text = read_file(file, largest_text);
  const std::string name = file == "-" ? "standard input" : file;
  Values values(text, name);
  Scenario scenario;
  scenario.name = file == "-" ? "tpcap" : std::filesystem::path(file).stem().string();
  scenario.description = "TPCAP 2022";
  scenario.vehicle = vehicle_named("tpcap-car");
  scenario.start = pose_from(values, "start");
  scenario.goal = pose_from(values, "goal");
  scenario.obstacles = obstacles_from(values);
  values.expect_end();
  scenario.bounds = bounds_around(scenario);
  try {
    check_scenario(scenario);
  } catch (const InputError& error) {
    throw InputError(name + ":1", error.what());
  }
  return scenario;
}

}  // namespace vandplan
