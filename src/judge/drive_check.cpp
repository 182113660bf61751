// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/judge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <utility>

#include "judge/ground.h"
#include "judge/meetings.h"
#include "judge/speed_knots.h"
#include "judge/text.h"
#include "judge/track.h"
#include "judge/trailing.h"
#include "judge/vias.h"
#include "judge/zone_prices.h"

namespace vandplan {
namespace {

using judge::after_knot;
using judge::distance_slack;
using judge::DriveFault;
using judge::Driver;
using judge::Moment;
using judge::Place;
using judge::Reached;
using judge::Real;
using judge::speed_slack;
using judge::Stretch;
using judge::text;
using judge::time_slack;
using judge::Track;
using judge::Trailing;

constexpr Real limit_slack = 1e-6;     // relative tolerance of the vehicle's limits
constexpr Real look_step = 1e-2;       // distance between two checks of the limits [m]
constexpr Real steering_slack = 1e-6;  // steering jumps up to this are rounding [rad]
constexpr Real least_motion = 1e-9;    // shorter stretches are not driven [m]

/// Place after `s` metres of the track; where two stretches meet, the later one.
Place place_at(const Track& track, Real s) {
  const auto later = std::ranges::upper_bound(track.stretches, s, {}, &Stretch::s);
  const auto i =
      static_cast<std::size_t>(std::max<std::ptrdiff_t>(later - track.stretches.begin() - 1, 0));
  return {i, std::clamp<Real>(s - track.stretches[i].s, 0, track.stretches[i].length)};
}

/// Checks the limits of a vehicle at single moments.
class LimitCheck {
 public:
  LimitCheck(const Track& track, const Vehicle& vehicle,
             const std::vector<judge::PricedPart>& parts)
      : track_(track), vehicle_(vehicle), parts_(parts) {}

  [[nodiscard]] std::optional<DriveFault> at(const SpeedKnot& knot, Real d) const {
    const Reached now = after_knot(knot, d);
    const Place place = place_at(track_, now.s);
    const Stretch& stretch = track_.stretches[place.stretch];
    const Real most = judge::max_speed_at(parts_, place);
    if (now.v > most * (1 + limit_slack) + speed_slack) {
      return DriveFault{text("the speed in a zone is %.7g, the limit is %.7g",
                             static_cast<double>(now.v), static_cast<double>(most)),
                        knot.t + d, place};
    }
    const auto [what, value, limit] =
        worst(stretch, judge::curvature_at(stretch, place.t), now, knot.jerk);
    if (value <= limit * (1 + limit_slack) + speed_slack) return std::nullopt;
    return DriveFault{text("%s is %.7g, the limit is %.7g", what, static_cast<double>(value),
                           static_cast<double>(limit)),
                      knot.t + d, place};
  }

  /// Index of the last look from `k` to `count` with the same curvature and acceleration as look
  /// `k`. It is `k` if curvature or acceleration change continuously.
  template <typename When>
  [[nodiscard]] int last_alike(const SpeedKnot& knot, const When& when, int k, int count) const {
    const Stretch& stretch =
        track_.stretches[place_at(track_, after_knot(knot, when(k)).s).stretch];
    if (knot.jerk != 0 || stretch.rate != 0 || !parts_.empty()) return k;
    const Real end = stretch.s + stretch.length;
    int beyond = count + 1;
    while (beyond - k > 1) {
      const int middle = k + (beyond - k) / 2;
      (after_knot(knot, when(middle)).s < end ? k : beyond) = middle;
    }
    return k;
  }

 private:
  struct Limit {
    const char* what;
    Real value, limit;
  };

