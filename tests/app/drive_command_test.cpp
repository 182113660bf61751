// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/process.h"
#include "support/yard.h"
#include "vandplan/vehicle.h"

namespace vandplan {
namespace {

using Json = nlohmann::json;

/// The yard with a goal three metres behind the start.
std::string scenario() { return replaced(yard(), "goal: {x: 20, y: 5,", "goal: {x: -3, y: 0,"); }

/// Two metres ahead and five back.
Json result() {
  return Json::parse(R"({"format": "vandplan-result/1", "status": "solved",
    "path": {"start": {"x": 0, "y": 0, "heading": 0},
             "segments": [{"turn": "straight", "length": 2}, {"turn": "straight", "length": -5}]}})");
}

class DriveCommand : public testing::Test {
 protected:
  void SetUp() override {
    write_content(scenario_, scenario());
    write_content(result_, result().dump());
  }

  Outcome drive(const std::vector<std::string>& options = {}) {
    std::vector<std::string> arguments = {"drive", scenario_, result_};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_vandplan(arguments);
  }

  TemporaryFolder folder_;
  const std::string scenario_ = folder_ / "yard.yaml";
  const std::string result_ = folder_ / "result.json";
  const std::string csv_ = folder_ / "log.csv";
  const std::string picture_ = folder_ / "drive.svg";
};

TEST_F(DriveCommand, SaysHowItWent) {
  const Outcome outcome = drive();
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find("yard: rear-axle-feedback: no contact\n"), std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("  deviation: at most 0 m and 0.00 degrees"), std::string::npos);
  EXPECT_NE(outcome.out.find("so a margin of 0.0"), std::string::npos);
  EXPECT_NE(outcome.out.find("  executable: yes\n"), std::string::npos);
}

TEST_F(DriveCommand, SaysThatAPathAtFullLockLeavesNothingToCorrectWith) {
  // Seven metres to the left at the least turning radius, which is seven metres, too.
  const std::string goal = "goal: {x: 5.890296894, y: 3.217883858, heading: 1.0}";
  write_content(scenario_, replaced(yard(), "goal: {x: 20, y: 5, heading: 0}", goal));
  Json turn = result();
  turn["path"]["segments"] = {{{"turn", "left"}, {"length", 7}}};
  write_content(result_, turn.dump());
  const std::string line =
      "  steering: full lock for 7.000 m, where no controller can correct; try --spare-steering "
      "0.1\n";
  const Outcome locked = drive();
  EXPECT_NE(locked.out.find(line), std::string::npos) << locked.out << locked.err;
  EXPECT_NE(locked.out.find("without noise, but a controller lacks spare steering\n"),
            std::string::npos);
  EXPECT_EQ(drive({"--spare-steering", "0.1"}).out.find("  steering:"), std::string::npos);
  EXPECT_EQ(Json::parse(drive({"--json"}).out).at("full_lock"), 7);
}

TEST_F(DriveCommand, WritesALog) {
  EXPECT_EQ(drive({"--output", csv_}).status, 0);
  std::istringstream stream(content_of(csv_));
  std::string line;
  std::getline(stream, line);
  EXPECT_EQ(line,
            "t,s,x,y,heading,direction,v,steering_angle,wanted_steering,wanted_acceleration,"
            "lateral_error,heading_error");
  std::string last;
  int rows = 0;
  for (; std::getline(stream, line); ++rows) last = line;
  EXPECT_GT(rows, 300);
  std::istringstream cells(last);
  std::vector<double> row;
  for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
  ASSERT_EQ(row.size(), 12U);
  EXPECT_NEAR(row[0], (rows - 1) * 0.02, 1e-9);
  EXPECT_NEAR(row[1], 7, 1e-3);
  EXPECT_NEAR(row[2], -3, 1e-3);
  EXPECT_EQ(row[5], -1);
  EXPECT_EQ(row[6], 0);
  EXPECT_EQ(drive({"--output", "-"}).out, content_of(csv_));
  EXPECT_EQ(drive({"--output", "-", "--json"}).status, 2);
}

