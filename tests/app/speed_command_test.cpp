// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/process.h"
#include "support/yard.h"

namespace vandplan {
namespace {

using Json = nlohmann::json;

constexpr const char* columns = "t,s,x,y,heading,curvature,steering_angle,direction,v,a";

/// The yard with a goal three metres behind the start, and the limits of a file that has them all.
std::string speed_scenario() {
  const std::string limits =
      "min_turning_radius: 7.0, max_steering_rate: 0.5, max_curvature_rate: 0.1, "
      "max_speed: {forward: 2, reverse: 1}, max_acceleration: 1, max_braking: 2, "
      "max_lateral_acceleration: 1.5}";
  return replaced(replaced(yard(), "min_turning_radius: 7.0}", limits), "goal: {x: 20, y: 5,",
                  "goal: {x: -3, y: 0,");
}

/// Two metres ahead and five back.
Json speed_result() {
  return Json::parse(R"({"format": "vandplan-result/1", "status": "solved",
    "path": {"start": {"x": 0, "y": 0, "heading": 0},
             "segments": [{"turn": "straight", "length": 2}, {"turn": "straight", "length": -5}]}})");
}

class SpeedCommand : public testing::Test {
 protected:
  void SetUp() override {
    write_content(scenario_, speed_scenario());
    write_content(result_, speed_result().dump());
  }

  Outcome speed(const std::vector<std::string>& options = {}) {
    std::vector<std::string> arguments = {"speed", scenario_, result_};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_vandplan(arguments);
  }

  [[nodiscard]] std::vector<std::vector<double>> rows() const { return rows_of(content_of(csv_)); }

  static std::vector<std::vector<double>> rows_of(const std::string& text) {
    std::istringstream stream(text);
    std::string line;
    std::getline(stream, line);
    EXPECT_EQ(line, columns);
    std::vector<std::vector<double>> rows;
    while (std::getline(stream, line)) {
      std::istringstream cells(line);
      std::string cell;
      std::vector<double>& row = rows.emplace_back();
      while (std::getline(cells, cell, ',')) row.push_back(std::stod(cell));
      EXPECT_EQ(row.size(), 10U);
    }
    return rows;
  }

