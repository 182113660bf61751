// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "recording/moments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "vandplan/input_error.h"
#include "vandplan/vehicle.h"

namespace vandplan::recording {
namespace {

constexpr double moment_step = 0.02;     // Time between moments [s].
constexpr double most_moments = 50'000;  // Largest number of moments of a planned drive, about.

/// Hitch angle along a path. Distances are asked for in order.
class Trailing {
 public:
  Trailing(const Vehicle& vehicle, const Path& path, double angle)
      : vehicle_(vehicle), path_(path), angle_(angle) {}

  double angle_at(double s) {
    const std::vector<Segment>& segments = path_.segments;
    while (next_ < segments.size() && begin_ + std::abs(segments[next_].length) <= s) {
      angle_ = hitch_angle_after(vehicle_, angle_, segments[next_]);
      begin_ += std::abs(segments[next_++].length);
    }
    if (next_ == segments.size()) return angle_;
    return hitch_angle_after(vehicle_, angle_, part_of(segments[next_], 0.0, s - begin_));
  }

 private:
  const Vehicle& vehicle_;
  const Path& path_;
  double angle_;        // Hitch angle at `begin_` [rad].
  double begin_ = 0.0;  // Distance where the segment `next_` begins [m].
  std::size_t next_ = 0;
};

void expect_finite(const char* where, std::initializer_list<double> numbers) {
  if (std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); }))
    return;
  throw InputError(where, "has a number that is not finite");
}

const char* way_of(Gear gear) { return gear == Gear::forward ? "forward" : "in reverse"; }

}  // namespace

std::vector<Event> events_of(const RecordedDrive& drive) {
  std::vector<Event> events;
  const auto add = [&](const DriveMoment& m, Level level, std::string text) {
    events.push_back({m.t, level, std::move(text)});
  };
  DriveMoment before = drive.log.front();
  add(before, Level::info, fmt::format("drive begins {}", way_of(before.gear)));
  for (const DriveMoment& m : drive.log) {
    if (before.v != 0.0 && m.v == 0.0) {
      add(m, Level::info, fmt::format("stops after {:.2f} m", m.s));
    }
    if (before.gear != m.gear) {
      add(m, Level::info, fmt::format("gear change, goes on {}", way_of(m.gear)));
    }
    before = m;
  }
  add(before, drive.has_arrived ? Level::info : Level::warning,
      fmt::format("{} after {:.2f} s", drive.has_arrived ? "arrives" : "does not arrive",
                  before.t));
  if (!drive.contact) return events;
  const Event contact{drive.contact->t, Level::error, "contact: " + drive.contact->what};
  const auto is_later = [&](const Event& event) { return event.t > contact.t; };
  events.insert(std::find_if(events.begin(), events.end(), is_later), contact);
  return events;
}

std::vector<DriveMoment> planned_moments(const Scenario& scenario, const PlanResult& plan) {
  const Path& path = *plan.path;
  const Vehicle& vehicle = scenario.vehicle;
  const SpeedProfile speeds =
      plan.speeds ? *plan.speeds : speed_profile(path, vehicle, speed_options(scenario, path));
  Trailing trailing(vehicle, path, scenario.hitch_angles.start);
  std::vector<DriveMoment> moments;
  const double step = std::max(moment_step, speeds.duration / most_moments);
  for (const Motion& motion : sampled(path, vehicle, speeds, step)) {
    DriveMoment& moment = moments.emplace_back();
    moment.t = motion.t;
    moment.s = motion.s;
    moment.pose = motion.pose;
    moment.gear = motion.gear;
    moment.v = motion.v;
    moment.steering_angle = moment.wanted_steering = motion.steering_angle;
    moment.wanted_acceleration = motion.a * direction_of(motion.gear);
    if (vehicle.trailer) moment.hitch_angle = trailing.angle_at(motion.s);
  }
  return moments;
}

std::vector<DriveMoment> moved_to(std::span<const DriveMoment> log, const Point& origin) {
  if (log.empty()) throw InputError("drive", "has no moments, expected its log");
  std::vector<DriveMoment> moved(log.begin(), log.end());
  double before = 0.0;
  for (DriveMoment& m : moved) {
    expect_finite("drive", {m.t, m.s, m.pose.x, m.pose.y, m.pose.heading, m.v, m.steering_angle,
                            m.wanted_steering, m.wanted_acceleration, m.lateral_error,
                            m.heading_error, m.hitch_angle.value_or(0.0)});
    if (m.t < before) throw InputError("drive", "has times that decrease, or one below 0");
    before = m.t;
    m.pose.x -= origin.x;
    m.pose.y -= origin.y;
  }
  return moved;
}

PlanResult moved_to(const PlanResult& plan, const Point& origin) {
  PlanResult moved = plan;
  const auto move = [&](Pose& pose) {
    expect_finite("plan", {pose.x, pose.y, pose.heading});
    pose.x -= origin.x;
    pose.y -= origin.y;
  };
  if (moved.path) move(moved.path->start);
  if (moved.tree) std::for_each(moved.tree->poses.begin(), moved.tree->poses.end(), move);
  for (const CostSample& sample : moved.anytime) {
    expect_finite("plan", {sample.time, sample.cost});
  }
  expect_finite("plan", {moved.lower_bound.value_or(0.0)});
  return moved;
}

}  // namespace vandplan::recording
