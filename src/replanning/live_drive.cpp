// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/replanner.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <utility>

#include "base/require.h"
#include "base/trigonometry.h"
#include "drive/controllers.h"
#include "drive/noise.h"
#include "drive/watch.h"
#include "replanning/sensor.h"
#include "vandplan/input_error.h"
#include "vandplan/judge.h"

namespace vandplan {
namespace {

using namespace driving;
using namespace replanning;

// Largest distance from the end of the drive on arrival [m].
constexpr double arrived_enough = 0.02;
constexpr double correction = 0.1;  // weight of a measurement in the estimate of the pose
// Gain from the distance behind the drive to the speed [m/s per m].
constexpr double catch_up = 2.0;
constexpr double turns_standing = 1e-3;  // up to this speed the wheels turn as at standstill [m/s]

const LiveDriveOptions& checked(const LiveDriveOptions& options) {
  const double periods = options.period / control_period;
  base::require(options.period >= control_period && options.period <= 10.0 &&
                    std::abs(periods - std::round(periods)) < 1e-6,
                "period", options.period, "a multiple of 0.02 s, 0.02 to 10 s");
  if (options.sensor_range) {
    base::require(*options.sensor_range > 0.0 && *options.sensor_range <= 1e4, "sensor_range",
                  *options.sensor_range, "more than 0 m, at most 10000 m");
  }
  base::require(options.horizon >= 0.1 && options.horizon <= 100.0, "horizon", options.horizon,
                "0.1 to 100 s");
  base::require(options.longest > 0.0 && options.longest <= 1e5, "longest", options.longest,
                "more than 0 s, at most 100000 s");
  base::require(options.action_rate >= 0.0 && options.action_rate <= 1000.0, "action_rate",
                options.action_rate, "0 to 1000 per second");
  const DriveOptions& drive = options.drive;
  base::require(drive.noise >= 0.0 && drive.noise <= 10.0, "noise", drive.noise, "0 to 10");
  base::require(drive.delay >= 0.0 && drive.delay <= 1.0, "delay", drive.delay, "0 to 1 s");
  base::require(drive.spare_steering >= 0.0 && drive.spare_steering <= 0.5, "spare_steering",
                drive.spare_steering, "0 to 0.5");
  return options;
}

const Controller& controller_of(const DriveOptions& options, const Vehicle& vehicle) {
  const Controller& controller =
      controller_named(options.controller.empty() ? usual_controller(vehicle) : options.controller);
  const bool is_rig = vehicle.trailer.has_value();
  if (!(is_rig ? controller.info.steers_trailer : controller.info.drives_reverse)) {
    throw InputError("controller", options.controller + (is_rig ? " drives a trailer" : " drives") +
                                       " forward only, expected one for both gears");
  }
  return controller;
}

Vehicle with_spare(Vehicle vehicle, double spare) {
  vehicle.min_turning_radius /= 1 + spare;
  return vehicle;
}

ReplanOptions replan_options(const LiveDriveOptions& options) {
  ReplanOptions replan = options.replan;
  replan.reserve = options.drive.reserve;
  return replan;
}

/// Driven path with speeds, made of arcs.
class Track {
 public:
  explicit Track(const Pose& start) { driven_.path.start = start; }

  void add(double t, const Segment& arc) {
    std::vector<SpeedKnot>& knots = driven_.speeds.knots;
    if (arc.length == 0.0) {
      if (knots.empty() || knots.back().v != 0.0) knots.push_back({.t = t, .s = s_});
      return;
    }
    const double way = std::abs(arc.length);
    knots.push_back({.t = t, .s = s_, .v = way / step_duration});
    driven_.path.segments.push_back(arc);
    s_ += way;
  }

  [[nodiscard]] TimedPath finished(double t) {
    driven_.speeds.knots.push_back({.t = t, .s = s_});
    driven_.speeds.duration = t;
    return std::move(driven_);
  }

 private:
  TimedPath driven_;
  double s_ = 0.0;
};

class LiveDrive {
 public:
  LiveDrive(const Scenario& scenario, const LiveDriveOptions& options,
            const std::function<void(const Action&)>& on_action)
      : scenario_(scenario),
        options_(checked(options)),
        on_action_(on_action),
        controller_(controller_of(options.drive, scenario.vehicle)),
        truth_(make_problem(scenario)),
        vehicle_(with_spare(scenario.vehicle, options.drive.spare_steering)),
        replanner_(options.sensor_range ? unseen(scenario) : scenario, replan_options(options)),
        rng_(options.drive.seed),
        error_(actuator_error(options.drive.noise, rng_)),
        watch_(truth_, options.drive.spare_steering),
        track_(scenario.start) {
    if (options.sensor_range) sensor_.emplace(scenario, *options.sensor_range);
    real_ = {truth_.task().start, truth_.hitch_angles().start};
    state_.pose = real_.pose;
    state_.hitch_angle = real_.hitch_angle;
    state_.steering_angle = steering_angle(vehicle_, truth_.curvatures().start);
    const double periods = std::ceil(options.drive.delay / control_period - 1e-9);
    under_way_.assign(static_cast<std::size_t>(periods),
                      {.steering_angle = state_.steering_angle, .acceleration = -1.0});
  }

