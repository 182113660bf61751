// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Which messages does a recording have, and when?
#include "vandplan/recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "recording/mcap.h"
#include "recording/moments.h"
#include "recording/scenes.h"
#include "recording/schemas.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "vandplan/vehicle.h"
#include "vandplan/version.h"

namespace vandplan {
namespace recording {
namespace {

constexpr double path_step = 0.2;             // Largest distance of poses of a path [m].
constexpr double most_poses = 50'000;         // Largest number of poses of a path, about.
constexpr std::int32_t most_map_side = 2048;  // Largest number of cells along a side of a map.
constexpr double grid_of_origins = 1000.0;    // Origins are multiples of this [m].
constexpr double improvement_step = 0.1;      // Time from one improvement to the next [s].

std::uint64_t nanoseconds(double seconds) {
  return static_cast<std::uint64_t>(std::llround(seconds * 1e9));
}

/// A recording while it is written. Values are in the frame "site", times in seconds.
class Recorder {
 public:
  explicit Recorder(FileWriter& file)
      : mcap_([&file](std::string_view piece) { file.write(piece); },
              fmt::format("vandplan {}", build_info().version)) {}

  void scene(std::string_view topic, double t, const SceneChange& change) {
    const std::uint64_t time = nanoseconds(t);
    add(topic, schemas().scene, time, scene_message(time, change));
  }
  void transform(double t, const FramePose& frame) {
    const std::uint64_t time = nanoseconds(t);
    add(fmt::format("/tf/{}", frame.child), schemas().transform, time,
        transform_message(time, frame));
  }
  void poses(std::string_view topic, double t, std::span<const Pose> poses) {
    const std::uint64_t time = nanoseconds(t);
    add(topic, schemas().poses, time, poses_message(time, site_frame, poses));
  }
  void map(const OccupancyGrid& grid) {
    add("/map", schemas().grid, 0, grid_message(0, site_frame, grid, most_map_side));
  }
  void log(double t, Level level, std::string_view text) {
    const std::uint64_t time = nanoseconds(t);
    add("/log", schemas().log, time, log_message(time, level, text));
  }
  void motion(double t, const DriveMoment& moment) {
    const std::uint64_t time = nanoseconds(t);
    add("/motion", schemas().motion, time, motion_message(time, moment));
  }
  void improvement(double t, const CostSample& sample) {
    const std::uint64_t time = nanoseconds(t);
    add("/improvement", schemas().improvement, time, improvement_message(time, sample));
  }
  void end() { mcap_.end(); }

 private:
  void add(std::string_view topic, const Schema& schema, std::uint64_t time,
           const std::string& message) {
    auto channel = channels_.find(topic);
    if (channel == channels_.end()) {
      const std::uint16_t number = mcap_.add_channel({topic, schema.name, schema.text});
      channel = channels_.emplace(topic, number).first;
    }
    mcap_.add_message(channel->second, time, message);
  }