  TemporaryFolder folder_;
  const std::string scenario_ = folder_ / "yard.yaml";
  const std::string result_ = folder_ / "result.json";
  const std::string csv_ = folder_ / "drive.csv";
};

// Ahead: 4/3 m up and 2/3 m down, to sqrt(8/3) m/s. Back: 0.5 m up to 1 m/s, 0.25 m down.
const double ahead = std::sqrt(8.0 / 3) * 1.5;
const double back = 1 + 4.25 + 0.5;

TEST_F(SpeedCommand, WritesTheDrive) {
  const Outcome outcome = speed({"--output", csv_});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const std::vector<std::vector<double>> drive = rows();
  EXPECT_EQ(drive.front()[0], 0);
  EXPECT_NEAR(drive.back()[0], ahead + back, 1e-9);
  EXPECT_NEAR(drive.back()[2], -3, 1e-9);
  EXPECT_EQ(drive.back()[8], 0);
  for (std::size_t i = 1; i < drive.size(); ++i) {
    EXPECT_GT(drive[i][0], drive[i - 1][0]);
    EXPECT_LE(drive[i][0], drive[i - 1][0] + 0.0501);
    EXPECT_EQ(drive[i][7], drive[i][0] < ahead - 1e-9 ? 1 : -1);
    EXPECT_LE(drive[i][8] * drive[i][7], drive[i][7] > 0 ? 2 : 1);
    EXPECT_GE(drive[i][8] * drive[i][7], 0);
  }
  EXPECT_NE(outcome.out.find("yard: 8.199 s for 7.000 m, at most 1.633 m/s, stops 1, standing 0 s"),
            std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("longest stretch: 5.000 m in 5.750 s"), std::string::npos);
  EXPECT_NE(outcome.out.find(" rows written to " + csv_), std::string::npos);
}

TEST_F(SpeedCommand, JsonHoldsTheTotals) {
  const Outcome outcome = speed({"--json"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_NEAR(json.at("duration").get<double>(), ahead + back, 1e-9);
  EXPECT_EQ(json.at("length"), 7);
  EXPECT_EQ(json.at("standing"), 0);
  EXPECT_EQ(json.at("stops").size(), 1U);
  EXPECT_EQ(json.at("stops")[0].at("s"), 2);
  EXPECT_NEAR(json.at("bound_by").at("max_speed").get<double>(), 4.25, 1e-9);
  EXPECT_NEAR(json.at("bound_by").at("braking").get<double>(), ahead / 3 + 0.5, 1e-9);
  double sum = 0;
  for (const Json& time : json.at("bound_by")) sum += time.get<double>();
  EXPECT_NEAR(sum, json.at("duration").get<double>(), 1e-9);
}

TEST_F(SpeedCommand, RowsAreAsDenseAsAskedFor) {
  EXPECT_EQ(speed({"--output", csv_, "--step", "0.01"}).status, 0);
  EXPECT_GT(rows().size(), 820U);
  EXPECT_EQ(speed({"--output", csv_, "--step", "0.1"}).err,
            "vandplan: --step: is 0.1, expected 0.0001 to 0.05 s\n");
  EXPECT_EQ(speed({"--output", csv_, "--step", "0"}).status, 2);
}

TEST_F(SpeedCommand, PrintsTheDriveAlone) {
  const Outcome outcome = speed({"--output", "-"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_GT(rows_of(outcome.out).size(), 160U);
  EXPECT_EQ(speed({"--output", "-", "--json"}).status, 2);
}

TEST_F(SpeedCommand, APathOfRosHoldsEveryRow) {
  ASSERT_EQ(speed({"--output", csv_}).status, 0);
  const std::string file = folder_ / "path.yaml";
  const Outcome outcome = speed({"--output", file, "--frame", "site/map"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const YAML::Node path = YAML::LoadFile(file);
  EXPECT_EQ(path["header"]["frame_id"].as<std::string>(), "site/map");
  EXPECT_EQ(path["header"]["stamp"]["sec"].as<int>(), 0);
  const std::vector<std::vector<double>> drive = rows();
  ASSERT_EQ(path["poses"].size(), drive.size());
  for (std::size_t i = 0; i < drive.size(); ++i) {
    const YAML::Node stamped = path["poses"][i];
    EXPECT_EQ(stamped["header"]["frame_id"].as<std::string>(), "site/map");
    const YAML::Node stamp = stamped["header"]["stamp"];
    EXPECT_LT(stamp["nanosec"].as<int>(), 1'000'000'000);
    EXPECT_NEAR(stamp["sec"].as<int>() + 1e-9 * stamp["nanosec"].as<int>(), drive[i][0], 6e-10);
    EXPECT_EQ(stamped["pose"]["position"]["x"].as<double>(), drive[i][2]);
    EXPECT_EQ(stamped["pose"]["position"]["y"].as<double>(), drive[i][3]);
    const YAML::Node turn = stamped["pose"]["orientation"];
    EXPECT_NEAR(2 * std::atan2(turn["z"].as<double>(), turn["w"].as<double>()), drive[i][4], 1e-12);
    EXPECT_EQ(turn["x"].as<double>(), 0);
  }
  EXPECT_EQ(
      speed({"--output", file, "--frame", "a b"}).err,
      "vandplan: --frame: is \"a b\", expected a letter, then letters, digits, _, -, / or .\n");
}

TEST_F(SpeedCommand, TheWheelsTurnWhileItStands) {
  write_content(scenario_, replaced(speed_scenario(), "goal: {x: -3, y: 0, heading: 0",
                                    "goal: {x: 5.890296893, y: 3.217883863, heading: 1"));
  Json turn = speed_result();
  turn["path"]["segments"] = Json::parse(R"([{"turn": "left", "length": 7}])");
  write_content(result_, turn.dump());
  const Outcome outcome = speed({"--output", csv_});
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  const double angle = std::atan(4.5 / 7);
  double pause = 0;
  for (const std::vector<double>& row : rows()) {
    if (row[1] == 0) pause = row[0];
    EXPECT_NEAR(row[6], std::min(row[0] * 0.5, angle), 1e-12);
    EXPECT_NEAR(row[5], std::tan(row[6]) / 4.5, 1e-12);
  }
  EXPECT_NEAR(pause, angle / 0.5, 1e-12);
}

TEST_F(SpeedCommand, BeforeTheStartTheWheelsAreAsTheScenarioSays) {
  const auto standing_with = [&](const char* start) {
    write_content(scenario_, replaced(speed_scenario(), "start: {x: 0, y: 0, heading: 0}", start));
    return Json::parse(speed({"--json"}).out).at("standing").get<double>();
  };
  EXPECT_EQ(standing_with("start: {x: 0, y: 0, heading: 0}"), 0);
  EXPECT_NEAR(standing_with("start: {x: 0, y: 0, heading: 0, curvature: 0.1}"),
              std::atan(4.5 * 0.1) / 0.5, 1e-12);
}

TEST_F(SpeedCommand, ThereIsNothingToDriveWithoutAGoodPath) {
  write_content(csv_, "what was there");
  Json wrong = speed_result();
  wrong["path"]["segments"][1]["length"] = -4;
  write_content(result_, wrong.dump());
  Outcome outcome = speed({"--output", csv_});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.out, "yard: invalid: the path ends 1 m and 0 rad away\n");
  write_content(result_, R"({"format": "vandplan-result/1", "status": "time_limit"})");
  outcome = speed({"--output", csv_});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.out, "yard: no path: time_limit\n");
  EXPECT_EQ(Json::parse(speed({"--json"}).out).at("reason"), "no path: time_limit");
  EXPECT_EQ(content_of(csv_), "what was there");
}

TEST_F(SpeedCommand, SaysWhatCannotBeWrittenOrRead) {
  EXPECT_EQ(speed({"--output", folder_ / "none/drive.csv"}).status, 2);
  EXPECT_EQ(speed({"--output", folder_ / "drive.json"}).err,
            "vandplan: " + (folder_ / "drive.json") +
                ": ends in .json, but a drive is CSV, or YAML for a nav_msgs/Path, expected a "
                "name that ends in .csv\n");
  write_content(scenario_, replaced(speed_scenario(), "max_braking: 2", "max_braking: 0"));
  EXPECT_EQ(speed().err, "vandplan: " + scenario_ +
                             ":2: vehicle.max_braking: is 0, expected 0.001 to 1000 m/s^2\n");
  write_content(result_, "{");
  EXPECT_EQ(speed().status, 2);
}

TEST_F(SpeedCommand, OfARowTheFurthestGoalWithAPathIsDriven) {
  write_content(scenario_, replaced(speed_scenario(), "goal: {x: -3, y: 0, heading: 0}",
                                    "goals:\n"
                                    "  - {distance: 1, goal: {x: 1, y: 0, heading: 0}}\n"
                                    "  - {distance: 2, goal: {x: -3, y: 0, heading: 0}}\n"
                                    "  - {distance: 3, goal: {x: 3, y: 0, heading: 0}}"));
  Json near = speed_result();
  near["path"]["segments"] = Json::parse(R"([{"turn": "straight", "length": 1}])");
  Json none = Json::parse(R"({"format": "vandplan-result/1", "status": "time_limit"})");
  Json row = {{"format", "vandplan-result/1"}, {"goals", {near, speed_result(), none}}};
  write_content(result_, row.dump());
  EXPECT_EQ(Json::parse(speed({"--json"}).out).at("length"), 7);
  EXPECT_EQ(Json::parse(speed({"--json", "--goal", "0"}).out).at("length"), 1);
  EXPECT_EQ(speed({"--goal", "2"}).out, "yard goals[2]: no path: time_limit\n");
  EXPECT_EQ(speed({"--goal", "3"}).err, "vandplan: --goal: is 3, expected 0 to 2\n");
}

TEST_F(SpeedCommand, OfManyPairsOneIsChosen) {
  Json pair = speed_result();
  pair["pair"] = 4;
  pair["start"] = {{"x", 0}, {"y", 0}, {"heading", 0}};
  pair["goal"] = {{"x", -3}, {"y", 0}, {"heading", 0}};
  write_content(result_, pair.dump() + "\n");
  EXPECT_EQ(Json::parse(speed({"--json", "--pair", "4"}).out).at("length"), 7);
  EXPECT_EQ(speed({"--pair", "5"}).err, "vandplan: --pair: there is no pair 5\n");
  EXPECT_EQ(speed().err, "vandplan: " + result_ + ": holds many results, expected --pair N\n");
}

}  // namespace
}  // namespace vandplan