  LiveDriveResult run() {
    const auto ticks = static_cast<std::int64_t>(std::round(options_.period / control_period));
    look(real_, {}, real_);
    for (std::int64_t i = 0; t_ < options_.longest; ++i) {
      correct_estimate();
      if (i % ticks == 0) tick();
      act();
      const Command wanted = decide();
      log(wanted);
      if (has_arrived()) break;
      under_way_.push_back(wanted);
      execute(under_way_.front());
      under_way_.pop_front();
    }
    return finished();
  }

 private:
  [[nodiscard]] Pose in_scenario(const Pose& pose) const {
    return to_scenario(*truth_.world(), Local(pose));
  }

  void correct_estimate() {
    if (options_.drive.noise == 0.0) return;
    const Pose seen = measured(real_.pose, options_.drive.noise, rng_);
    Pose& pose = state_.pose;
    pose.x += correction * (seen.x - pose.x);
    pose.y += correction * (seen.y - pose.y);
    pose.heading = wrap_angle(pose.heading + correction * wrap_angle(seen.heading - pose.heading));
    if (!vehicle_.trailer) return;
    const double angle = measured_hitch_angle(real_.hitch_angle, options_.drive.noise, rng_);
    state_.hitch_angle =
        wrap_angle(state_.hitch_angle + correction * wrap_angle(angle - state_.hitch_angle));
  }

  void tick() {
    const Pose real = in_scenario(real_.pose);
    if (sensor_) {
      const WorldPatch seen = sensor_->look(real);
      if (!seen.is_empty()) replanner_.patch(seen);
    }
    replanner_.set_moving(predicted(scenario_.moving, real, t_, options_));
    const auto [sin, cos] = base::sin_cos(state_.steering_angle);
    const VehicleState state{in_scenario(state_.pose), state_.direction * state_.v,
                             sin / cos / vehicle_.wheelbase, state_.hitch_angle};
    answer_ = replanner_.tick(t_, state);
    ++result_.ticks;
    if (!answer_.is_safe) ++result_.ticks_without_answer;
    if (!answer_.reaches_goal) ++result_.stopping_ticks;
    if (answer_.outcome == TickOutcome::new_times) ++result_.new_times;
    if (answer_.outcome == TickOutcome::new_way && result_.ticks > 1) ++result_.new_ways;
    if (answer_.drive == drive_) return;
    drive_ = answer_.drive;
    const Path local{to_local(*truth_.world(), drive_->path.start), drive_->path.segments};
    strokes_ = strokes_of(local, drive_->speeds);
    if (vehicle_.trailer) tow();
  }

  /// Computes the planned hitch angles along all strokes.
  void tow() {
    towing_.clear();
    double hitch_angle = answer_.start_hitch_angle;
    for (const Stroke& stroke : strokes_) {
      towing_.emplace_back(stroke, vehicle_, hitch_angle);
      hitch_angle = towing_.back().hitch_angle_at(stroke.length());
    }
  }

  /// Reports the actions of the current control period.
  void act() {
    if (!on_action_ || options_.action_rate == 0.0) return;
    for (; static_cast<double>(acted_) / options_.action_rate < t_ + control_period - 1e-9;
         ++acted_) {
      on_action_(action_at(answer_, scenario_.vehicle,
                           static_cast<double>(acted_) / options_.action_rate));
    }
  }

  /// Index of the stroke at `s` metres of the drive; where two strokes meet, the later one.
  [[nodiscard]] std::size_t stroke_at(double s) const {
    constexpr double rounding = 1e-6;  // rounding error of a place [m]
    std::size_t i = 0;
    while (i + 1 < strokes_.size() && strokes_[i + 1].begin() <= s + rounding) ++i;
    return i;
  }

  /// Next command, for the predicted state at the time when the command takes effect.
  [[nodiscard]] Command decide() {
    MovingState state = state_;
    for (const Command& command : under_way_) state = after_period(state, command, vehicle_);
    const double when =
        t_ + static_cast<double>(under_way_.size() + 1) * control_period - answer_.begin;
    const Motion wanted = motion_at(drive_->path, scenario_.vehicle, drive_->speeds, when);
    const std::size_t i = stroke_at(wanted.s);
    const Stroke& stroke = strokes_[i];
    offset_ = stroke.offset_of(state.pose, wanted.s - stroke.begin());
    const Towing* const towing = towing_.empty() ? nullptr : &towing_[i];
    const Sight sight{stroke, vehicle_, state, offset_, 0.0, towing};
    // 1. Speed of the drive at that time, plus a gain times the distance behind.
    const double behind = wanted.s - stroke.begin() - offset_.place.s - state.v * control_period;
    const double v = std::max(std::abs(wanted.v) + catch_up * behind, 0.0);
    Command command{.steering_angle = wanted.steering_angle,
                    .acceleration = (v - state.v) / control_period,
                    .direction = stroke.direction(),
                    .stroke = i};
    // 2. At standstill the wheels follow the drive, otherwise the controller.
    if (state.v > turns_standing || wanted.v != 0.0) {
      command.steering_angle = controller_.steering_angle(sight);
    }
    const bool stands = wanted.v == 0.0 && std::abs(behind) < arrived_enough / 4;
    if (stands) command.acceleration = -1e3;
    if (stroke.length() == 0.0) command.direction = state.direction;
    place_ = stroke.begin() + offset_.place.s;
    return command;
  }