  /// The limit that is exceeded most; any limit if none is exceeded.
  [[nodiscard]] Limit worst(const Stretch& stretch, Real curvature, const Reached& now,
                            Real jerk) const {
    const DrivingLimits& limits = vehicle_.limits;
    const Real bend = vehicle_.wheelbase * curvature;
    const Real turning = now.v * vehicle_.wheelbase * std::abs(stretch.rate) / (1 + bend * bend);
    const Real braking = limits.max_braking.value_or(limits.max_acceleration);
    const Real jerkiest = limits.max_jerk.value_or(std::numeric_limits<double>::max());
    const Limit all[] = {
        {"the speed", now.v,
         stretch.direction > 0 ? limits.max_speed.forward : limits.max_speed.reverse},
        {"the speed backwards along the path", -now.v, 0},
        {"the lateral acceleration", now.v * now.v * std::abs(curvature),
         limits.max_lateral_acceleration},
        {"the steering rate", turning, limits.max_steering_rate},
        {"the acceleration", now.a, limits.max_acceleration},
        {"the braking", -now.a, braking},
        {"the jerk", std::abs(jerk), jerkiest}};
    return *std::ranges::max_element(
        all, {}, [](const Limit& limit) { return limit.value - limit.limit * (1 + limit_slack); });
  }