  McapWriter mcap_;
  std::map<std::string, std::uint16_t, std::less<>> channels_;
};

void record_ground(Recorder& recorder, const Scenario& scenario, const std::optional<Hit>& hit) {
  recorder.scene("/ground", 0.0, ground_scene(scenario, hit));
  if (scenario.map) recorder.map(*scenario.map);
  recorder.scene("/vehicle", 0.0, vehicle_scene(scenario.vehicle));
}

void record_path(Recorder& recorder, const Scenario& scenario, const Path& path, double t) {
  const double step = std::max(path_step, length(path) / most_poses);
  const SampledPath points{
      sampled(path, step),
      sampled_hitch_angles(scenario.vehicle, path, scenario.hitch_angles.start, step)};
  std::vector<Pose> poses;
  for (const PathPoint& point : points.points) poses.push_back(point.pose);
  recorder.poses("/path", t, poses);
  recorder.scene("/plan", t, path_scene(scenario.vehicle, points));
}

/// Records where everything is at a moment of a drive that begins at `begin` [s].
void record_moment(Recorder& recorder, const Scenario& scenario, const DriveMoment& moment,
                   double begin) {
  const Vehicle& vehicle = scenario.vehicle;
  const double t = begin + moment.t;
  std::vector<Pose> poses = {moment.pose};
  recorder.transform(t, {site_frame, vehicle_frame, moment.pose});
  if (vehicle.trailer) {
    poses.push_back(trailer_pose(vehicle, {moment.pose, moment.hitch_angle.value_or(0.0)}));
    recorder.transform(t, {site_frame, trailer_frame, poses.back()});
  }
  recorder.poses("/pose", t, poses);
  recorder.motion(t, moment);
  if (scenario.moving.empty()) return;
  recorder.scene("/moving", t, moving_scene(scenario.moving, moment.t));
}

void record_drive(Recorder& recorder, const Scenario& scenario, const RecordedDrive& drive,
                  double begin) {
  const std::vector<Event> events = events_of(drive);
  auto event = events.begin();
  const auto log_until = [&](double t) {
    for (; event != events.end() && event->t <= t; ++event) {
      recorder.log(begin + event->t, event->level, event->text);
    }
  };
  for (const DriveMoment& moment : drive.log) {
    log_until(moment.t);
    record_moment(recorder, scenario, moment, begin);
  }
  log_until(std::numeric_limits<double>::infinity());
}

/// Records how the best path became cheaper while it was planned, and returns when that ends [s].
/// Improvements follow each other evenly: runs with equal improvements have equal times.
double record_run(Recorder& recorder, const Scenario& scenario, const PlanResult& plan) {
  const char* const unit = plan.rule.measure == CostMeasure::time ? "s" : "m";
  recorder.log(0.0, Level::info, "planning begins");
  double t = 0.0;
  for (const CostSample& sample : plan.anytime) {
    t += improvement_step;
    const std::string text = fmt::format("cost {:.2f} {}", sample.cost, unit);
    recorder.log(t, Level::info, fmt::format("{}, iteration {}", text, sample.iteration));
    recorder.scene("/cost", t, label_scene(text, scenario.start));
    recorder.improvement(t, sample);
  }
  t += improvement_step;
  std::string end(name_of(plan.status));
  if (!plan.reason.empty()) end += ": " + plan.reason;
  if (plan.lower_bound) end += fmt::format(", lower bound {:.2f} {}", *plan.lower_bound, unit);
  recorder.log(t, plan.path ? Level::info : Level::error, end);
  return t;
}

/// Records the run of a plan, and the drive along its path as it was planned.
void record_plan(Recorder& recorder, const Scenario& scenario, const PlanResult& plan) {
  const DriveMoment standing{.pose = scenario.start, .hitch_angle = scenario.hitch_angles.start};
  record_moment(recorder, scenario, standing, 0.0);
  const double end = record_run(recorder, scenario, plan);
  if (plan.tree) recorder.scene("/tree", end, tree_scene(*plan.tree));
  if (!plan.path) return;
  record_path(recorder, scenario, *plan.path, end);
  const std::vector<DriveMoment> moments = planned_moments(scenario, plan);
  record_drive(recorder, scenario, {.log = moments}, end);
}

/// Records a drive, and the path that was planned for it if there is one.
void record_simulation(Recorder& recorder, const Scenario& scenario, const PlanResult* plan,
                       const RecordedDrive& drive) {
  if (plan != nullptr && plan->path) record_path(recorder, scenario, *plan->path, 0.0);
  if (plan != nullptr && plan->tree) recorder.scene("/tree", 0.0, tree_scene(*plan->tree));
  recorder.scene("/driven", 0.0, driven_scene(drive.log));
  record_drive(recorder, scenario, drive, 0.0);
}

/// Origin of the frame "site", near the start.
Point origin_of(const Scenario& scenario) {
  const auto near = [](double x) { return std::round(x / grid_of_origins) * grid_of_origins; };
  return {near(scenario.start.x), near(scenario.start.y)};
}

}  // namespace
}  // namespace recording

void record(const std::string& file, const Recording& recording) {
  if (recording.scenario == nullptr) throw InputError("scenario", "is null, expected a scenario");
  check_scenario(*recording.scenario);
  const Point origin = recording::origin_of(*recording.scenario);
  const Scenario scenario = recording::moved_to(*recording.scenario, origin);
  std::optional<PlanResult> plan;
  if (recording.plan != nullptr) plan = recording::moved_to(*recording.plan, origin);
  std::vector<DriveMoment> log;
  if (recording.drive) log = recording::moved_to(recording.drive->log, origin);

  FileWriter writer(file);
  recording::Recorder recorder(writer);
  recorder.transform(0.0, {recording::map_frame, recording::site_frame, {origin.x, origin.y, 0.0}});
  recording::record_ground(recorder, scenario, plan ? plan->hit : std::nullopt);
  if (recording.drive) {
    const RecordedDrive drive{log, recording.drive->has_arrived, recording.drive->contact};
    recording::record_simulation(recorder, scenario, plan ? &*plan : nullptr, drive);
  } else if (plan) {
    recording::record_plan(recorder, scenario, *plan);
  }
  recorder.end();
  writer.commit();
}

}  // namespace vandplan