  void look(const State& from, const Segment& arc, const State& to) {
    if (auto what = watch_.look(from, arc, to)) {
      result_.contact = Contact{t_, place_, in_scenario(to.pose), *std::move(what)};
    }
  }

  void execute(const Command& command) {
    const double rate = steering_rate(state_, command, vehicle_);
    const bool was_moving = state_.v > 0.0;
    for (int i = 0; i < steps_per_period; ++i) {
      const Moved moved = step(state_, command, rate, vehicle_);
      const Segment arc = arc_of(moved, vehicle_, error_);
      track_.add(t_, moved.length == 0.0 ? Segment{} : arc);
      t_ += step_duration;
      if (moved.length == 0.0) continue;
      move_on(state_, moved, vehicle_);
      const State from = real_;
      real_ = advance(vehicle_, from, arc);
      look(from, arc, real_);
    }
    if (was_moving && state_.v == 0.0) ++result_.stops;
  }

  [[nodiscard]] bool has_arrived() const {
    if (!answer_.reaches_goal || t_ < answer_.begin + drive_->speeds.duration) return false;
    return state_.v == 0.0 && std::abs(drive_->speeds.knots.back().s - place_) <= arrived_enough;
  }

  void log(const Command& wanted) {
    if (!options_.drive.keep_log) return;
    const auto hitch_angle =
        vehicle_.trailer ? std::optional(real_.hitch_angle) : std::optional<double>();
    result_.log.push_back({.t = t_,
                           .s = place_,
                           .pose = in_scenario(real_.pose),
                           .gear = gear_of(state_.direction),
                           .v = state_.direction * state_.v + 0.0,
                           .steering_angle = state_.steering_angle,
                           .wanted_steering = wanted.steering_angle,
                           .wanted_acceleration = wanted.acceleration,
                           .lateral_error = offset_.lateral,
                           .heading_error = offset_.heading,
                           .hitch_angle = hitch_angle});
  }

  LiveDriveResult finished() {
    result_.has_arrived = has_arrived();
    if (result_.has_arrived && result_.stops > 0) --result_.stops;
    result_.duration = t_;
    const Pose end = relative(goal(), real_.pose);
    result_.end_distance = std::hypot(end.x, end.y);
    result_.end_heading = std::abs(end.heading);
    result_.clearance = watch_.clearance();
    result_.driven = track_.finished(t_);
    const DriveCheck met = check_company(truth_, until_arrival());
    result_.moving_clearance = met.clearance.value_or(std::numeric_limits<double>::infinity());
    if (met.valid || !met.t) return std::move(result_);
    if (result_.contact && result_.contact->t <= *met.t) return std::move(result_);
    result_.contact = Contact{*met.t, met.at->s, met.at->pose, met.reason};
    return std::move(result_);
  }

  /// Goal pose in the world's frame; with a set of goals the end of the planned path to one.
  [[nodiscard]] Pose goal() const {
    if (truth_.goal_set().empty() || !answer_.reaches_goal) return truth_.task().goal;
    return to_local(*truth_.world(), end_pose(drive_->path));
  }

  [[nodiscard]] const TimedPath& until_arrival() const { return result_.driven; }

  const Scenario& scenario_;
  const LiveDriveOptions& options_;
  const std::function<void(const Action&)>& on_action_;
  const Controller& controller_;
  Problem truth_;
  Vehicle vehicle_;
  Replanner replanner_;
  Rng rng_;
  ActuatorError error_;
  Watch watch_;
  Track track_;
  std::optional<Sensor> sensor_;
  ReplanAnswer answer_;                     // answer of the last tick
  std::shared_ptr<const TimedPath> drive_;  // its drive
  std::vector<Stroke> strokes_;             // strokes of the drive, in the world's frame
  std::deque<Command> under_way_;           // commands that are decided, but not yet executed
  std::vector<Towing> towing_;              // trailer along each stroke; empty without a trailer
  MovingState state_;                       // state with the estimated pose and hitch angle
  State real_;                              // true pose and hitch angle, in the world's frame
  Offset offset_;
  double place_ = 0.0;  // place along the drive [m]
  double t_ = 0.0;
  std::int64_t acted_ = 0;
  LiveDriveResult result_;
};

}  // namespace

std::string_view name_of(Prediction prediction) noexcept {
  return prediction == Prediction::known ? "known" : "constant-velocity";
}

LiveDriveResult drive_live(const Scenario& scenario, const LiveDriveOptions& options,
                           const std::function<void(const Action&)>& on_action) {
  return LiveDrive(scenario, options, on_action).run();
}

}  // namespace vandplan
