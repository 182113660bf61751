// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/drive.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>

#include "base/require.h"
#include "base/text.h"
#include "drive/controllers.h"
#include "drive/noise.h"
#include "drive/outline.h"
#include "drive/watch.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

using namespace driving;

// Largest error of the steering angle when a stroke begins [rad].
constexpr double turned_enough = 1e-4;
constexpr double arrived_enough = 5e-3;  // largest distance from the end of a stroke on arrival [m]
constexpr double correction = 0.1;       // weight of a measurement in the estimate of the state

const Controller& checked_controller(const DriveOptions& options, const Path& path,
                                     const Vehicle& vehicle) {
  base::require(options.noise >= 0.0 && options.noise <= 10.0, "noise", options.noise, "0 to 10");
  base::require(options.delay >= 0.0 && options.delay <= 1.0, "delay", options.delay, "0 to 1 s");
  base::require(options.reserve >= 0.0 && options.reserve <= 0.5, "reserve", options.reserve,
                "0 to 0.5");
  base::require(options.spare_steering >= 0.0 && options.spare_steering <= 0.5, "spare_steering",
                options.spare_steering, "0 to 0.5");
  const Controller& controller =
      controller_named(options.controller.empty() ? usual_controller(vehicle) : options.controller);
  const bool drives_reverse =
      vehicle.trailer ? controller.info.steers_trailer : controller.info.drives_reverse;
  if (drives_reverse) return controller;
  double reverse = 0.0;
  for (const Segment& segment : path.segments) reverse += std::max(-segment.length, 0.0);
  if (reverse == 0.0) return controller;
  const std::string what = vehicle.trailer ? " drives a trailer" : " drives";
  throw InputError("controller", options.controller + what + " forward only, the path has " +
                                     base::shortest_text(std::round(reverse * 1e3) / 1e3) +
                                     " m in reverse");
}

/// Throws if the path is sharper than the vehicle can drive. A relative excess of 1e-3 counts as
/// rounding: the wheels then turn as far as they can.
void expect_drivable(const Path& path, const Vehicle& vehicle) {
  const double most = (1 + 1e-3) / vehicle.min_turning_radius;
  for (std::size_t i = 0; i < path.segments.size(); ++i) {
    const Segment& segment = path.segments[i];
    for (const double driven : {0.0, std::abs(segment.length)}) {
      const double curvature = curvature_at(segment, driven);
      base::require(std::abs(curvature) <= most,
                    ("segments[" + std::to_string(i) + "].curvature").c_str(), curvature,
                    "at most 1 / min_turning_radius, " + base::shortest_text(most));
    }
  }
}

/// Vehicle whose wheels turn further than the plan needs, by the share `spare` of curvature.
Vehicle with_spare(Vehicle vehicle, double spare) {
  vehicle.min_turning_radius /= 1 + spare;
  return vehicle;
}

Polygon corners_of(const Footprint& footprint) {
  const std::array<Point, 4> rectangle = corners(footprint, {});
  return {rectangle.begin(), rectangle.end()};
}

/// Statistics of the errors of a drive.
class Errors {
 public:
  explicit Errors(const Vehicle& vehicle)
      : vehicle_(vehicle),
        body_(body_outline(vehicle)),
        wheels_(corners_of(wheel_footprint(vehicle))) {
    if (vehicle.trailer) trailer_ = body_outline(*vehicle.trailer);
  }

  /// Adds the errors at a pose that is reached after `way` driven metres.
  void add(const Stroke& stroke, const Offset& offset, const Pose& pose, double way) {
    const double lateral = std::abs(offset.lateral);
    const double heading = std::abs(offset.heading);
    largest_lateral_ = std::max(largest_lateral_, lateral);
    largest_heading_ = std::max(largest_heading_, heading);
    lateral_squares_ += lateral * lateral * way;
    heading_squares_ += heading * heading * way;
    way_ += way;
    const double s = std::clamp(offset.place.s, 0.0, stroke.length());
    const Pose planned = s == offset.place.s ? offset.place.pose : stroke.at(s).pose;
    const Pose beside = relative(planned, pose);
    outline_ = std::max({outline_, deviation_of(body_, beside), deviation_of(wheels_, beside)});
  }

