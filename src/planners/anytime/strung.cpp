// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "base/trigonometry.h"
#include "planners/anytime/sources.h"
#include "search/wheels.h"

namespace vandplan::anytime {
namespace {

constexpr int max_expansions = 256;  // expansions for one leg
constexpr double least_apart = 1.0;  // least distance of bends [turning radii]
/// What the string keeps away from obstacles beside the margin, where it can [vehicle widths].
constexpr double room = 0.4;
constexpr double gentle = 4.0;             // radius of a bend that has the room [turning radii]
constexpr int tightenings = 3;             // times that each bend is moved
constexpr double gentle_leg_factor = 1.1;  // what a gentle leg may cost [straight distances]
/// What other legs may cost, as a factor on the straight distance, and more [turning radii].
constexpr double leg_factor = 1.5;
constexpr double leg_surplus = 4.0;
constexpr int max_left_out = 4;  // corners left out in a row, at most

/// Number of steps of the way that are about as long as a distance.
std::size_t places_in(double distance, std::span<const Point> way) {
  double length = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) {
    length += std::hypot(way[i].x - way[i - 1].x, way[i].y - way[i - 1].y);
  }
  const double step = length / static_cast<double>(way.size() - 1);
  return step > 0.0 ? static_cast<std::size_t>(std::ceil(distance / step)) : 1;
}

/// The task of a vehicle that keeps more room and turns on wider arcs. Its wheels are straight at
/// both ends, as they might be turned further than for these arcs.
Task roomy(const Task& task) {
  Task wide = task;
  wide.curvatures = {};
  const double margin = task.least_margin + room * task.vehicle.width;
  wide.checker = task.world->checker(task.vehicle, {.wanted = margin});
  wide.vehicle.min_turning_radius *= gentle;
  return wide;
}

/// The place of the line from `a` to `b` that is nearest to a point.
Point nearest_on_line(const Point& point, const Point& a, const Point& b) {
  const Point along{b.x - a.x, b.y - a.y};
  const double dot = (point.x - a.x) * along.x + (point.y - a.y) * along.y;
  const double part = std::clamp(dot / (along.x * along.x + along.y * along.y), 0.0, 1.0);
  return {a.x + part * along.x, a.y + part * along.y};
}

double direction_of(const Point& from, const Point& to) {
  return base::atan_2(to.y - from.y, to.x - from.x);
}

/// Guide of straight distances to the target [m], as if there were no obstacles.
class Beeline final : public Guide {
 public:
  explicit Beeline(const LocalPose& target) : target_(target) {}
  bool step() override { return false; }
  [[nodiscard]] bool is_connected() const noexcept override { return true; }
  [[nodiscard]] double at(double x, double y) const noexcept override {
    return std::hypot(x - target_.x, y - target_.y);
  }

 private:
  LocalPose target_;
};

class Strung final : public Source {
 public:
  Strung(const Task& task, std::vector<Point> way, Connector& connector)
      : task_(task),
        connector_(connector),
        wide_task_(roomy(task)),
        wide_(wide_task_, connector.rule()),
        gear_(connector.rule().allows(1) ? 1 : -1),
        way_(std::move(way)),
        least_places_(places_in(least_apart * task.vehicle.min_turning_radius, way_)),
        string_{way_.front()},
        route_{task.start, {}, 0.0} {}

  [[nodiscard]] bool step() override;
  [[nodiscard]] Route route() const override { return route_; }
  [[nodiscard]] bool has_work() const override { return !has_ended_; }

 private:
  [[nodiscard]] double heading_along(double direction) const;
  [[nodiscard]] bool sees(const Point& from, const Point& to, Connector& connector);
  [[nodiscard]] std::size_t farthest_seen(Connector& connector);
  void pull();
  void tighten();
  void turn_corners();
  void begin_leg();
  void search_leg();
  void reach_corner();
  [[nodiscard]] DrivenBeside driven_beside_leg() const;
  [[nodiscard]] const LocalPose& here() const;

