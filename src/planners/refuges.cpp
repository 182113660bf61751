// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/refuges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "base/trigonometry.h"
#include "moving/encounters.h"
#include "planners/anytime/finish.h"
#include "planners/drive_time.h"
#include "search/route.h"
#include "search/wheels.h"
#include "vandplan/search.h"
#include "vandplan/steering.h"
#include "vandplan/vehicle.h"

namespace vandplan::in_time {
namespace {

using planning::PathSearch;

constexpr int poses_of_draw = 100;      // poses that are drawn
constexpr int free_poses_of_draw = 6;   // free poses that are tried
constexpr double furthest_aside = 4.0;  // largest distance from the path [vehicle lengths]
constexpr double share_along = 0.6;     // share of poses along the path
constexpr double share_across = 0.2;    // share of poses across the path
constexpr int places_to_leave = 4;      // tries to leave the path, and to come back
constexpr double furthest_along = 6.0;  // largest distance along the path [turning radii]
constexpr double look_step = 0.5;       // time between looks at obstacles [s]
constexpr double max_steps = 400;       // most looks at an obstacle
constexpr double infinity = std::numeric_limits<double>::infinity();

double length_of(const Vehicle& vehicle) {
  return vehicle.rear_overhang + vehicle.wheelbase + vehicle.front_overhang;
}

/// Position near `s` where the path can be left: `s` itself on a line, otherwise the end of its
/// segment where the wheels are straighter.
double straight_place(const Path& path, double s) {
  double begin = 0.0;
  for (const Segment& segment : path.segments) {
    const double end = begin + std::abs(segment.length);
    if (s <= end) {
      if (segment.curvature == 0.0 && segment.curvature_rate == 0.0) return s;
      return std::abs(segment.curvature) <= std::abs(curvature_at(segment, end - begin)) ? begin
                                                                                         : end;
    }
    begin = end;
  }
  return begin;
}

void append(std::vector<Segment>& way, const Piece& piece) {
  way.insert(way.end(), piece.view().begin(), piece.view().end());
}

/// Search for a path from the start through a refuge: two searches, which take turns once both have
/// a path.
class Through final : public PathSearch {
 public:
  Through(const Task& task, const Detour& detour, SearchMaker make_search)
      : tasks_{task, task},
        make_search_(std::move(make_search)),
        paths_{detour.there, detour.onward} {
    auto& [there, onward] = tasks_;
    there.goal = onward.start = detour.refuge;
    onward.moving.clear();  // when the vehicle leaves the refuge is not known
    there.curvatures.goal = onward.curvatures.start = 0.0;
    there.hitch_angles.goal = 0.0;
    there.last_stretch = 0.0;
    if (task.steering != Steering::continuous_between_stops || paths_[0].empty()) return;
    // The vehicle may roll on through the refuge, and may turn its wheels at the ends.
    there.steering = onward.steering = Steering::continuous;
    there.curvatures.start = paths_[0].front().curvature;
    onward.curvatures.goal = search::last_driven(paths_[1].back()).curvature;
    // Wheels that are turned further at the ends cannot be turned back on the way: the detour
    // stays.
    const double most = 1 / search::continuous_radius(task.vehicle);
    has_failed_ =
        std::max(std::abs(there.curvatures.start), std::abs(onward.curvatures.goal)) > most;
  }

  bool advance(std::int64_t most) override {
    const std::size_t leg = next_leg();
    if (leg >= searches_.size()) return false;
    if (!searches_[leg]) {
      searches_[leg] = make_search_(tasks_[leg], {tasks_[leg].start, paths_[leg]});
    }
    const bool goes_on = searches_[leg]->advance(most);
    turn_ = 1 - leg;
    if (std::optional<std::vector<Segment>> path = searches_[leg]->path()) {
      paths_[leg] = *std::move(path);
      if (leg == 0) begin_second();
    } else if (!goes_on) {
      has_failed_ = true;
    }
    is_finished_[leg] = !goes_on || (leg == 0 && tasks_[0].vehicle.trailer && !paths_[0].empty());
    return true;
  }