  /// Adds the errors of the trailer at `state`, which should be at `planned`.
  void add_trailer(const State& planned, const State& state, double way) {
    const Pose beside = relative(trailer_pose(vehicle_, planned), trailer_pose(vehicle_, state));
    outline_ = std::max(outline_, deviation_of(trailer_, beside));
    largest_trailer_ = std::max(largest_trailer_, std::abs(beside.y));
    trailer_squares_ += beside.y * beside.y * way;
    hitch_ = std::max(hitch_, std::abs(state.hitch_angle) - std::abs(planned.hitch_angle));
  }

  void write_to(DriveResult& result) const {
    result.largest_lateral = largest_lateral_;
    result.largest_heading = largest_heading_;
    result.rms_lateral = way_ > 0.0 ? std::sqrt(lateral_squares_ / way_) : 0.0;
    result.rms_heading = way_ > 0.0 ? std::sqrt(heading_squares_ / way_) : 0.0;
    result.outline_deviation = outline_;
    if (!vehicle_.trailer) return;
    const double rms = way_ > 0.0 ? std::sqrt(trailer_squares_ / way_) : 0.0;
    result.trailer = TrailerDeviation{
        .largest_lateral = largest_trailer_, .rms_lateral = rms, .hitch_deviation = hitch_};
  }

 private:
  const Vehicle& vehicle_;
  Polygon body_;
  Polygon wheels_;
  Polygon trailer_;
  double largest_lateral_ = 0.0;
  double largest_heading_ = 0.0;
  double lateral_squares_ = 0.0;
  double heading_squares_ = 0.0;
  double largest_trailer_ = 0.0;
  double trailer_squares_ = 0.0;
  double hitch_ = 0.0;
  double outline_ = 0.0;
  double way_ = 0.0;
};

/// Simulation of a drive, in the world's frame.
class Drive {
 public:
  Drive(const Problem& problem, const Path& path, const DriveOptions& options)
      : controller_(checked_controller(options, path, problem.vehicle())),
        options_(options),
        vehicle_(with_spare(problem.vehicle(), options.spare_steering)),
        origin_(problem.world()->origin()),
        rng_(options.seed),
        error_(actuator_error(options.noise, rng_)),
        watch_(problem, options.spare_steering),
        errors_(vehicle_) {
    expect_drivable(path, problem.vehicle());
    check_limits(vehicle_.limits);
    const double curvature = problem.curvatures().start;
    const SpeedProfile profile =
        speed_profile(path, with_reserve(vehicle_, options.reserve), speed_options(problem, path));
    result_.planned_duration = profile.duration;
    real_ = {to_local(*problem.world(), path.start), problem.hitch_angles().start};
    strokes_ = strokes_of({real_.pose, path.segments}, profile);
    if (vehicle_.trailer) tow();
    state_.pose = real_.pose;
    state_.hitch_angle = real_.hitch_angle;
    state_.direction = strokes_.front().direction();
    state_.steering_angle = steering_angle(vehicle_, curvature);
    const auto periods = static_cast<std::size_t>(std::ceil(options.delay / control_period - 1e-9));
    under_way_.assign(periods, {.steering_angle = state_.steering_angle,
                                .acceleration = -1.0,
                                .direction = state_.direction});
  }

  DriveResult run();

 private:
  void tow();
  [[nodiscard]] Command decide();
  [[nodiscard]] Command command_at(const MovingState& state, const Offset& offset);
  void execute(const Command& command);
  void correct_estimate();
  void log(const Command& wanted);
  [[nodiscard]] bool has_ended() const;
  void finish();

  /// Planned state after `s` metres of the stroke that is executed.
  [[nodiscard]] State planned(double s) const {
    const Stroke& stroke = strokes_[real_stroke_];
    const double there = std::clamp(s, 0.0, stroke.length());
    return {stroke.at(there).pose, towing_[real_stroke_].hitch_angle_at(there)};
  }
  [[nodiscard]] Pose in_scenario(const Pose& pose) const {
    return {pose.x + origin_.x, pose.y + origin_.y, pose.heading};
  }
  /// Place of the path beside the vehicle [m].
  [[nodiscard]] double place_on_path() const {
    const Stroke& stroke = strokes_[real_stroke_];
    return stroke.begin() + std::clamp(offset_.place.s, 0.0, stroke.length());
  }

