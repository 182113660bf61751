// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <iterator>
#include <string>

#include "support/shared_files.h"
#include "support/temporary_folder.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

class Tpcap : public testing::Test {
 protected:
  Scenario read(const std::string& text) { return read_tpcap(folder_.put("Case7.csv", text)); }

  std::string message_for(const std::string& text) {
    try {
      (void)read(text);
    } catch (const InputError& error) {
      const std::string message = error.what();
      return message.substr(message.find("Case7.csv"));
    }
    return "no error";
  }

 private:
  TemporaryFolder folder_;
};

// Two obstacles, of three and four corners.
const std::string two_obstacles =
    "1.5,-2,0.25,10,3e0,-1.5,2,3,4,"
    "0,0,1,0,1,1,"
    "5.1234,5,6,5,6,6.25,5,6\n";

TEST_F(Tpcap, ReadsPosesObstaclesAndDrawsBoundsAroundThem) {
  const Scenario scenario = read(two_obstacles);
  EXPECT_EQ(scenario.name, "Case7");
  EXPECT_TRUE(same_lengths(scenario.vehicle, {2.8, 0.96, 0.929, 1.942, 3.005593}));
  EXPECT_EQ(scenario.vehicle.limits.max_speed, (GearSpeeds{2.5, 2.5}));
  EXPECT_EQ(scenario.start, (Pose{1.5, -2, 0.25}));
  EXPECT_EQ(scenario.goal, (Pose{10, 3, -1.5}));
  EXPECT_EQ(scenario.obstacles, (std::vector<Polygon>{{{0, 0}, {1, 0}, {1, 1}},
                                                      {{5.1234, 5}, {6, 5}, {6, 6.25}, {5, 6}}}));
  EXPECT_EQ(scenario.bounds, (Bounds{-20, 30, -22, 26.25}));
}

TEST_F(Tpcap, BlanksAndLinesMaySeparateNumbersToo) {
  std::string text = two_obstacles;
  for (char& c : text) {
    if (c == ',') c = '\n';
  }
  EXPECT_EQ(read(text).obstacles, read(two_obstacles).obstacles);
  EXPECT_TRUE(read("0, 0, 0,\t9, 9, 0, 0\r\n").obstacles.empty());
}

TEST_F(Tpcap, EveryErrorNamesTheValue) {
  EXPECT_EQ(message_for(""), "Case7.csv:1: ends after value 0, expected x of the start");
  EXPECT_EQ(message_for("0,0,0,1,1"),
            "Case7.csv:1: ends after value 5, expected heading of the goal");
  EXPECT_EQ(message_for("0,zero,0"),
            "Case7.csv:1: value 2 (y of the start) is \"zero\", expected a finite number");
  EXPECT_EQ(message_for("0,\n0,\nnan"),
            "Case7.csv:3: value 3 (heading of the start) is \"nan\", expected a finite number");
  EXPECT_EQ(message_for("0,0,0,1,1,0,1.5,0,0"),
            "Case7.csv:1: value 7 (number of obstacles) is \"1.5\", expected a whole number that "
            "the rest of the file has room for");
  EXPECT_EQ(
      message_for("0,0,0,1,1,0,1e9,3"),
      "Case7.csv:1: value 7 (number of obstacles) is \"1000000000\", expected a whole number that "
      "the rest of the file has room for");
  EXPECT_EQ(message_for("0,0,0,1,1,0,1,3,0,0,1,0,1"),
            "Case7.csv:1: ends after value 13, expected corner of obstacle 0");
  EXPECT_EQ(message_for(two_obstacles + "7"),
            "Case7.csv:2: goes on after value 23, expected its end");
  EXPECT_EQ(message_for("0,0,0,1,1,0,1,2,0,0,1,0"),
            "Case7.csv:1: obstacles[0]: has 2 corners, expected at least 3");
}

TEST_F(Tpcap, WritesTheSameScenariosAsThosePublished) {
  const auto files = yaml_files(shared_folder() / "scenarios" / "tpcap");
  if (files.empty()) GTEST_SKIP() << "no shared scenarios beside the repository";
  for (const std::string& file : files) {
    SCOPED_TRACE(file);
    const Scenario expected = read_scenario(file);
    const Pose start = expected.start;
    const Pose goal = expected.goal;
    std::string csv = fmt::format("{},{},{},{},{},{},{}", start.x, start.y, start.heading, goal.x,
                                  goal.y, goal.heading, expected.obstacles.size());
    for (const Polygon& obstacle : expected.obstacles) csv += fmt::format(",{}", obstacle.size());
    for (const Polygon& obstacle : expected.obstacles) {
      for (const Point& corner : obstacle) csv += fmt::format(",{},{}", corner.x, corner.y);
    }
    const Scenario converted = read(csv);
    EXPECT_EQ(converted.vehicle, expected.vehicle);
    EXPECT_EQ(converted.start, expected.start);
    EXPECT_EQ(converted.goal, expected.goal);
    EXPECT_EQ(converted.obstacles, expected.obstacles);
    EXPECT_NEAR(converted.bounds.x_min, expected.bounds.x_min, 1.1e-3);
    EXPECT_NEAR(converted.bounds.x_max, expected.bounds.x_max, 1.1e-3);
    EXPECT_NEAR(converted.bounds.y_min, expected.bounds.y_min, 1.1e-3);
    EXPECT_NEAR(converted.bounds.y_max, expected.bounds.y_max, 1.1e-3);
  }
}

TEST_F(Tpcap, TooManyValuesAreRefused) {
  std::string text = "0,0,0,9,9,0,4000000";
  for (int i = 0; i < 4'000'000; ++i) text += ",3";
  EXPECT_EQ(message_for(text), "Case7.csv:1: has more than 4000000 values, expected no more");
}

}  // namespace
}  // namespace vandplan
