// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// --record, and results on a map: --output R.geojson.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "support/mcap_reader.h"
#include "support/process.h"
#include "support/yard.h"

namespace vandplan {
namespace {

using Json = nlohmann::json;

class RecordCommand : public testing::Test {
 protected:
  void SetUp() override { write_content(scenario_, yard()); }

  Outcome run(const std::string& command, std::vector<std::string> options,
              const ProcessOptions& process = {}) {
    options.insert(options.begin(), {command, scenario_});
    return run_vandplan(options, process);
  }
  Outcome plan(std::vector<std::string> options, const ProcessOptions& process = {}) {
    options.insert(options.end(), {"--max-iterations", "300"});
    return run("plan", options, process);
  }
  /// The one line of a call that ends with status 2, without the name of the folder.
  std::string complaint(const Outcome& outcome) {
    EXPECT_EQ(outcome.status, 2) << outcome.out;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    std::string line = outcome.err.substr(0, outcome.err.size() - 1);
    const std::size_t at = line.find(folder_.path());
    if (at != std::string::npos) line.erase(at, folder_.path().size() + 1);
    return line;
  }
  std::set<std::string> topics() {
    std::set<std::string> all;
    for (const McapMessage& message : mcap_messages(content_of(recording_))) {
      all.insert(message.topic);
    }
    return all;
  }

