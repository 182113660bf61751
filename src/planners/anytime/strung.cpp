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
constexpr double least_apart = 4.0;  // least distance of bends [turning radii]
/// A leg may cost so many times the straight distance, and the least distance of bends.
constexpr double leg_factor = 1.5;
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
        gear_(connector.rule().allows(1) ? 1 : -1),
        way_(std::move(way)),
        least_places_(places_in(least_apart * task.vehicle.min_turning_radius, way_)),
        route_{task.start, {}, 0.0} {}

  [[nodiscard]] bool step() override;
  [[nodiscard]] Route route() const override { return route_; }
  [[nodiscard]] bool has_work() const override { return !has_ended_; }

 private:
  [[nodiscard]] double heading_along(double direction) const;
  [[nodiscard]] bool sees(std::size_t from, std::size_t to);
  [[nodiscard]] std::size_t farthest_seen(std::size_t from);
  void pull();
  void turn_corners();
  void begin_leg();
  void search_leg();
  void reach_corner();
  [[nodiscard]] double dearest_leg(const LocalPose& corner) const;
  [[nodiscard]] DrivenBeside driven_beside_leg() const;
  [[nodiscard]] const LocalPose& here() const;

  const Task& task_;
  Connector& connector_;
  GearSign gear_;  // gear for the straight parts of the way
  std::vector<Point> way_;
  std::size_t least_places_;              // least number of steps of the way between two bends
  std::vector<std::size_t> bends_ = {0};  // indices of the places of the way where the string bends
  std::vector<LocalPose> corners_;        // poses at the bends, without the start
  std::size_t next_ = 0;                  // index of the corner that the current leg leads to
  int left_out_ = 0;                      // corners left out in a row
  std::optional<Beeline> guide_;    // guide of the leg: a straight line, as its ends see each other
  std::optional<Lattice> lattice_;  // search for the leg, if it is not driven directly
  int expansions_ = 0;              // expansions of this search
  bool has_ended_ = false;
  Route route_;  // route from the start as far as it is found
};

double Strung::heading_along(double direction) const {
  return gear_ > 0 ? direction : wrap_angle(direction + std::numbers::pi);
}

// Whether the vehicle can drive straight from one place of the way to another.
bool Strung::sees(std::size_t from, std::size_t to) {
  const Point& a = way_[from];
  const Point& b = way_[to];
  const double distance = std::hypot(b.x - a.x, b.y - a.y);
  return connector_.is_free(Local(Pose{a.x, a.y, heading_along(direction_of(a, b))}),
                            Segment{0.0, gear_ * distance});
}

// Index of the farthest place in sight, found by doubling steps and then halving. At least
// `least_places_` steps ahead.
std::size_t Strung::farthest_seen(std::size_t from) {
  const std::size_t last = way_.size() - 1;
  std::size_t seen = from;
  std::size_t step = least_places_;
  while (from + step <= last && sees(from, from + step)) {
    seen = from + step;
    step *= 2;
  }
  std::size_t hidden = std::min(from + step, last + 1);
  while (hidden - seen > 1) {
    const std::size_t middle = seen + (hidden - seen) / 2;
    (sees(from, middle) ? seen : hidden) = middle;
  }
  return std::max(seen, std::min(from + least_places_, last));
}

void Strung::pull() {
  bends_.push_back(farthest_seen(bends_.back()));
  if (bends_.back() + 1 == way_.size()) turn_corners();
}

// Makes poses at the bends. There the vehicle points halfway between both directions.
void Strung::turn_corners() {
  for (std::size_t i = 1; i + 1 < bends_.size(); ++i) {
    const Point& corner = way_[bends_[i]];
    const double in = direction_of(way_[bends_[i - 1]], corner);
    const double out = direction_of(corner, way_[bends_[i + 1]]);
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

// Most that a leg may cost. A dearer leg would turn around on its way.
double Strung::dearest_leg(const LocalPose& corner) const {
  const double apart = std::hypot(corner.x - here().x, corner.y - here().y);
  return leg_factor * apart + least_apart * connector_.radius();
}

// Drives straight to the next corner, or begins a search if that is blocked or too dear.
void Strung::begin_leg() {
  const LocalPose& corner = corners_[next_];
  const DrivenBeside beside = driven_beside_leg();
  const double dearest = dearest_leg(corner);
  if (const auto direct =
          connector_.connect(here(), corner, {.cutoff = dearest, .beside = beside})) {
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
  if (corners_.empty()) {
    pull();
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