  [[nodiscard]] std::optional<std::vector<Segment>> path() override {
    if (paths_[0].empty() || paths_[1].empty()) return std::nullopt;
    std::vector<Segment> joined = paths_[0];
    joined.insert(joined.end(), paths_[1].begin(), paths_[1].end());
    return joined;
  }

  [[nodiscard]] std::int64_t iterations() const override {
    std::int64_t sum = 0;
    for (const auto& search : searches_) sum += search ? search->iterations() : 0;
    return sum;
  }

  [[nodiscard]] PlannerAnswer answer() override {
    PlannerAnswer answer{.iterations = iterations()};
    answer.segments = path();
    answer.status = answer.segments ? PlanStatus::solved : PlanStatus::iteration_limit;
    return answer;
  }

 private:
  /// Index of the leg whose turn it is: one without a path, otherwise the legs take turns; 2: none.
  [[nodiscard]] std::size_t next_leg() const {
    if (has_failed_) return 2;
    for (const std::size_t leg : {std::size_t{0}, std::size_t{1}}) {
      if (paths_[leg].empty()) return is_finished_[leg] ? 2 : leg;
    }
    if (!is_finished_[turn_]) return turn_;
    return is_finished_[1 - turn_] ? 2 : 1 - turn_;
  }

  /// Sets the hitch angle at the refuge, where a trailer arrives a little askew. The path to the
  /// refuge then stays as it is.
  void begin_second() {
    State state = start_state(tasks_[0]);
    if (!tasks_[0].vehicle.trailer) return;
    for (const Segment& segment : paths_[0]) {
      state = vandplan::advance(tasks_[0].vehicle, state, segment);
    }
    tasks_[1].hitch_angles.start = state.hitch_angle;
  }