TEST_F(DriveCommand, DrawsPlanAndDrive) {
  EXPECT_EQ(drive({"--draw", picture_, "--noise", "3"}).status, 0);
  const std::string svg = content_of(picture_);
  EXPECT_NE(svg.find("<svg"), std::string::npos);
  EXPECT_GT(svg.size(), 10000U);
}

TEST_F(DriveCommand, JsonHoldsAllOfManyRuns) {
  const Outcome outcome = drive({"--runs", "5", "--noise", "1", "--delay", "0.1", "--seed", "7",
                                 "--controller", "lqr", "--json"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json.at("runs"), 5);
  EXPECT_EQ(json.at("arrived"), 5);
  EXPECT_EQ(json.at("contacts"), 0);
  EXPECT_EQ(json.at("contact_rate").at("low"), 0);
  // Wilson's interval of 0 out of 5: z^2 / (n + z^2).
  EXPECT_NEAR(json.at("contact_rate").at("high").get<double>(), 3.8415 / 8.8415, 1e-4);
  EXPECT_EQ(json.at("controller"), "lqr");
  EXPECT_GT(json.at("outline_deviation").get<double>(), 0.005);
  EXPECT_LE(json.at("rms_lateral"), json.at("largest_lateral"));
  EXPECT_TRUE(json.at("executable").at("flowing").at("passes").get<bool>());
  EXPECT_FALSE(json.contains("first_contact"));
  // The runs have the seeds from 7 on.
  double largest = 0;
  for (const char* seed : {"7", "8", "9", "10", "11"}) {
    const Outcome one =
        drive({"--noise", "1", "--delay", "0.1", "--seed", seed, "--controller", "lqr", "--json"});
    largest = std::max(largest, Json::parse(one.out).at("outline_deviation").get<double>());
  }
  EXPECT_EQ(json.at("outline_deviation"), largest);
}

// The trailer begins at an angle that two metres ahead and five back make larger.
TEST_F(DriveCommand, ATrailerIsDrivenToo) {
  std::string rig = replaced(
      scenario(), "min_turning_radius: 7.0}",
      "min_turning_radius: 7.0, hitch: 0.3, trailers: [{wheelbase: 8.1, front_overhang: 1.2, "
      "rear_overhang: 4.3, width: 2.55}]}");
  rig = replaced(rig, "start: {x: 0, y: 0, heading: 0}",
                 "start: {x: 0, y: 0, heading: 0, hitch_angles: [0.1]}");
  Vehicle vehicle;
  vehicle.hitch = 0.3;
  vehicle.trailer = Trailer{.wheelbase = 8.1};
  const double angle = hitch_angle_after(vehicle, 0.1, {0, -3});
  write_content(scenario_, replaced(rig, "goal: {x: -3, y: 0, heading: 0}",
                                    "goal: {x: -3, y: 0, heading: 0, hitch_angles: [" +
                                        std::to_string(angle) + "]}"));
  const Outcome said = drive();
  EXPECT_EQ(said.status, 0) << said.err << said.out;
  EXPECT_NE(said.out.find("yard: lqr: no contact\n"), std::string::npos) << said.out;
  EXPECT_NE(said.out.find("  trailer: deviation at most "), std::string::npos) << said.out;
  const Json json = Json::parse(drive({"--noise", "1", "--runs", "3", "--json"}).out);
  EXPECT_EQ(json.at("controller"), "lqr");
  EXPECT_GT(json.at("trailer").at("largest_lateral"), json.at("trailer").at("rms_lateral"));
  EXPECT_LT(json.at("trailer").at("largest_lateral").get<double>(), 0.1);
  EXPECT_GT(json.at("trailer").at("hitch_deviation").get<double>(), 0);
  const std::string log = drive({"--output", "-"}).out;
  EXPECT_NE(log.find("heading_error,hitch_angle\n"), std::string::npos);
  EXPECT_NEAR(std::stod(log.substr(log.rfind(',') + 1)), angle, 1e-4);
  EXPECT_EQ(drive({"--controller", "stanley"}).status, 2);
}

TEST_F(DriveCommand, AContactFailsAndIsSaid) {
  // The wall is 2 mm away from the bumper when the vehicle turns back.
  write_content(scenario_, replaced(scenario(), "[12, -9], [13, -9], [13, 9], [12, 9]",
                                    "[7.902, -9], [13, -9], [13, 9], [7.902, 9]"));
  EXPECT_EQ(drive().status, 0);
  const std::vector<std::string> noisy = {"--noise", "2", "--runs", "20", "--json"};
  const Outcome outcome = drive(noisy);
  EXPECT_EQ(outcome.status, 1);
  const Json json = Json::parse(outcome.out);
  EXPECT_GT(json.at("contacts"), 2);
  EXPECT_LT(json.at("contacts"), 20);
  const Json& contact = json.at("first_contact");
  EXPECT_EQ(contact.at("what"), "the footprint hits obstacles[0]");
  EXPECT_NEAR(contact.at("pose").at("x").get<double>(), 2.002, 0.02);
  EXPECT_EQ(json.at("clearance"), 0);
  const std::string seed = std::to_string(contact.at("seed").get<int>());
  const Outcome again = drive({"--noise", "2", "--seed", seed, "--output", csv_});
  EXPECT_EQ(again.status, 1);
  EXPECT_NE(again.out.find("first contact: after "), std::string::npos) << again.out;
  const std::string verdict =
      "  verdict: the path is too close to obstacles for this drive; plan with ";
  EXPECT_NE(again.out.find(verdict + "--set margin=0.0"), std::string::npos) << again.out;
  EXPECT_EQ(drive().out.find(verdict), std::string::npos);
  EXPECT_NE(content_of(csv_), "");
}

TEST_F(DriveCommand, ThereIsNothingToDriveWithoutAGoodPath) {
  write_content(csv_, "what was there");
  Json wrong = result();
  wrong["path"]["segments"][1]["length"] = -4;
  write_content(result_, wrong.dump());
  const Outcome outcome = drive({"--output", csv_});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.out, "yard: invalid: the path ends 1 m and 0 rad away\n");
  write_content(result_, R"({"format": "vandplan-result/1", "status": "time_limit"})");
  EXPECT_EQ(Json::parse(drive({"--json"}).out).at("reason"), "no path: time_limit");
  EXPECT_EQ(content_of(csv_), "what was there");
}