  const Controller& controller_;
  const DriveOptions& options_;
  Vehicle vehicle_;
  Point origin_;
  Rng rng_;
  ActuatorError error_;
  Watch watch_;
  Errors errors_;
  std::vector<Stroke> strokes_;
  std::vector<Towing> towing_;     // trailer along each stroke; empty without a trailer
  std::deque<Command> under_way_;  // commands that are decided, but not yet executed

  MovingState state_;  // state with estimated pose and hitch angle
  State real_;         // true pose and hitch angle
  double t_ = 0.0;

  std::size_t stroke_ = 0;  // index of the stroke for which commands are decided
  double guess_ = 0.0;      // place on that stroke for which a command was last decided [m]
  double behind_ = 0.0;     // distance before that stroke at which the vehicle stood [m]
  bool is_driving_ = false;
  bool is_done_ = false;

  std::size_t real_stroke_ = 0;  // index of the stroke that is executed
  Offset offset_;                // offset of the true pose from the executed stroke
  DriveResult result_;
};

/// Computes the planned hitch angles along all strokes.
void Drive::tow() {
  double hitch_angle = real_.hitch_angle;
  for (const Stroke& stroke : strokes_) {
    towing_.emplace_back(stroke, vehicle_, hitch_angle);
    hitch_angle = towing_.back().hitch_angle_at(stroke.length());
  }
}

/// Next command, for the predicted state at the time when the command takes effect.
Command Drive::decide() {
  MovingState state = state_;
  for (const Command& command : under_way_) state = after_period(state, command, vehicle_);
  while (!is_done_) {
    const Stroke& stroke = strokes_[stroke_];
    const double first = steering_angle(vehicle_, stroke.first_curvature());
    // 1. Before a stroke the vehicle stands until its wheels are turned.
    if (!is_driving_) {
      const double most = largest_steering_angle(vehicle_);
      const double wanted = std::clamp(first, -most, most);
      if (state.v > 0.0 || std::abs(state.steering_angle - wanted) > turned_enough) {
        return {wanted, -1.0, stroke.direction(), stroke_};
      }
      is_driving_ = true;
      guess_ = 0.0;
    }
    // 2. On the stroke the controller decides.
    const Offset offset = stroke.offset_of(state.pose, guess_);
    guess_ = offset.place.s;
    if (state.v == 0.0) behind_ = std::max(-guess_, 0.0);
    const double enough = std::min(arrived_enough, stroke.length() / 10);
    if (state.v > 0.0 || stroke.length() - guess_ > enough) return command_at(state, offset);
    // 3. At the end of the stroke the next one begins.
    is_done_ = stroke_ + 1 == strokes_.size();
    if (is_done_) break;
    is_driving_ = false;
    ++stroke_;
  }
  return {state.steering_angle, -1.0, strokes_[stroke_].direction(), stroke_};
}

Command Drive::command_at(const MovingState& state, const Offset& offset) {
  const Towing* const towing = towing_.empty() ? nullptr : &towing_[stroke_];
  const Sight sight{strokes_[stroke_], vehicle_, state, offset, behind_, towing};
  const double wanted = controller_.steering_angle(sight);
  return {wanted, acceleration(sight, wanted), strokes_[stroke_].direction(), stroke_};
}

void Drive::execute(const Command& command) {
  if (command.stroke != real_stroke_) {
    real_stroke_ = command.stroke;
    offset_ = strokes_[real_stroke_].offset_of(real_.pose, 0.0);
  }
  const Stroke& stroke = strokes_[real_stroke_];
  const double rate = steering_rate(state_, command, vehicle_);
  for (int i = 0; i < steps_per_period; ++i) {
    const Moved moved = step(state_, command, rate, vehicle_);
    t_ += step_duration;
    if (moved.length == 0.0) continue;
    move_on(state_, moved, vehicle_);
    const Segment arc = arc_of(moved, vehicle_, error_);
    const State from = real_;
    real_ = advance(vehicle_, from, arc);
    const double way = std::abs(arc.length);
    offset_ = stroke.offset_of(real_.pose, offset_.place.s + way);
    errors_.add(stroke, offset_, real_.pose, way);
    if (vehicle_.trailer) errors_.add_trailer(planned(offset_.place.s), real_, way);
    if (auto what = watch_.look(from, arc, real_)) {
      result_.contact = Contact{t_, place_on_path(), in_scenario(real_.pose), *std::move(what)};
    }
  }
}

