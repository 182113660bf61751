// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "judge/along.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

namespace vandplan::judge {
namespace {

constexpr double look_distance = 1e-3;    // of any point of a body between two looks [m]
constexpr double clearance_error = 1e-3;  // of the clearance reported [m]
constexpr double walking_sight = 1.0;     // of a walk to the first touch [m]

/// After one full turn an arc repeats itself; a clothoid never does.
Real length_to_look_at(const Stretch& stretch) {
  if (stretch.rate != 0) return stretch.length;
  const Real curvature = std::abs(stretch.curvature);
  return curvature * stretch.length > full_turn ? full_turn / curvature : stretch.length;
}

/// No point of the body moves further than this for each metre driven.
double speed_of(const Rectangle& body, const Stretch& stretch) {
  return 1 + static_cast<double>(steepest(stretch)) * reach_of(body);
}

/// A part of a stretch, with one thing in view.
struct Part {
  double bound = 0.0;  ///< the thing is no nearer anywhere on it [m]
  std::size_t thing = 0;
  std::size_t stretch = 0;
  Real begin = 0;
  Real end = 0;
};

struct MayComeNearer {
  bool operator()(const Part& a, const Part& b) const { return a.bound > b.bound; }
};

class Survey {
 public:
  Survey(const Track& track, const std::vector<Thing>& things) : track_(track), things_(things) {}

  void look_at_ends();
  void look_between();
  [[nodiscard]] Nearest result() const { return {least_, touch_}; }

 private:
  [[nodiscard]] double clearance(std::size_t thing, const Place& place, double half) const {
    const Stretch& stretch = track_.stretches[place.stretch];
    const auto curvature = static_cast<double>(curvature_at(stretch, place.t));
    const auto rate = static_cast<double>(stretch.rate);
    return things_[thing].clearance({after(stretch, place.t), curvature, half, rate}, least_);
  }
  /// Whether the body passes it before any of its points has moved by more than `look_distance`.
  [[nodiscard]] bool is_short(const Part& part) const {
    const double speed = speed_of(things_[part.thing].body, track_.stretches[part.stretch]);
    return static_cast<double>(part.end - part.begin) * speed <= look_distance;
  }
  void look(std::size_t thing, const Place& place) {
    least_ = clearance(thing, place, 0);
    if (least_ == 0 && !touch_) touch_ = Touch{thing, place};
  }

  const Track& track_;
  const std::vector<Thing>& things_;
  double least_ = std::numeric_limits<double>::infinity();
  std::optional<Touch> touch_;
};

void Survey::look_at_ends() {
  for (std::size_t thing = 0; thing < things_.size(); ++thing) {
    for (std::size_t i = 0; i < track_.stretches.size(); ++i) look(thing, {i, 0});
    look(thing, {track_.stretches.size() - 1, track_.stretches.back().length});
  }
}

void Survey::look_between() {
  std::priority_queue<Part, std::vector<Part>, MayComeNearer> parts;
  for (std::size_t thing = 0; thing < things_.size(); ++thing) {
    for (std::size_t i = 0; i < track_.stretches.size(); ++i) {
      parts.push({0, thing, i, 0, length_to_look_at(track_.stretches[i])});
    }
  }
  for (; !parts.empty() && least_ > 0;) {
    const Part part = parts.top();
    parts.pop();
    const auto half = static_cast<double>((part.end - part.begin) / 2);
    const Place middle{part.stretch, (part.begin + part.end) / 2};
    const double bound = clearance(part.thing, middle, half);
    if (bound > 0 && bound >= least_ - clearance_error) continue;
    look(part.thing, middle);
    if (bound >= least_ - clearance_error && is_short(part)) continue;
    parts.push({bound, part.thing, part.stretch, part.begin, middle.t});
    parts.push({bound, part.thing, part.stretch, middle.t, part.end});
  }
}

bool is_before(const Place& a, const Place& b) {
  return std::tie(a.stretch, a.t) < std::tie(b.stretch, b.t);
}

/// Looks along the track, at every millimetre that the body moves, or as far as the clearance
/// proves that nothing can be touched in between: lowers `touch` to the first touch of a thing if
/// that is before it.
void walk(const Track& track, const Thing& thing, std::size_t index, Touch& touch) {
  for (Place place; place.stretch <= touch.place.stretch; ++place.stretch) {
    const Stretch& stretch = track.stretches[place.stretch];
    const double speed = speed_of(thing.body, stretch);
    for (place.t = 0; place.t < length_to_look_at(stretch) && is_before(place, touch.place);) {
      const double distance = thing.clearance({after(stretch, place.t)}, walking_sight);
      if (distance == 0) {
        touch = {index, place};
        return;
      }
      place.t += std::max(look_distance, distance) / speed;
    }
  }
}

}  // namespace

Nearest nearest_along(const Track& track, const std::vector<Thing>& things) {
  Survey survey(track, things);
  survey.look_at_ends();
  survey.look_between();
  Nearest nearest = survey.result();
  if (nearest.touch) {
    for (std::size_t i = 0; i < things.size(); ++i) walk(track, things[i], i, *nearest.touch);
  }
  return nearest;
}

}  // namespace vandplan::judge