TEST_F(DriveCommand, SaysWhatItCannotDo) {
  write_content(csv_, "what was there");
  const auto complaint = [&](std::vector<std::string> options) {
    options.insert(options.end(), {"--output", csv_});
    const Outcome outcome = drive(options);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.out, "");
    return outcome.err;
  };
  EXPECT_EQ(complaint({"--controller", "stanley"}),
            "vandplan: --controller: stanley drives forward only, the path has 5 m in reverse\n");
  EXPECT_EQ(complaint({"--controller", "hope"}),
            "vandplan: --controller: \"hope\" is unknown, expected one of rear-axle-feedback, lqr, "
            "pure-pursuit, stanley\n");
  EXPECT_EQ(complaint({"--noise", "11"}), "vandplan: --noise: is 11, expected 0 to 10\n");
  EXPECT_EQ(complaint({"--delay", "-1"}), "vandplan: --delay: is -1, expected 0 to 1 s\n");
  EXPECT_EQ(complaint({"--reserve", "0.6"}), "vandplan: --reserve: is 0.6, expected 0 to 0.5\n");
  EXPECT_EQ(complaint({"--spare-steering", "nan"}),
            "vandplan: --spare-steering: is nan, expected 0 to 0.5\n");
  EXPECT_EQ(complaint({"--runs", "0"}), "vandplan: --runs: is 0, expected 1 to 1000000\n");
  EXPECT_EQ(drive({"--draw", folder_ / "drive.gif"}).status, 2);
  EXPECT_EQ(drive({"--output", folder_ / "log.json"}).status, 2);
  EXPECT_EQ(drive({"--output", folder_ / "none/log.csv"}).status, 2);
  EXPECT_EQ(content_of(csv_), "what was there");
}