  const Track& track_;
  const Vehicle& vehicle_;
  const std::vector<judge::PricedPart>& parts_;
};

/// First broken limit: checked every centimetre and at both ends of constant acceleration.
std::optional<DriveFault> broken_limit(const SpeedProfile& speeds, const Track& track,
                                       const Vehicle& vehicle,
                                       const std::vector<judge::PricedPart>& parts) {
  const LimitCheck check(track, vehicle, parts);
  for (std::size_t i = 0; i + 1 < speeds.knots.size(); ++i) {
    const SpeedKnot& knot = speeds.knots[i];
    const Real lasts = static_cast<Real>(speeds.knots[i + 1].t) - knot.t;
    // At both ends the look is slightly inside of the part, not at the joint.
    const Real way = std::abs(static_cast<Real>(speeds.knots[i + 1].s) - knot.s);
    if (way <= least_motion || lasts <= 0) continue;
    const auto count = static_cast<int>(std::min<Real>(std::ceil(way / look_step), 1e7)) + 2;
    const auto when = [&](int k) {
      return lasts * std::clamp<Real>(static_cast<Real>(k) / count, 1e-6, 1 - 1e-6);
    };
    for (int k = 0; k <= count; ++k) {
      if (auto fault = check.at(knot, when(k))) return fault;
      // With constant curvature and acceleration, each limit is nearest at one of both ends.
      const int last = check.last_alike(knot, when, k, count);
      if (last > k + 1 && !check.at(knot, when(last))) k = last;
    }
  }
  return std::nullopt;
}

/// How the vehicle passes a place of its path.
struct Passing {
  Real t = 0;         // time of arrival [s]
  Real speed = 0;     // speed at the place [m/s]
  Real standing = 0;  // duration of standing there [s]
};

/// Passing of place `s` [m] at the slowest knot there; others belong to arrival and departure.
Passing passing_of(const SpeedProfile& speeds, Real s) {
  const auto is_near = [&](const SpeedKnot& knot) {
    return std::abs(knot.s - s) <= distance_slack;
  };
  Passing passing{.t = speeds.duration, .speed = 0, .standing = 0};
  bool has_come = false;
  for (const SpeedKnot& knot : speeds.knots) {
    if (!is_near(knot) || (has_come && knot.v >= passing.speed)) continue;
    passing.t = knot.t;
    passing.speed = knot.v;
    has_come = true;
  }
  for (std::size_t i = 0; i + 1 < speeds.knots.size(); ++i) {
    const SpeedKnot& knot = speeds.knots[i];
    const SpeedKnot& next = speeds.knots[i + 1];
    if (!has_come && knot.s < s && s < next.s) {
      // Between two knots the vehicle does not stand.
      passing.t = next.t;
      passing.speed = std::max<Real>({knot.v, next.v, speed_slack * 2});
    }
    if (is_near(knot) && next.s - knot.s <= least_motion && knot.v <= speed_slack) {
      passing.standing += static_cast<Real>(next.t) - knot.t;
    }
  }
  return passing;
}

/// First place where gear or wheels need a stop that is missing or too short.
std::optional<DriveFault> rushed_stop(const SpeedProfile& speeds, const Track& track,
                                      const Task& task) {
  const Vehicle& vehicle = task.vehicle;
  const auto angle = [&](Real curvature) { return std::atan(vehicle.wheelbase * curvature); };
  Real before = task.curvatures.start;
  const Stretch* last = nullptr;  // last stretch that is long enough to be driven
  for (std::size_t i = 0; track.length > 0 && i < track.stretches.size(); ++i) {
    const Stretch& stretch = track.stretches[i];
    if (stretch.length <= least_motion) continue;
    const bool changes_gear = last != nullptr && stretch.direction != last->direction;
    last = &stretch;
    const Real turn = std::abs(angle(stretch.curvature) - angle(before));
    before = judge::curvature_at(stretch, stretch.length);
    if (!changes_gear && turn <= steering_slack) continue;
    const Passing passing = passing_of(speeds, stretch.s);
    const Place place{i, 0};
    if (passing.speed > speed_slack) {
      return DriveFault{
          text("the vehicle drives at %.4g m/s where the %s", static_cast<double>(passing.speed),
               changes_gear ? "gear changes" : "curvature jumps"),
          passing.t, place};
    }
    const Real needed = turn <= steering_slack ? 0 : turn / vehicle.limits.max_steering_rate;
    if (passing.standing >= needed - time_slack) continue;
    return DriveFault{text("the vehicle stands for %.6g s, its wheels need %.6g s to turn",
                           static_cast<double>(passing.standing), static_cast<double>(needed)),
                      passing.t, place};
  }
  return std::nullopt;
}

/// Fault of a drive that does not pass a via, or does not stand there though it has to.
std::optional<DriveFault> missed_via_of_drive(const SpeedProfile& speeds, const Track& track,
                                              const Task& task) {
  const std::size_t passed = judge::passed_by(task, track, speeds);
  if (passed == task.via.size()) return std::nullopt;
  return DriveFault{
      text("the vehicle does not %s via[%zu]", task.via[passed].stop ? "stand at" : "pass", passed),
      std::nullopt, std::nullopt};
}

/// Vehicle or trailer of a drive, for the search of meetings.
Driver driver_of(const SpeedProfile& speeds, const Track& track, const Vehicle& vehicle,
                 const Trailing* trailing) {
  Driver driver;
  driver.body = trailing != nullptr ? judge::outlines_of(*vehicle.trailer).body
                                    : judge::outlines_of(vehicle).body;
  const double reach = judge::reach_of(driver.body);
  for (const Stretch& stretch : track.stretches) {
    const Real swing = trailing != nullptr ? trailing->speed(stretch, reach)
                                           : 1 + judge::steepest(stretch) * reach;
    driver.swing = std::max(driver.swing, swing);
  }
  const auto position = [&track, trailing](const Place& place) {
    if (trailing != nullptr) return trailing->position(place);
    return judge::after(track.stretches[place.stretch], place.t);
  };
  driver.where = [&speeds, &track, position](Real t) -> Moment {
    const std::vector<SpeedKnot>& knots = speeds.knots;
    const auto later =
        std::ranges::upper_bound(knots, t, {}, [](const SpeedKnot& knot) { return Real{knot.t}; });
    if (later == knots.end()) {
      return {position(place_at(track, track.length)), 0, std::numeric_limits<Real>::infinity()};
    }
    const SpeedKnot& knot = *std::prev(later);
    const Real lasts = static_cast<Real>(later->t) - knot.t;
    const Place place = place_at(track, after_knot(knot, t - knot.t).s);
    const Real bulge = std::abs(static_cast<Real>(knot.jerk)) * lasts * lasts / 8;
    return {position(place), std::max(std::abs(knot.v), std::abs(later->v)) + bulge, later->t};
  };
  return driver;
}

/// Fault of a meeting; its text follows the name of the body.
DriveFault bad_company(const judge::Encounter& met, const DriveClaims& claims,
                       const SpeedProfile& speeds, const Track& track) {
  const auto& [obstacle, t, distance] = met;
  const Real clamped = std::min<Real>(t, speeds.duration);
  Place place = place_at(track, track.length);
  for (std::size_t i = 0; i + 1 < speeds.knots.size(); ++i) {
    const SpeedKnot& knot = speeds.knots[i];
    if (knot.t <= clamped && clamped < speeds.knots[i + 1].t) {
      place = place_at(track, after_knot(knot, clamped - knot.t).s);
    }
  }
  const std::string name = "moving[" + std::to_string(obstacle) + "]";
  if (distance == 0) return {"hits " + name, t, place};
  return {text("is only %.3f m from %s, the margin is %g m", distance, name.c_str(), claims.margin),
          t, place};
}

/// Verdict of the judge, in the scenario's frame.
DriveCheck verdict(DriveCheck check, const std::optional<DriveFault>& fault, const World& world,
                   const Track& track) {
  check.valid = !fault;
  if (!fault) return check;
  check.reason = fault->reason;
  if (fault->t) check.t = static_cast<double>(*fault->t);
  if (fault->place) {
    check.at = judge::point_at(track, *fault->place);
    check.at->pose = to_scenario(world, Local(check.at->pose));
  }
  return check;
}

Track track_of(const World& world, const Path& path) {
  return judge::integrate({to_local(world, path.start), path.segments});
}

/// First meeting of the vehicle or its trailer; `check` gets the clearance.
std::optional<DriveFault> company_fault(const Task& task, const SpeedProfile& speeds,
                                        const Track& track, const DriveClaims& claims,
                                        DriveCheck& check) {
  constexpr double margin_slack = 1e-6;  // tolerance of the margin [m]
  const double kept = std::max(claims.margin - margin_slack, 0.0);
  const auto company = [&](const Trailing* trailing) {
    return judge::company_on(driver_of(speeds, track, task.vehicle, trailing), task.moving,
                             speeds.duration, kept);
  };
  judge::Company met = company(nullptr);
  std::string part = "the footprint";
  if (task.vehicle.trailer && !task.moving.empty()) {
    const Trailing trailing(track, task.vehicle, task.hitch_angles.start);
    const judge::Company behind = company(&trailing);
    met.clearance = std::min(met.clearance, behind.clearance);
    if (behind.too_near && (!met.too_near || behind.too_near->t < met.too_near->t)) {
      met.too_near = behind.too_near;
      part = "the trailer's footprint";
    }
  }
  check.clearance = met.clearance;
  if (!met.too_near) return std::nullopt;
  DriveFault fault = bad_company(*met.too_near, claims, speeds, track);
  fault.reason = part + " " + fault.reason;
  return fault;
}

/// Parts of a track with the limits of zones; empty without such limits.
std::vector<judge::PricedPart> slow_parts(const Task& task, const Track& track) {
  const Surroundings& ground = task.world->local();
  if (!judge::has_prices(ground)) return {};
  std::optional<Trailing> trailing;
  if (task.vehicle.trailer) trailing.emplace(track, task.vehicle, task.hitch_angles.start);
  return judge::priced_parts(ground, task.vehicle, track, trailing ? &*trailing : nullptr,
                             judge::AtEdge::outside);
}

}  // namespace

DriveCheck check_drive(const Problem& problem, const TimedPath& drive, const DriveClaims& claims) {
  if (std::string fault = judge::door_fault(problem, claims.margin); !fault.empty()) {
    return {.reason = std::move(fault)};
  }
  const Task& task = problem.task();
  const SpeedProfile& speeds = drive.speeds;
  const Track track = track_of(*problem.world(), drive.path);
  DriveCheck check{.duration = speeds.duration};
  std::optional<DriveFault> fault = judge::false_knots(speeds, track.length, claims.start_speed);
  if (!fault) fault = broken_limit(speeds, track, task.vehicle, slow_parts(task, track));
  if (!fault && task.vehicle.limits.max_jerk) {
    fault = judge::acceleration_jump(speeds, claims.start_speed);
  }
  if (!fault) fault = rushed_stop(speeds, track, task);
  if (!fault) fault = missed_via_of_drive(speeds, track, task);
  if (!fault) fault = company_fault(task, speeds, track, claims, check);
  return verdict(std::move(check), fault, *problem.world(), track);
}

DriveCheck check_company(const Problem& problem, const TimedPath& drive,
                         const DriveClaims& claims) {
  std::string door = judge::door_fault(problem, claims.margin);
  if (door.empty() && drive.speeds.knots.empty()) door = "the drive has no knots";
  if (!door.empty()) return {.reason = std::move(door)};
  const Track track = track_of(*problem.world(), drive.path);
  DriveCheck check{.duration = drive.speeds.duration};
  const std::optional<DriveFault> fault =
      company_fault(problem.task(), drive.speeds, track, claims, check);
  return verdict(std::move(check), fault, *problem.world(), track);
}

}  // namespace vandplan