/// Moves the estimated pose a little towards the measured pose.
void Drive::correct_estimate() {
  if (options_.noise == 0.0) return;
  const Pose seen = measured(real_.pose, options_.noise, rng_);
  Pose& pose = state_.pose;
  pose.x += correction * (seen.x - pose.x);
  pose.y += correction * (seen.y - pose.y);
  pose.heading = wrap_angle(pose.heading + correction * wrap_angle(seen.heading - pose.heading));
  if (!vehicle_.trailer) return;
  const double angle = measured_hitch_angle(real_.hitch_angle, options_.noise, rng_);
  state_.hitch_angle =
      wrap_angle(state_.hitch_angle + correction * wrap_angle(angle - state_.hitch_angle));
}

void Drive::log(const Command& wanted) {
  if (!options_.keep_log) return;
  const auto hitch_angle =
      vehicle_.trailer ? std::optional(real_.hitch_angle) : std::optional<double>();
  result_.log.push_back({.t = t_,
                         .s = place_on_path(),
                         .pose = in_scenario(real_.pose),
                         .gear = gear_of(state_.direction),
                         .v = state_.direction * state_.v + 0.0,  // adding 0 avoids -0
                         .steering_angle = state_.steering_angle,
                         .wanted_steering = wanted.steering_angle,
                         .wanted_acceleration = wanted.acceleration,
                         .lateral_error = offset_.lateral,
                         .heading_error = offset_.heading,
                         .hitch_angle = hitch_angle});
}

/// Whether the vehicle stands at the end and no decided command accelerates it.
bool Drive::has_ended() const {
  const auto drives = [](const Command& command) { return command.acceleration > 0.0; };
  return is_done_ && state_.v == 0.0 && std::ranges::none_of(under_way_, drives);
}

DriveResult Drive::run() {
  // A drive that takes longer goes in circles.
  const double most = 3 * result_.planned_duration + 60 + options_.delay;
  if (auto what = watch_.look(real_, Segment{}, real_)) {
    result_.contact = Contact{0.0, 0.0, in_scenario(real_.pose), *std::move(what)};
  }
  offset_ = strokes_.front().offset_of(real_.pose, 0.0);
  while (t_ < most) {
    correct_estimate();
    const Command wanted = decide();
    log(wanted);
    under_way_.push_back(wanted);
    if (has_ended()) break;
    execute(under_way_.front());
    under_way_.pop_front();
  }
  finish();
  return std::move(result_);
}

void Drive::finish() {
  errors_.write_to(result_);
  result_.has_arrived = has_ended();
  result_.duration = t_;
  result_.clearance = watch_.clearance();
  result_.out_of_bounds = watch_.out_of_bounds();
  const Stroke& last = strokes_.back();
  const Pose end = relative(last.end(), real_.pose);
  result_.end_distance = std::sqrt(end.x * end.x + end.y * end.y);
  result_.end_heading = std::abs(end.heading);
  if (!result_.trailer) return;
  const State wanted{last.end(), towing_.back().hitch_angle_at(last.length())};
  const Pose behind = relative(trailer_pose(vehicle_, wanted), trailer_pose(vehicle_, real_));
  result_.trailer->end_distance = std::sqrt(behind.x * behind.x + behind.y * behind.y);
  result_.trailer->end_heading = std::abs(behind.heading);
}

}  // namespace

DriveResult drive(const Problem& problem, const Path& path, const DriveOptions& options) {
  if (problem.world() == nullptr) {
    throw InputError("problem", "is empty, expected one that make_problem returned");
  }
  return Drive(problem, path, options).run();
}

}  // namespace vandplan