  const Task& task_;
  Connector& connector_;
  Task wide_task_;
  Connector wide_;  // of the wide task
  GearSign gear_;   // gear for the straight parts of the way
  std::vector<Point> way_;
  std::size_t least_places_;        // least number of steps of the way between two bends
  std::vector<Point> string_;       // places where the string bends, and its ends
  std::size_t pulled_ = 0;          // index of the place of the way that the string has come to
  std::size_t bend_ = 1;            // index of the bend that is moved next
  int tightened_ = 0;               // times that all bends were moved
  std::vector<LocalPose> corners_;  // poses at the bends, without the start
  std::size_t next_ = 0;            // index of the corner that the current leg leads to
  int left_out_ = 0;                // corners left out in a row
  std::optional<Beeline> guide_;    // guide of the leg: a straight line, as its ends see each other
  std::optional<Lattice> lattice_;  // search for the leg, if it is not driven directly
  int expansions_ = 0;              // expansions of this search
  bool has_ended_ = false;
  Route route_;  // route from the start as far as it is found
};

double Strung::heading_along(double direction) const {
  return gear_ > 0 ? direction : wrap_angle(direction + std::numbers::pi);
}

// Whether the vehicle can drive straight from one place to another.
bool Strung::sees(const Point& from, const Point& to, Connector& connector) {
  const double distance = std::hypot(to.x - from.x, to.y - from.y);
  return connector.is_free(Local(Pose{from.x, from.y, heading_along(direction_of(from, to))}),
                           Segment{0.0, gear_ * distance});
}

// Index of the farthest place of the way in sight of the string's end, found by doubling steps and
// then halving.
std::size_t Strung::farthest_seen(Connector& connector) {
  const Point& from = way_[pulled_];
  const std::size_t last = way_.size() - 1;
  std::size_t seen = pulled_;
  std::size_t step = std::min(least_places_, last - pulled_);
  while (pulled_ + step <= last && sees(from, way_[pulled_ + step], connector)) {
    seen = pulled_ + step;
    step *= 2;
  }
  std::size_t hidden = std::min(pulled_ + step, last + 1);
  while (hidden - seen > 1) {
    const std::size_t middle = seen + (hidden - seen) / 2;
    (sees(from, way_[middle], connector) ? seen : hidden) = middle;
  }
  return seen;
}

// Adds a bend at least `least_places_` ahead: where there is room on the way to it, or else in
// sight, or else blindly.
void Strung::pull() {
  const std::size_t least = std::min(pulled_ + least_places_, way_.size() - 1);
  std::size_t next = farthest_seen(wide_);
  if (next < least) next = std::max(farthest_seen(connector_), least);
  pulled_ = next;
  string_.push_back(way_[next]);
}

// Moves the next bend towards the line between its neighbours, as far as there is room.
void Strung::tighten() {
  if (bend_ + 1 >= string_.size()) {
    bend_ = 1;
    if (++tightened_ == tightenings) turn_corners();
    return;
  }
  const Point& before = string_[bend_ - 1];
  const Point& after = string_[bend_ + 1];
  if (sees(before, after, wide_)) {
    string_.erase(string_.begin() + static_cast<std::ptrdiff_t>(bend_));
    return;
  }
  Point& bend = string_[bend_];
  const Point on_line = nearest_on_line(bend, before, after);
  for (const double part : {0.5, 0.25, 0.125}) {
    const Point there = {bend.x + part * (on_line.x - bend.x),
                         bend.y + part * (on_line.y - bend.y)};
    if (sees(before, there, wide_) && sees(there, after, wide_)) bend = there;
  }
  ++bend_;
}

// Makes poses at the bends. There the vehicle points halfway between both directions.
void Strung::turn_corners() {
  for (std::size_t i = 1; i + 1 < string_.size(); ++i) {
    const Point& corner = string_[i];
    const double in = direction_of(string_[i - 1], corner);
    const double out = direction_of(corner, string_[i + 1]);
    const double between = wrap_angle(in + wrap_angle(out - in) / 2);
    const LocalPose pose({corner.x, corner.y, heading_along(between)});
    for (const double aside : {0.0, 0.5, -0.5, 1.0, -1.0}) {
      const LocalPose there = compose(pose, {0.0, aside * task_.vehicle.width, 0.0});
      if (!connector_.is_free(there)) continue;
      corners_.push_back(there);
      break;
    }
  }
  corners_.push_back(task_.goal);
}

const LocalPose& Strung::here() const {
  return route_.legs.empty() ? route_.start : route_.legs.back().end;
}

DrivenBeside Strung::driven_beside_leg() const {
  DrivenBeside beside = driven_at_ends(task_, connector_.rule().initial_gear);
  if (!route_.legs.empty()) beside.before = last_driven(route_.legs.back().piece);
  if (next_ + 1 < corners_.size()) beside.after = {};
  return fitted_driven(task_, beside);
}

// Drives straight to the next corner, or begins a search if that is blocked or too dear.
void Strung::begin_leg() {
  const LocalPose& corner = corners_[next_];
  const DrivenBeside beside = driven_beside_leg();
  const double apart = std::hypot(corner.x - here().x, corner.y - here().y);
  // A dearer leg would turn around on its way.
  const double dearest = leg_factor * apart + leg_surplus * connector_.radius();
  std::optional<search::Connection> direct;
  const bool is_between_bends = next_ > 0 && next_ + 1 < corners_.size();
  if (is_between_bends) {
    direct = wide_.connect(here(), corner, {.cutoff = gentle_leg_factor * apart, .beside = beside});
  }
  if (!direct) {
    direct = connector_.connect(here(), corner, {.cutoff = dearest, .beside = beside});
  }
  if (direct) {
    route_.legs.push_back({direct->piece, corner});
    reach_corner();
    return;
  }
  guide_.emplace(corner);
  lattice_.emplace(here(), corner, beside, coarse_to_fine.front(), *guide_, connector_);
  lattice_->set_cutoff(dearest);
  expansions_ = 0;
}

void Strung::reach_corner() {
  lattice_.reset();
  ++next_;
  left_out_ = 0;
}

// Goes on with the search for a leg. The string ends if too many corners in a row, or the goal,
// were not reached.
void Strung::search_leg() {
  if (lattice_->step()) {
    route_.append(lattice_->route().legs);
    reach_corner();
    return;
  }
  if (++expansions_ < max_expansions && !lattice_->is_exhausted()) return;
  lattice_.reset();
  has_ended_ = next_ + 1 == corners_.size() || left_out_ == max_left_out;
  ++next_;
  ++left_out_;
}

bool Strung::step() {
  if (has_ended_) return false;
  if (pulled_ + 1 < way_.size()) {
    pull();
  } else if (tightened_ < tightenings) {
    tighten();
  } else if (next_ == corners_.size()) {
    has_ended_ = true;
    return true;
  } else if (lattice_) {
    search_leg();
  } else {
    begin_leg();
  }
  return false;
}

}  // namespace

std::unique_ptr<Source> strung(const Task& task, std::vector<Point> way, Connector& connector) {
  return std::make_unique<Strung>(task, std::move(way), connector);
}

}  // namespace vandplan::anytime
