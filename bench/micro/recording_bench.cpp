// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// How many messages a second does a recording take?

#include "vandplan/recording.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "recording/mcap.h"
#include "recording/messages.h"
#include "recording/schemas.h"

namespace vandplan {
namespace {

/// Moments of a drive in a circle, with as many digits as a real one has.
std::vector<DriveMoment> circle(std::size_t count) {
  std::vector<DriveMoment> log(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double t = 0.02 * static_cast<double>(i);
    log[i] = {.t = t,
              .s = 2.5 * t,
              .pose = advance(Pose{1, 2, 0.3}, {1 / 7.3, std::fmod(2.5 * t, 40.0)}),
              .v = 2.5 - 1e-3 * t,
              .steering_angle = 0.5 / (1 + t),
              .wanted_steering = 0.51 / (1 + t),
              .lateral_error = 0.013 / (1 + t)};
  }
  return log;
}

/// Transforms alone, made and packed, without a file.
void transforms(benchmark::State& state) {
  const std::vector<DriveMoment> log = circle(1000);
  const recording::Schema& schema = recording::schemas().transform;
  std::size_t bytes = 0;
  recording::McapWriter writer([&](std::string_view piece) { bytes += piece.size(); }, "bench");
  const std::uint16_t channel = writer.add_channel({"/tf", schema.name, schema.text});
  std::uint64_t time = 0;
  for (auto _ : state) {
    const DriveMoment& moment = log[time % log.size()];
    writer.add_message(channel, time,
                       recording::transform_message(time, {"site", "vehicle", moment.pose}));
    ++time;
  }
  state.SetItemsProcessed(state.iterations());
  state.counters["bytes"] = static_cast<double>(bytes) / static_cast<double>(time);
}

/// A drive of 1000 s among an obstacle that moves, into a file.
void drive_to_file(benchmark::State& state) {
  constexpr std::size_t moments = 50'000;
  constexpr std::int64_t messages = 4;  // of each moment: transform, pose, motion, moving obstacles
  const std::vector<DriveMoment> log = circle(moments);
  Scenario scenario;
  scenario.bounds = {-100, 100, -100, 100};
  scenario.goal = {20, 0, 0};
  scenario.moving = {{.outline = {{-1, -1}, {3, -1}, {3, 1}, {-1, 1}},
                      .trajectory = {{0, {30, -50, 1.57}}, {1000, {30, 50, 1.57}}}}};
  const std::string file =
      std::filesystem::temp_directory_path() / ("vandplan-bench-" + std::to_string(std::rand()));
  for (auto _ : state) {
    record(file, {.scenario = &scenario, .drive = RecordedDrive{log}});
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(moments) * messages);
  state.counters["MB"] = static_cast<double>(std::filesystem::file_size(file)) / 1e6;
  std::filesystem::remove(file);
}

BENCHMARK(transforms);
BENCHMARK(drive_to_file)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace vandplan
