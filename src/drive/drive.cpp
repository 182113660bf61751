// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/drive.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>

#include "base/text.h"
#include "drive/controllers.h"
#include "drive/noise.h"
#include "drive/outline.h"
#include "drive/watch.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

using namespace driving;

constexpr double turned_enough = 1e-4;   // of the wheels, to start a stroke [rad]
constexpr double arrived_enough = 5e-3;  // standing so near to the end of a stroke is arriving [m]
constexpr double correction = 0.1;       // share of a measurement that goes into the estimate

void require(bool holds, const char* where, double value, const std::string& expected) {
  if (holds) return;
  throw InputError(where, "is " + base::shortest_text(value) + ", expected " + expected);
}

const Controller& checked_controller(const DriveOptions& options, const Path& path) {
  require(options.noise >= 0.0 && options.noise <= 10.0, "noise", options.noise, "0 to 10");
  require(options.delay >= 0.0 && options.delay <= 1.0, "delay", options.delay, "0 to 1 s");
  require(options.reserve >= 0.0 && options.reserve <= 0.5, "reserve", options.reserve, "0 to 0.5");
  require(options.spare_steering >= 0.0 && options.spare_steering <= 0.5, "spare_steering",
          options.spare_steering, "0 to 0.5");
  const Controller* const controller = find_controller(options.controller);
  if (controller == nullptr) {
    throw InputError("controller", "\"" + options.controller + "\" is unknown, expected " +
                                       base::joined(controllers(), &ControllerInfo::name));
  }
  if (controller->info.drives_reverse) return *controller;
  double reverse = 0.0;
  for (const Segment& segment : path.segments) reverse += std::max(-segment.length, 0.0);
  if (reverse == 0.0) return *controller;
  throw InputError("controller", options.controller + " drives forward only, the path has " +
                                     base::shortest_text(std::round(reverse * 1e3) / 1e3) +
                                     " m in reverse");
}

/// A little more than the vehicle can is rounding: its wheels turn as far as they do.
void expect_drivable(const Path& path, const Vehicle& vehicle) {
  const double most = (1 + 1e-3) / vehicle.min_turning_radius;
  for (std::size_t i = 0; i < path.segments.size(); ++i) {
    const Segment& segment = path.segments[i];
    for (const double driven : {0.0, std::abs(segment.length)}) {
      const double curvature = curvature_at(segment, driven);
      require(std::abs(curvature) <= most,
              ("segments[" + std::to_string(i) + "].curvature").c_str(), curvature,
              "at most 1 / min_turning_radius, " + base::shortest_text(most));
    }
  }
}

/// The vehicle as its wheels can really be turned.
Vehicle with_spare(Vehicle vehicle, double spare) {
  vehicle.min_turning_radius /= 1 + spare;
  return vehicle;
}

Polygon corners_of(const Footprint& footprint) {
  const std::array<Point, 4> rectangle = corners(footprint, {});
  return {rectangle.begin(), rectangle.end()};
}

/// Sums of what a drive does wrong.
class Errors {
 public:
  explicit Errors(const Vehicle& vehicle)
      : body_(body_outline(vehicle)), wheels_(corners_of(wheel_footprint(vehicle))) {}

  /// Adds a pose at the end of `way` driven metres.
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

  void write_to(DriveResult& result) const {
    result.largest_lateral = largest_lateral_;
    result.largest_heading = largest_heading_;
    result.rms_lateral = way_ > 0.0 ? std::sqrt(lateral_squares_ / way_) : 0.0;
    result.rms_heading = way_ > 0.0 ? std::sqrt(heading_squares_ / way_) : 0.0;
    result.outline_deviation = outline_;
  }

 private:
  Polygon body_;
  Polygon wheels_;
  double largest_lateral_ = 0.0;
  double largest_heading_ = 0.0;
  double lateral_squares_ = 0.0;
  double heading_squares_ = 0.0;
  double outline_ = 0.0;
  double way_ = 0.0;
};

/// One drive, in the frame of the world.
class Drive {
 public:
  Drive(const Problem& problem, const Path& path, const DriveOptions& options)
      : controller_(checked_controller(options, path)),
        options_(options),
        vehicle_(with_spare(problem.vehicle(), options.spare_steering)),
        origin_(problem.world()->origin()),
        rng_(options.seed),
        error_(actuator_error(options.noise, rng_)),
        watch_(problem),
        errors_(vehicle_) {
    expect_drivable(path, problem.vehicle());
    check_limits(vehicle_.limits);
    const double curvature = problem.curvatures().start;
    const SpeedProfile profile = speed_profile(path, with_reserve(vehicle_, options.reserve),
                                               {.start_curvature = curvature});
    result_.planned_duration = profile.duration;
    pose_ = to_local(*problem.world(), path.start);
    strokes_ = strokes_of({pose_, path.segments}, profile);
    state_.pose = pose_;
    state_.direction = strokes_.front().direction();
    state_.steering_angle = steering_angle(vehicle_, curvature);
    const auto periods = static_cast<std::size_t>(std::ceil(options.delay / control_period - 1e-9));
    under_way_.assign(periods, {.steering_angle = state_.steering_angle,
                                .acceleration = -1.0,
                                .direction = state_.direction});
  }

  DriveResult run();

 private:
  [[nodiscard]] Command decide();
  [[nodiscard]] Command command_at(const State& state, const Offset& offset);
  void execute(const Command& command);
  void correct_estimate();
  void log(const Command& wanted);
  [[nodiscard]] bool has_ended() const;
  void finish();