TEST_F(DriveCommand, JumpsAndClothoidsAreDriven) {
  // A jump into an arc, and out of it on a clothoid.
  Json turn = result();
  turn["path"]["segments"] =
      Json::parse(R"([{"turn": "straight", "length": 3}, {"turn": "left", "length": 3}])");
  write_content(result_, turn.dump());
  const double angle = 3.0 / 7;
  const double x = 3 + 7 * std::sin(angle);
  const double y = 7 * (1 - std::cos(angle));
  std::ostringstream goal;
  goal.precision(17);
  goal << "goal: {x: " << x << ", y: " << y << ", heading: " << angle;
  write_content(scenario_, replaced(scenario(), "goal: {x: -3, y: 0, heading: 0", goal.str()));
  const Outcome outcome = drive();
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("with pauses at 1 jump of the curvature: yes"), std::string::npos)
      << outcome.out;
}

class ReplanCommand : public DriveCommand {
 protected:
  Outcome replan(const std::vector<std::string>& options = {}) {
    std::vector<std::string> arguments = {"drive", scenario_, "--replan", "0.1"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_vandplan(arguments);
  }
};

TEST_F(ReplanCommand, DrivesWithoutAResult) {
  const Outcome outcome = replan({"--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json.at("arrived"), 1);
  EXPECT_EQ(json.at("contacts"), 0);
  EXPECT_EQ(json.at("ticks_without_answer"), 0);
  EXPECT_GT(json.at("ticks"), 20);
  EXPECT_LT(json.at("end_distance"), 0.03);
}

TEST_F(ReplanCommand, WritesLogActionsAndAPictureThatPlays) {
  const std::string actions = folder_ / "actions.csv";
  EXPECT_EQ(replan({"-o", csv_, "--actions", actions, "--rate", "10", "--draw", picture_}).status,
            0);
  EXPECT_EQ(content_of(csv_).find("t,s,x,y,heading,"), 0u);
  EXPECT_EQ(content_of(actions).find("t,steering_angle,v,a\n0,"), 0u);
  EXPECT_NE(content_of(actions).find("\n0.1,"), std::string::npos);
  EXPECT_NE(content_of(picture_).find("<animateTransform"), std::string::npos);
}

TEST_F(ReplanCommand, RefusesWhatIsWrongAndLeavesFilesAlone) {
  write_content(csv_, "mine");
  EXPECT_EQ(replan({"--prediction", "crystal-ball", "-o", csv_}).status, 2);
  const Outcome odd = run_vandplan({"drive", scenario_, "--replan", "0.03", "-o", csv_});
  EXPECT_EQ(odd.status, 2);
  EXPECT_NE(odd.err.find("--replan: is 0.03, expected a multiple of 0.02 s"), std::string::npos)
      << odd.err;
  const Outcome none = run_vandplan({"drive", scenario_, "-o", csv_});
  EXPECT_EQ(none.status, 2);
  EXPECT_NE(none.err.find("RESULT: is not given"), std::string::npos) << none.err;
  const Outcome rate = replan({"--rate", "10", "-o", csv_});
  EXPECT_EQ(rate.status, 2);
  EXPECT_NE(rate.err.find("--rate requires --actions"), std::string::npos) << rate.err;
  EXPECT_EQ(content_of(csv_), "mine");
}

TEST_F(ReplanCommand, PlansWithATableOfTheSite) {
  write_content(scenario_, yard());
  const std::vector<std::string> few = {"--site", "--set", "max_iterations=1", "--json"};
  for (const std::vector<std::string>& sensor :
       {std::vector<std::string>{}, std::vector<std::string>{"--sensor-range", "12"}}) {
    std::vector<std::string> options = few;
    options.insert(options.end(), sensor.begin(), sensor.end());
    const Outcome outcome = replan(options);
    ASSERT_EQ(outcome.status, 0) << outcome.out << outcome.err;
    EXPECT_EQ(Json::parse(outcome.out).at("ticks_without_goal"), 0) << outcome.out;
  }
  const Outcome without = replan({"--set", "max_iterations=1", "--json"});
  EXPECT_GT(Json::parse(without.out).at("ticks_without_goal"), 0) << without.out;
}

TEST_F(ReplanCommand, SaysWhyThereIsNoTableOfTheSite) {
  const Outcome timed = replan({"--site", "--set", "cost=time"});
  EXPECT_EQ(timed.status, 2);
  EXPECT_EQ(timed.err.find("vandplan: --site: cost: "), 0u) << timed.err;
  const Outcome alone = run_vandplan({"drive", scenario_, "--site"});
  EXPECT_EQ(alone.status, 2);
  EXPECT_NE(alone.err.find("--site requires --replan"), std::string::npos) << alone.err;
}

/// A street for a semitrailer, with a box on its way.
constexpr const char* street_of_rig = R"(name: street
vehicle: tractor-semitrailer
bounds: {x: [-40, 80], y: [-25, 25]}
start: {x: 0, y: 0, heading: 0, hitch_angles: [0.2]}
goal: {x: 60, y: 0, heading: 0}
obstacles: [[[35, -3], [37, -3], [37, 3], [35, 3]]]
)";

TEST_F(ReplanCommand, DrivesARig) {
  write_content(scenario_, street_of_rig);
  const Outcome outcome = replan({"--sensor-range", "30", "--set", "margin=0.3", "--set",
                                  "max_iterations=1500", "--spare-steering", "0.1", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json.at("arrived"), 1);
  EXPECT_EQ(json.at("contacts"), 0);
  EXPECT_EQ(json.at("ticks_without_answer"), 0);
  EXPECT_GE(json.at("route_changes"), 1);
}

TEST_F(ReplanCommand, WritesTheHitchAnglesOfARig) {
  write_content(scenario_, replaced(street_of_rig, "x: 60", "x: 15"));
  const Outcome outcome =
      replan({"--set", "max_iterations=500", "-o", csv_, "--draw", picture_, "--seed", "2"});
  ASSERT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  const std::string log = content_of(csv_);
  EXPECT_NE(log.find(",heading_error,hitch_angle\n"), std::string::npos) << log.substr(0, 200);
  const std::string first = log.substr(log.find('\n') + 1);
  EXPECT_EQ(first.substr(0, first.find('\n')).rfind(",0.2"), first.find('\n') - 4) << first;
  EXPECT_NE(content_of(picture_).find("<animateTransform"), std::string::npos);
}

TEST_F(ReplanCommand, SaysWhatIsWrongWithARig) {
  const auto error_of = [&](const std::string& from, const std::string& to,
                            const std::vector<std::string>& options = {}) {
    write_content(scenario_, replaced(street_of_rig, from, to));
    const Outcome outcome = replan(options);
    EXPECT_EQ(outcome.status, 2) << outcome.out;
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
    return outcome.err;
  };
  const std::string folded = error_of("[0.2]", "[1.3]");
  EXPECT_NE(
      folded.find("yard.yaml:4: start.hitch_angles: has 1.3, expected at most max_hitch_angle"),
      std::string::npos)
      << folded;
  const std::string jerk =
      error_of("vehicle: tractor-semitrailer",
               "vehicle: {wheelbase: 3.6, front_overhang: 1.4, rear_overhang: 0.9, width: 2.55, "
               "min_turning_radius: 5.9, max_jerk: 1, hitch: 0.6, max_hitch_angle: 1.2, trailers: "
               "[{wheelbase: 7.7, front_overhang: 1.6, rear_overhang: 4.3, width: 2.55}]}");
  EXPECT_NE(jerk.find("vehicle.max_jerk"), std::string::npos) << jerk;
  const std::string stanley = error_of("name: street", "name: road", {"--controller", "stanley"});
  EXPECT_NE(stanley.find("--controller: stanley drives a trailer forward only"), std::string::npos)
      << stanley;
}

TEST_F(ReplanCommand, ComparesScenarios) {
  const Outcome outcome =
      run_vandplan({"evaluate", "--replan", "0.1", "--scenarios", scenario_, "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json.at("scenario"), "yard");
  EXPECT_DOUBLE_EQ(json.at("duration_ratio"), 1.0);
  EXPECT_DOUBLE_EQ(json.at("route_changes_per_minute"), 0.0);
}

}  // namespace
}  // namespace vandplan
