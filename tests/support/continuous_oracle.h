// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How long is the shortest path of turns with clothoids, and lines?
//
// Slow and obvious: every word in every symmetry, its lengths tried on a grid and refined where the
// word comes near the goal. It shares nothing with the steering but `advance`.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "vandplan/path.h"
#include "vandplan/steering.h"

namespace vandplan {

class ContinuousOracle {
 public:
  /// At turning radius 1; `ramp` is the way from straight to full lock.
  ContinuousOracle(double ramp, Continuity continuity) : ramp_(ramp), continuity_(continuity) {
    for (const char* letters : {"L+S+L+", "L+S+R+", "L+R-L+", "R-L+R+", "L-R-L+R+", "R-L+R+L-",
                                "R-L+S+R+", "R-L+S+L+", "R-L+S+R+L-", "L+R+L+"}) {
      for (const std::string& sides : {std::string(letters), swapped(letters, 'L', 'R')}) {
        for (const std::string& gears : {sides, swapped(sides, '+', '-')}) {
          words_.insert(gears);
          words_.insert(reversed(gears));
        }
      }
    }
  }

  /// Length of the least word from the origin to the goal; infinity if the grid misses all.
  [[nodiscard]] double length(const Pose& goal) const {
    double least = std::numeric_limits<double>::infinity();
    for (const std::string& letters : words_) {
      const Word word = parsed(letters);
      least = std::min(least, has_line(word) ? lined(word, goal) : turning(word, goal));
    }
    return least;
  }

 private:
  static constexpr double pi = std::numbers::pi;
  static constexpr double none = std::numeric_limits<double>::infinity();

  struct Step {
    double side;  // 1 left, 0 straight, -1 right
    double gear;
    bool rises, falls;  // the curvature, at most so fast; else it jumps where the vehicle stands
  };
  using Word = std::vector<Step>;

  static std::string swapped(std::string letters, char a, char b) {
    for (char& c : letters) c = c == a ? b : c == b ? a : c;
    return letters;
  }
  static std::string reversed(const std::string& letters) {
    std::string result;
    for (std::size_t i = letters.size(); i > 0; i -= 2) result += letters.substr(i - 2, 2);
    return result;
  }

  [[nodiscard]] Word parsed(const std::string& letters) const {
    Word word;
    const bool jumps = continuity_ == Continuity::between_stops;
    for (std::size_t i = 0; i < letters.size(); i += 2) {
      const bool begins = i == 0 || letters[i - 1] != letters[i + 1];
      const bool ends = i + 2 == letters.size() || letters[i + 3] != letters[i + 1];
      word.push_back({letters[i] == 'L'   ? 1.0
                      : letters[i] == 'R' ? -1.0
                                          : 0.0,
                      letters[i + 1] == '+' ? 1.0 : -1.0, !(jumps && begins), !(jumps && ends)});
    }
    return word;
  }
  static bool has_line(const Word& word) {
    return std::any_of(word.begin(), word.end(), [](const Step& s) { return s.side == 0; });
  }

  /// The length of a turn by an angle >= 0.
  [[nodiscard]] double length_of(const Step& step, double angle) const {
    const double ramps = (step.rises ? 1 : 0) + (step.falls ? 1 : 0);
    // Clothoids alone turn by half of their length times the curvature between them.
    if (angle < ramps * ramp_ / 2) return std::sqrt(2 * ramps * ramp_ * angle);
    return angle + ramps * ramp_ / 2;
  }

  /// The angle of a turn of some length, without its sign.
  [[nodiscard]] double angle_of(const Step& step, double length) const {
    const double ramps = (step.rises ? 1 : 0) + (step.falls ? 1 : 0);
    if (length < ramps * ramp_) return length * length / (2 * ramps * ramp_);
    return length - ramps * ramp_ / 2;
  }

  [[nodiscard]] Pose driven(Pose pose, const Step& step, double length) const {
    if (step.side == 0) return advance(pose, {0, step.gear * length});
    const double ramps = (step.rises ? 1 : 0) + (step.falls ? 1 : 0);
    const double rise = ramps > 0 ? std::min(ramp_, length / ramps) : 0;
    const double peak = ramps > 0 ? rise / ramp_ : 1;
    const double rate = step.side / ramp_;
    if (step.rises) pose = advance(pose, {0, step.gear * rise, rate});
    pose = advance(pose, {step.side * peak, step.gear * (length - ramps * rise)});
    if (step.falls) pose = advance(pose, {step.side * peak, step.gear * rise, -rate});
    return pose;
  }

  /// The length of the last turn that gives the path the goal's heading.
  [[nodiscard]] double last_length(const Word& word, double heading, const Pose& goal) const {
    const Step& last = word.back();
    const double angle = last.side * last.gear * (goal.heading - heading);
    return length_of(last, angle - 2 * pi * std::floor(angle / (2 * pi)));
  }

