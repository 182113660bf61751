// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How are the primitives of SBPL read?
//
// Lines "key: values": the resolution and the numbers of headings and primitives. Then each
// primitive: its number, headings, end and poses, one a line. Prices and radii are ignored:
// lattices here plan by length, and headings and radii come from the poses.

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "io/document.h"
#include "io/primitives_reader.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"

namespace vandplan::io {
namespace {

constexpr std::int64_t most_primitives = 100'000;
constexpr std::int64_t most_headings = 1000;
constexpr std::int64_t most_poses = 10'000;

/// Non-empty lines of a file, read one by one.
class Lines {
 public:
  Lines(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}

  [[noreturn]] void fail(const std::string& problem) const { fail_at(line_, problem); }
  [[noreturn]] void fail_at(int line, const std::string& problem) const {
    throw InputError(fmt::format("{}:{}", name_, line), problem);
  }

  /// The `count` numbers after "key:". Ignorable keys before it are skipped.
  std::vector<double> values(std::string_view key, std::size_t count) {
    for (;;) {
      const std::string_view line = next(fmt::format("\"{}:\"", key));
      const std::size_t colon = line.find(':');
      if (colon == std::string_view::npos) fail(fmt::format("has no key, expected \"{}:\"", key));
      if (line.substr(0, colon) == key) return numbers(line.substr(colon + 1), count);
      if (!is_passed_over(line.substr(0, colon))) {
        fail(fmt::format("has another key, expected \"{}:\"", key));
      }
    }
  }

  /// The `count` numbers on a line of their own.
  std::vector<double> values(std::size_t count) { return numbers(next("a pose"), count); }

  std::int64_t whole(std::string_view key, std::int64_t least, std::int64_t most) {
    return whole(values(key, 1)[0], least, most);
  }
  std::int64_t whole(double value, std::int64_t least, std::int64_t most) const {
    if (!(value == std::floor(value) && value >= static_cast<double>(least) &&
          value <= static_cast<double>(most))) {
      fail(fmt::format("has {:g}, expected a whole number from {} to {}", value, least, most));
    }
    return static_cast<std::int64_t>(value);
  }

  [[nodiscard]] int line() const { return line_; }

 private:
  static bool is_passed_over(std::string_view key) {
    return key == "min_turning_radius_m" || key == "turning_radius" || key == "angle" ||
           key == "additionalactioncostmult";
  }

  std::string_view next(const std::string& expected) {
    while (!text_.empty()) {
      const std::size_t end = std::min(text_.find('\n'), text_.size());
      std::string_view line = text_.substr(0, end);
      text_.remove_prefix(std::min(end + 1, text_.size()));
      ++line_;
      const std::size_t first = line.find_first_not_of(" \t\r");
      if (first != std::string_view::npos) return line.substr(first);
    }
    fail("is the last line, expected " + expected);
  }

  std::vector<double> numbers(std::string_view text, std::size_t count) const {
    std::vector<double> all;
    while (true) {
      const std::size_t first = std::min(text.find_first_not_of(" \t\r"), text.size());
      text.remove_prefix(first);
      if (text.empty()) break;
      double value = 0.0;
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
      if (error != std::errc() || !std::isfinite(value) || std::abs(value) > 1e9) {
        fail("holds something else than numbers");
      }
      all.push_back(value);
      text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    }
    if (all.size() != count) {
      fail(fmt::format("has {} numbers, expected {}", all.size(), count));
    }
    return all;
  }

  std::string_view text_;
  std::string name_;
  int line_ = 0;
};

SampledPrimitive primitive_from(Lines& lines, double step, std::int64_t headings) {
  SampledPrimitive one;
  (void)lines.values("primID", 1);
  one.line = lines.line();
  one.from = static_cast<std::int32_t>(lines.whole("startangle_c", 0, headings - 1));
  const std::vector<double> end = lines.values("endpose_c", 3);
  const std::int64_t to = lines.whole(end[2], -most_headings, most_headings);
  one.to = static_cast<std::int32_t>((to % headings + headings) % headings);
  const std::int64_t count = lines.whole("intermediateposes", 2, most_poses);
  for (std::int64_t i = 0; i < count; ++i) {
    const std::vector<double> pose = lines.values(3);
    one.poses.push_back({pose[0], pose[1], pose[2]});
  }
  const Pose& last = one.poses.back();
  if (std::abs(last.x / step - end[0]) > 0.5 || std::abs(last.y / step - end[1]) > 0.5) {
    lines.fail(fmt::format("ends at {:g}, {:g} m, expected endpose_c, {:g}, {:g} m", last.x, last.y,
                           end[0] * step, end[1] * step));
  }
  return one;
}

}  // namespace

std::shared_ptr<const search::Primitives> read_sbpl_primitives(const std::string& name) {
  const std::string text = read_file(name, largest_text);
  Lines lines(text, name);
  SampledPrimitives sampled;
  sampled.step = lines.values("resolution_m", 1)[0];
  if (!(sampled.step > 0.0)) lines.fail("has no resolution above 0 m");
  const std::int64_t headings = lines.whole("numberofangles", 1, most_headings);
  const std::int64_t count = lines.whole("totalnumberofprimitives", 1, most_primitives);
  std::vector<std::optional<double>> known(static_cast<std::size_t>(headings));
  const auto learn = [&](std::int32_t index, double angle, int line) {
    const std::optional<double> exact_angle =
        search::exact_heading(angle, static_cast<int>(headings));
    std::optional<double>& heading = known[static_cast<std::size_t>(index)];
    if (!exact_angle) {
      lines.fail_at(line,
                    fmt::format("has a heading of {:g} rad, expected a part of the turn or the "
                                "direction of a grid point",
                                angle));
    }
    if (!heading) heading = exact_angle;
    if (std::abs(wrap_angle(*heading - *exact_angle)) > 1e-9) {
      lines.fail_at(line, fmt::format("has heading {} at {:g} rad, others have it at {:g} rad",
                                      index, angle, *heading));
    }
  };
  for (std::int64_t i = 0; i < count; ++i) {
    SampledPrimitive one = primitive_from(lines, sampled.step, headings);
    learn(one.from, one.poses.front().heading, one.line);
    learn(one.to, one.poses.back().heading, one.line);
    sampled.all.push_back(std::move(one));
  }
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (!known[i]) lines.fail(fmt::format("is the last one, and no primitive has heading {}", i));
    sampled.headings.push_back(*known[i]);
  }
  return exact(sampled,
               [&](int line, const std::string& problem) { lines.fail_at(line, problem); });
}

}  // namespace vandplan::io