  TemporaryFolder folder_;
  const std::string scenario_ = folder_ / "yard.yaml";
  const std::string result_ = folder_ / "result.json";
  const std::string recording_ = folder_ / "r.mcap";
  const std::string map_ = folder_ / "r.geojson";
};

TEST_F(RecordCommand, PlanRecordsItsRunAndThePlannedDrive) {
  const Outcome outcome = plan({"--record", recording_});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out.substr(0, 13), "yard, anytime");
  const std::set<std::string> all = topics();
  for (const char* const topic : {"/ground", "/improvement", "/path", "/motion", "/log"}) {
    EXPECT_TRUE(all.contains(topic)) << topic;
  }
  EXPECT_FALSE(all.contains("/driven"));
}

TEST_F(RecordCommand, DriveRecordsTheDriveAndItsPlan) {
  EXPECT_EQ(plan({"--output", result_}).status, 0);
  const Outcome outcome = run("drive", {result_, "--record", recording_, "--noise", "1"});
  EXPECT_NE(outcome.status, 2) << outcome.err;
  EXPECT_TRUE(topics().contains("/driven"));
  EXPECT_TRUE(topics().contains("/plan"));
}

TEST_F(RecordCommand, DriveWithReplanningRecordsTheDrive) {
  const Outcome outcome =
      run("drive", {"--replan", "0.5", "--set", "max_iterations=300", "--record", recording_});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(topics().contains("/driven"));
  EXPECT_FALSE(topics().contains("/path"));
}

TEST_F(RecordCommand, WhatCannotBeRecordedIsRefusedBeforeItIsPlanned) {
  EXPECT_EQ(complaint(plan({"--record", "-"})), "vandplan: --record: is -, expected a file");
  EXPECT_EQ(complaint(plan({"--record", folder_ / "r.json"})),
            "vandplan: r.json: ends in .json, but a recording is MCAP, expected a name that ends "
            "in .mcap");
  EXPECT_EQ(complaint(plan({"--record", folder_ / "none/r.mcap"})),
            "vandplan: none/r.mcap: cannot write: No such file or directory");
  EXPECT_EQ(complaint(run("drive", {"--replan", "0.5", "--record", "-"})),
            "vandplan: --record: is -, expected a file");
  write_content(scenario_, replaced(yard(), "goal: {x: 20, y: 5, heading: 0}",
                                    "goals: [{distance: 1, goal: {x: 20, y: 5, heading: 0}}]"));
  EXPECT_EQ(complaint(plan({"--record", recording_})),
            "vandplan: --record: is for one path, the scenario has a row of goals");
}

TEST_F(RecordCommand, AFullDiskLeavesTheOldRecording) {
  write_content(recording_, "old");
  EXPECT_EQ(complaint(plan({"--record", recording_}, {.largest_file = 100})),
            "vandplan: r.mcap: cannot write: File too large");
  EXPECT_EQ(content_of(recording_), "old");
}

TEST_F(RecordCommand, APathIsLaidOverAMap) {
  write_content(scenario_, yard() + "origin: {longitude: 12, latitude: 60}\n");
  const Outcome outcome = plan({"--output", map_});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const Json json = Json::parse(content_of(map_));
  EXPECT_EQ(json.at("type"), "FeatureCollection");
  const Json& path = json.at("features").at(0);
  EXPECT_EQ(path.at("geometry").at("type"), "LineString");
  const Json& line = path.at("geometry").at("coordinates");
  EXPECT_EQ(line.front(), (Json{12, 60}));
  // By the radii of curvature of WGS84 at 60 degrees: 0.001 degrees are 55.8 m and 111.41 m.
  EXPECT_NEAR(line.back().at(0), 12 + 0.001 * 20 / 55.800, 2e-8);
  EXPECT_NEAR(line.back().at(1), 60 + 0.001 * 5 / 111.412, 2e-8);
  const Json& properties = path.at("properties");
  EXPECT_EQ(properties.at("scenario"), "yard");
  EXPECT_EQ(properties.at("status"), "solved");
  EXPECT_GT(properties.at("length"), 20);
  std::vector<std::string> points;
  for (const Json& feature : json.at("features")) {
    if (feature.at("geometry").at("type") == "Point") {
      points.push_back(feature.at("properties").at("what"));
    }
  }
  EXPECT_EQ(points.size(), 2 + properties.at("gear_changes").get<std::size_t>());
  EXPECT_EQ(points.front(), "start");
  EXPECT_EQ(points.back(), "end");
}

TEST_F(RecordCommand, WithoutAPathTheMapHasItsStatus) {
  write_content(scenario_, replaced(yard(), "goal: {x: 20", "goal: {x: 12.5") +
                               "origin: {longitude: 12, latitude: 60}\n");
  EXPECT_EQ(plan({"--output", map_}).status, 1);
  const Json feature = Json::parse(content_of(map_)).at("features").at(0);
  EXPECT_TRUE(feature.at("geometry").is_null());
  EXPECT_EQ(feature.at("properties").at("status"), "goal_in_collision");
}

TEST_F(RecordCommand, AMapNeedsAPlaceOnEarth) {
  const std::string line =
      "vandplan: r.geojson: would be GeoJSON, but the scenario has no place on Earth, expected its "
      "key origin, which `vandplan convert geojson` writes";
  EXPECT_EQ(complaint(plan({"--output", map_})), line);
  EXPECT_EQ(plan({"--output", result_}).status, 0);
  EXPECT_EQ(complaint(run("smooth", {result_, "--output", map_})), line);
  write_content(scenario_, yard() + "origin: {longitude: 12, latitude: 91}\n");
  EXPECT_EQ(complaint(plan({})),
            "vandplan: yard.yaml:8: origin.latitude: is 91, expected -90 to 90 degrees");
}

TEST_F(RecordCommand, ASiteOnEarthIsPlannedAndLaidOverItsMap) {
  const std::string site = folder_ / "site.geojson";
  write_content(site, R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"kind": "start", "heading": 0}, "geometry":
      {"type": "Point", "coordinates": [12.0000012345, 60]}},
    {"type": "Feature", "properties": {"kind": "goal", "heading": 0}, "geometry":
      {"type": "Point", "coordinates": [12.001, 60.0001]}}]})");
  EXPECT_EQ(run_vandplan({"convert", "geojson", site, "--output", scenario_}).status, 0);
  EXPECT_EQ(plan({"--output", map_}).status, 0);
  const Json line =
      Json::parse(content_of(map_)).at("features").at(0).at("geometry").at("coordinates");
  // Places in a scenario are rounded to 0.1 mm.
  EXPECT_NEAR(line.front().at(0), 12.0000012345, 2e-9);
  EXPECT_NEAR(line.back().at(0), 12.001, 2e-9 + 1e-6 / 55800);
  EXPECT_NEAR(line.back().at(1), 60.0001, 2e-9);
}

}  // namespace
}  // namespace vandplan