  struct Trial {
    double x, y;    // by what it misses the goal
    double length;  // of the path
  };

  /// A word without a line: its first turn and those between, all of one length.
  [[nodiscard]] Trial tried(const Word& word, double first, double inner, const Pose& goal) const {
    Pose pose = driven({}, word.front(), first);
    double length = first;
    for (std::size_t i = 1; i + 1 < word.size(); ++i) {
      pose = driven(pose, word[i], inner);
      length += inner;
    }
    const double last = last_length(word, pose.heading, goal);
    pose = driven(pose, word.back(), last);
    return {goal.x - pose.x, goal.y - pose.y, length + last};
  }

  /// A word with a line, which goes as near to the goal as it can; the turns between the first and
  /// the last are quarter turns. `y` is what it misses the goal by, to the side.
  [[nodiscard]] Trial tried(const Word& word, double first, const Pose& goal) const {
    Pose pose = driven({}, word.front(), first);
    double length = first;
    Pose at_line;
    double gear = 1;
    for (std::size_t i = 1; i + 1 < word.size(); ++i) {
      if (word[i].side == 0) {
        at_line = pose;
        gear = word[i].gear;
        continue;
      }
      const double quarter = length_of(word[i], pi / 2);
      pose = driven(pose, word[i], quarter);
      length += quarter;
    }
    const double last = last_length(word, pose.heading, goal);
    pose = driven(pose, word.back(), last);
    const double x = goal.x - pose.x, y = goal.y - pose.y;
    const double cos = std::cos(at_line.heading), sin = std::sin(at_line.heading);
    const double line = gear * (x * cos + y * sin);
    return {0, y * cos - x * sin, line < 0 ? none : length + last + line};
  }

  [[nodiscard]] double lined(const Word& word, const Pose& goal) const {
    constexpr int places = 200;
    const double most = length_of(word.front(), pi);
    double least = none;
    for (int i = 0; i < places; ++i) {
      double low = most * i / places, high = most * (i + 1) / places;
      const double sign = tried(word, low, goal).y;
      if (sign * tried(word, high, goal).y > 0) continue;
      for (int halving = 0; halving < 60; ++halving) {
        const double middle = (low + high) / 2;
        (sign * tried(word, middle, goal).y > 0 ? low : high) = middle;
      }
      const Trial trial = tried(word, low, goal);
      if (std::abs(trial.y) < 1e-9) least = std::min(least, trial.length);
    }
    return least;
  }

  [[nodiscard]] double turning(const Word& word, const Pose& goal) const {
    constexpr std::size_t places = 40;
    const double first = length_of(word[0], pi) / places;
    const double inner = length_of(word[1], pi) / places;
    std::array<std::array<double, places + 2>, places + 2> miss;
    for (auto& row : miss) row.fill(none);
    for (std::size_t i = 1; i <= places; ++i) {
      for (std::size_t j = 1; j <= places; ++j) {
        const Trial t = tried(word, first * (static_cast<double>(i) - 0.5),
                              inner * (static_cast<double>(j) - 0.5), goal);
        miss[i][j] = std::hypot(t.x, t.y);
      }
    }
    double least = none;
    for (std::size_t i = 1; i <= places; ++i) {
      for (std::size_t j = 1; j <= places; ++j) {
        const double here = miss[i][j];
        if (here > std::min({miss[i - 1][j], miss[i + 1][j], miss[i][j - 1], miss[i][j + 1]})) {
          continue;
        }
        least = std::min(least, refined(word, first * (static_cast<double>(i) - 0.5),
                                        inner * (static_cast<double>(j) - 0.5), goal));
      }
    }
    return least;
  }

  /// Newton's method with slopes by differences, from a place of the grid.
  [[nodiscard]] double refined(const Word& word, double first, double inner,
                               const Pose& goal) const {
    constexpr double h = 1e-6;
    for (int step = 0; step < 40; ++step) {
      const Trial t = tried(word, first, inner, goal);
      if (std::hypot(t.x, t.y) < 1e-9) return first >= 0 && inner >= 0 ? t.length : none;
      const Trial a = tried(word, first + h, inner, goal);
      const Trial b = tried(word, first, inner + h, goal);
      const double ax = (a.x - t.x) / h, ay = (a.y - t.y) / h;
      const double bx = (b.x - t.x) / h, by = (b.y - t.y) / h;
      const double det = ax * by - ay * bx;
      if (det == 0) return none;
      first += std::clamp((t.y * bx - t.x * by) / det, -0.2, 0.2);
      inner += std::clamp((t.x * ay - t.y * ax) / det, -0.2, 0.2);
      if (!(first > -0.5) || !(inner > -0.5)) return none;
      first = std::max(first, 0.0);
      inner = std::max(inner, 0.0);
    }
    return none;
  }

  double ramp_;
  Continuity continuity_;
  std::set<std::string> words_;
};

}  // namespace vandplan