  std::array<Task, 2> tasks_;
  SearchMaker make_search_;
  std::array<std::unique_ptr<PathSearch>, 2> searches_;
  std::array<std::vector<Segment>, 2> paths_;
  std::array<bool, 2> is_finished_{};
  bool has_failed_ = false;
  std::size_t turn_ = 0;
};

}  // namespace

Refuges::Refuges(const Task& task, const search::CostRule& rule, const PlanOptions& options)
    : task_(task),
      connector_(task, rule),
      margin_(options.clearance.margin),
      rng_(options.budget.seed) {}

std::optional<Detour> Refuges::draw(const Path& path, std::size_t passing) {
  std::optional<Detour> best;
  double shortest = infinity;
  int looks = 0;
  ++draws_;
  for (int i = 0; i < poses_of_draw && looks < free_poses_of_draw; ++i) {
    const double s = uniform01(rng_) * length(path);
    const LocalPose refuge = pose_beside(Local(pose_at(path, s)));
    if (!task_.checker->is_free(refuge)) continue;
    ++looks;
    std::optional<Detour> detour = this->detour(path, s, refuge);
    if (!detour) continue;
    const double way = length(detour->there) + length(detour->onward);
    if (way >= shortest || !lets_pass(refuge, passing)) continue;
    shortest = way;
    best = std::move(detour);
  }
  return best;
}

/// Random pose on either side of the path, more often near the path than far from it.
LocalPose Refuges::pose_beside(const LocalPose& on_path) {
  const double nearest = task_.vehicle.width / 2;
  const double furthest = furthest_aside * length_of(task_.vehicle);
  const double far = uniform01(rng_);
  const double side = uniform01(rng_) < 0.5 ? -1.0 : 1.0;
  const double aside = side * (nearest + far * far * (furthest - nearest));
  const auto [sin, cos] = base::sin_cos(on_path.heading);
  LocalPose pose({on_path.x - sin * aside, on_path.y + cos * aside, on_path.heading});
  const double kind = uniform01(rng_);
  if (kind >= share_along + share_across) {
    pose.heading += uniform(-std::numbers::pi, std::numbers::pi, rng_);
  } else if (kind >= share_along) {
    pose.heading += (kind < share_along + share_across / 2 ? -1 : 1) * std::numbers::pi / 2;
  }
  return pose;
}

/// Detour from the path to the refuge beside position `s`.
std::optional<Detour> Refuges::detour(const Path& path, double s, const LocalPose& refuge) {
  if (task_.vehicle.trailer) return Detour{refuge};
  std::optional<std::vector<Segment>> there = way_there(path, s, refuge);
  if (!there) return std::nullopt;
  std::optional<std::vector<Segment>> onward = way_onward(path, s, refuge);
  if (!onward) return std::nullopt;
  return Detour{refuge, *std::move(there), *std::move(onward)};
}

std::optional<std::vector<Segment>> Refuges::way_there(const Path& path, double s,
                                                       const LocalPose& refuge) {
  for (int i = 0; i < places_to_leave; ++i) {
    const double back = uniform(0.0, furthest_along, rng_) * task_.vehicle.min_turning_radius;
    const double leaves = straight_place(path, std::max(s - back, 0.0));
    std::vector<Segment> way = search::part_of(path.segments, 0.0, leaves);
    search::DrivenBeside beside{
        .before = search::driven_at_ends(task_, connector_.rule().initial_gear).before};
    if (!way.empty()) beside.before = search::last_driven(way.back());
    const auto piece = connector_.connect(Local(pose_at(path, leaves)), refuge, {.beside = beside});
    if (!piece) continue;
    append(way, piece->piece);
    return way;
  }
  return std::nullopt;
}

std::optional<std::vector<Segment>> Refuges::way_onward(const Path& path, double s,
                                                        const LocalPose& refuge) {
  const double end = length(path) - std::abs(task_.last_stretch);
  for (int i = 0; i < places_to_leave; ++i) {
    const double ahead = uniform(0.0, furthest_along, rng_) * task_.vehicle.min_turning_radius;
    const double returns = straight_place(path, std::min(s + ahead, end));
    const std::vector<Segment> rest = search::part_of(path.segments, returns, length(path));
    search::DrivenBeside beside{.after = search::driven_at_ends(task_).after};
    if (!rest.empty()) beside.after = {search::gear_of(rest.front()), rest.front().curvature};
    const auto piece =
        connector_.connect(refuge, Local(pose_at(path, returns)), {.beside = beside});
    if (!piece) continue;
    std::vector<Segment> way;
    append(way, piece->piece);
    way.insert(way.end(), rest.begin(), rest.end());
    return way;
  }
  return std::nullopt;
}

std::vector<Segment> Refuges::tidied(std::vector<Segment> path) {
  if (task_.vehicle.trailer) return path;
  return anytime::tidied(connector_, task_.start, std::move(path));
}

/// Whether no obstacle comes to the pose from the vehicle's earliest arrival until the passing
/// obstacle is nearest. Looks only now and then, because the drive is checked later.
bool Refuges::lets_pass(const LocalPose& pose, std::size_t passing) const {
  const Path none{pose, {}};
  const moving::Encounters encounters({none, task_.vehicle}, task_.moving, margin_);
  const double way = reeds_shepp_length(task_.start, pose, task_.vehicle.min_turning_radius);
  const double begin = way / planning::top_speed(task_.vehicle, {});
  const double end = std::max(encounters.rests(passing), begin);
  const double step = std::max(look_step, (end - begin) / max_steps);
  const auto gap = [&](std::size_t i, double t) {
    const std::optional<double> leaves = encounters.leaves(i);
    return leaves && *leaves < t ? infinity : encounters.gap(i, pose, t, infinity);
  };
  double nearest = infinity, passes = begin;
  for (double t = begin; t <= end; t += step) {
    const double distance = gap(passing, t);
    if (distance <= 0.0) return false;
    if (distance < nearest) {
      nearest = distance;
      passes = t;
    }
  }
  for (std::size_t i = 0; i < encounters.size(); ++i) {
    for (double t = begin; i != passing && t <= passes; t += step) {
      if (gap(i, t) <= 0.0) return false;
    }
  }
  return true;
}

std::unique_ptr<PathSearch> search_through(const Task& task, const Detour& detour,
                                           SearchMaker make_search) {
  return std::make_unique<Through>(task, detour, std::move(make_search));
}

}  // namespace vandplan::in_time