  [[nodiscard]] Pose in_scenario(const Pose& pose) const {
    return {pose.x + origin_.x, pose.y + origin_.y, pose.heading};
  }
  /// Beside which the vehicle is [m].
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
  std::deque<Command> under_way_;  // that are decided, and not yet executed

  State state_;  // with the pose that the vehicle believes to have
  Pose pose_;    // the true one
  double t_ = 0.0;

  std::size_t stroke_ = 0;  // that is decided about
  double guess_ = 0.0;      // where the decisions are on it [m]
  double behind_ = 0.0;     // so far before it the vehicle stood [m]
  bool is_driving_ = false;
  bool is_done_ = false;

  std::size_t real_stroke_ = 0;  // that is executed
  Offset offset_;                // of the true pose from it
  DriveResult result_;
};

/// What to do next: as things will be when that takes effect.
Command Drive::decide() {
  State state = state_;
  for (const Command& command : under_way_) state = after_period(state, command, vehicle_);
  while (!is_done_) {
    const Stroke& stroke = strokes_[stroke_];
    const double first = steering_angle(vehicle_, stroke.first_curvature());
    // 1. Before a stroke: stand until the wheels are turned.
    if (!is_driving_) {
      const double most = largest_steering_angle(vehicle_);
      const double wanted = std::clamp(first, -most, most);
      if (state.v > 0.0 || std::abs(state.steering_angle - wanted) > turned_enough) {
        return {wanted, -1.0, stroke.direction(), stroke_};
      }
      is_driving_ = true;
      guess_ = 0.0;
    }
    // 2. On it: go on.
    const Offset offset = stroke.offset_of(state.pose, guess_);
    guess_ = offset.place.s;
    if (state.v == 0.0) behind_ = std::max(-guess_, 0.0);
    const double enough = std::min(arrived_enough, stroke.length() / 10);
    if (state.v > 0.0 || stroke.length() - guess_ > enough) return command_at(state, offset);
    // 3. At its end: the next one.
    is_done_ = stroke_ + 1 == strokes_.size();
    if (is_done_) break;
    is_driving_ = false;
    ++stroke_;
  }
  return {state.steering_angle, -1.0, strokes_[stroke_].direction(), stroke_};
}

Command Drive::command_at(const State& state, const Offset& offset) {
  const Sight sight{strokes_[stroke_], vehicle_, state, offset, behind_};
  const double wanted = controller_.steering_angle(sight);
  return {wanted, acceleration(sight, wanted), strokes_[stroke_].direction(), stroke_};
}

void Drive::execute(const Command& command) {
  if (command.stroke != real_stroke_) {
    real_stroke_ = command.stroke;
    offset_ = strokes_[real_stroke_].offset_of(pose_, 0.0);
  }
  const Stroke& stroke = strokes_[real_stroke_];
  const double rate = steering_rate(state_, command, vehicle_);
  for (int i = 0; i < steps_per_period; ++i) {
    const Moved moved = step(state_, command, rate, vehicle_);
    t_ += step_duration;
    if (moved.length == 0.0) continue;
    state_.pose = advance(state_.pose, arc_of(moved, vehicle_));
    const Segment arc = arc_of(moved, vehicle_, error_);
    const Pose from = pose_;
    pose_ = advance(from, arc);
    const double way = std::abs(arc.length);
    offset_ = stroke.offset_of(pose_, offset_.place.s + way);
    errors_.add(stroke, offset_, pose_, way);
    if (auto what = watch_.look(from, arc, pose_)) {
      result_.contact = Contact{t_, place_on_path(), in_scenario(pose_), *std::move(what)};
    }
  }
}

/// Where the vehicle believes to be goes a little towards where it is measured to be.
void Drive::correct_estimate() {
  if (options_.noise == 0.0) return;
  const Pose seen = measured(pose_, options_.noise, rng_);
  Pose& pose = state_.pose;
  pose.x += correction * (seen.x - pose.x);
  pose.y += correction * (seen.y - pose.y);
  pose.heading = wrap_angle(pose.heading + correction * wrap_angle(seen.heading - pose.heading));
}

void Drive::log(const Command& wanted) {
  if (!options_.keep_log) return;
  result_.log.push_back({.t = t_,
                         .s = place_on_path(),
                         .pose = in_scenario(pose_),
                         .direction = state_.direction,
                         .v = state_.direction * state_.v + 0.0,  // no -0
                         .steering_angle = state_.steering_angle,
                         .wanted_steering = wanted.steering_angle,
                         .wanted_acceleration = wanted.acceleration,
                         .lateral_error = offset_.lateral,
                         .heading_error = offset_.heading});
}

/// Whether the vehicle stands and nothing is decided that would change that.
bool Drive::has_ended() const {
  const auto drives = [](const Command& command) { return command.acceleration > 0.0; };
  return is_done_ && state_.v == 0.0 && std::ranges::none_of(under_way_, drives);
}

DriveResult Drive::run() {
  // Whoever takes so long goes in circles.
  const double most = 3 * result_.planned_duration + 60 + options_.delay;
  if (auto what = watch_.look(pose_, Segment{}, pose_)) {
    result_.contact = Contact{0.0, 0.0, in_scenario(pose_), *std::move(what)};
  }
  offset_ = strokes_.front().offset_of(pose_, 0.0);
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
  const Pose end = relative(strokes_.back().end(), pose_);
  result_.end_distance = std::sqrt(end.x * end.x + end.y * end.y);
  result_.end_heading = std::abs(end.heading);
}

}  // namespace

DriveResult drive(const Problem& problem, const Path& path, const DriveOptions& options) {
  return Drive(problem, path, options).run();
}

}  // namespace vandplan
