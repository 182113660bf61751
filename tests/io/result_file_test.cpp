// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "support/temporary_folder.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "vandplan/result_file.h"
#include "vandplan/version.h"

namespace vandplan {
namespace {

using Json = nlohmann::ordered_json;

Scenario yard() {
  Scenario scenario;
  scenario.name = "yard";
  scenario.bounds = {-100, 100, -100, 100};
  scenario.start = {0.3, -1.0 / 3, 0.1};
  scenario.goal = {20, 0, 0};
  return scenario;
}

ScenarioFile yard_file() { return {yard()}; }

ScenarioFile row() {
  return {yard(), {{20.0, {20, 0, 0}, {}}, {40.0, {40, 0, 0}, {}}, {60.0, {60, 0, 0}, {}}}};
}

ResultRecord solved(const Scenario& scenario) {
  constexpr double curvature = 1.0 / 7;  // the default vehicle's
  ResultRecord record;
  record.scenario = scenario.name;
  record.planner = "rrt-opt-euc";
  record.options.budget.seed = std::numeric_limits<std::uint64_t>::max();
  PlanResult& result = record.result;
  result.status = PlanStatus::solved;
  result.path = Path{scenario.start, {{curvature, 3.2}, {0, -12.34}, {-curvature, 0.1}, {0.05, 2}}};
  result.cost = 17.65;
  result.iterations = 8123;
  result.counters = {{"nodes", 5000}, {"edge_checks", 12345}};
  result.time_total = 0.5;
  result.anytime = {{0.0031, 61, 375.9}, {0.0102, 190, 17.65}};
  result.check = PathCheck{.valid = true,
                           .length = 17.64,
                           .reverse_length = 12.34,
                           .gear_changes = 2,
                           .clearance = 0.25};
  record.options.planner.set("max_nodes", std::int64_t{700});
  return record;
}

ResultRecord unsolved(const Scenario& scenario) {
  ResultRecord record = solved(scenario);
  record.result.status = PlanStatus::time_limit;
  record.result.path.reset();
  record.result.anytime.clear();
  return record;
}

std::vector<std::string> keys_of(const Json& json) {
  std::vector<std::string> keys;
  for (const auto& item : json.items()) keys.push_back(item.key());
  return keys;
}

using Keys = std::vector<std::string>;

TEST(ResultFile, HoldsTheDocumentedKeysInTheirOrder) {
  const Json json = Json::parse(results_to_json(yard_file(), {solved(yard())}));
  EXPECT_EQ(keys_of(json),
            (Keys{"format", "scenario", "planner", "seed", "status", "length", "cost",
                  "gear_changes", "reverse_length", "clearance", "time", "iterations", "nodes",
                  "counters", "anytime", "path", "options", "build"}));
  EXPECT_EQ(json["format"], "vandplan-result/1");
  EXPECT_EQ(json["scenario"], "yard");
  EXPECT_EQ(json["planner"], "rrt-opt-euc");
  EXPECT_EQ(json["seed"], 18446744073709551615U);
  EXPECT_EQ(json["status"], "solved");
  EXPECT_EQ(json["length"], 3.2 + 12.34 + 0.1 + 2);
  EXPECT_EQ(json["cost"], 17.65);
  EXPECT_EQ(json["gear_changes"], 2);
  EXPECT_EQ(json["time"], (Json{{"total", 0.5}, {"first_solution", 0.0031}}));
  EXPECT_EQ(json["anytime"][1], (Json{{"time", 0.0102}, {"iteration", 190}, {"cost", 17.65}}));
  EXPECT_EQ(json["build"]["version"], build_info().version);
  EXPECT_EQ(json["options"]["max_nodes"], 700);
  EXPECT_EQ(json["options"]["threads"], 1);
  EXPECT_EQ(json["reverse_length"], 12.34);
  EXPECT_EQ(json["clearance"], 0.25);
  EXPECT_EQ(json["nodes"], 5000);
  EXPECT_EQ(json["counters"], (Json{{"nodes", 5000}, {"edge_checks", 12345}}));
}

TEST(ResultFile, SegmentsAreTurnsAtFullSteeringOrCurvatures) {
  const Json json = Json::parse(results_to_json(yard_file(), {solved(yard())}));
  EXPECT_EQ(json["path"]["start"], (Json{{"x", 0.3}, {"y", -1.0 / 3}, {"heading", 0.1}}));
  EXPECT_EQ(json["path"]["segments"], Json::parse(R"([{"turn": "left", "length": 3.2},
      {"turn": "straight", "length": -12.34}, {"turn": "right", "length": 0.1},
      {"curvature": 0.05, "length": 2.0}])"));
}

TEST(ResultFile, ClothoidsSayTheirCurvatureRate) {
  ResultRecord record = solved(yard());
  // The curvature goes from 0 to that of full steering, and back in reverse.
  record.result.path->segments = {{0, 2, 1.0 / 14}, {1.0 / 7, -4, -1.0 / 28}};
  const Json json = Json::parse(results_to_json(yard_file(), {record}));
  const Json& segments = json["path"]["segments"];
  EXPECT_EQ(segments[0], (Json{{"curvature", 0.0}, {"curvature_rate", 1.0 / 14}, {"length", 2.0}}));
  EXPECT_EQ(keys_of(segments[1]), (Keys{"curvature", "curvature_rate", "length"}));
  const Json& poses = json["path"]["poses"];
  EXPECT_EQ(poses[0]["curvature"], 0.0);
  EXPECT_EQ(poses[10]["curvature"], 1.0 / 14);
  EXPECT_EQ(poses[20]["curvature"], 1.0 / 7);
  EXPECT_EQ(poses.back()["curvature"], 0.0);
}

// Long lists are written without the library's values, number by number.
TEST(ResultFile, ALineIsWhatTheLibraryWouldWrite) {
  ResultRecord record = solved(yard());
  record.result.path->segments.push_back({1e-7, 1e3});
  record.result.tree = TreeSnapshot{{{0, -0.0, 1}, {1e20, 1.0 / 3, -1e-9}}, {-1, 0}};
  const Problem problem = make_problem(yard());
  const std::string line = result_to_json_line(7, problem, record);
  EXPECT_EQ(nlohmann::ordered_json::parse(line).dump() + "\n", line);
  EXPECT_GT(line.size(), 100'000U);  // its poses are in there
}

TEST(ResultFile, PosesFollowThePathAtMostTenCentimetresApart) {
  const ResultRecord record = solved(yard());
  const Json json = Json::parse(results_to_json(yard_file(), {record}));
  const Json& poses = json["path"]["poses"];
  EXPECT_EQ(keys_of(poses[0]), (Keys{"s", "x", "y", "heading", "curvature", "direction"}));
  EXPECT_EQ(poses.front()["x"], 0.3);
  EXPECT_EQ(poses.front()["y"], -1.0 / 3);
  EXPECT_EQ(poses.back()["s"], json["length"]);
  double last = 0.0;
  for (const Json& pose : poses) {
    EXPECT_LE(pose["s"].get<double>() - last, 0.1 + 1e-12);
    last = pose["s"];
    const Pose expected = pose_at(*record.result.path, last);
    EXPECT_NEAR(pose["x"].get<double>(), expected.x, 1e-12);
    EXPECT_NEAR(pose["y"].get<double>(), expected.y, 1e-12);
    EXPECT_NEAR(pose["heading"].get<double>(), expected.heading, 1e-12);
  }
  EXPECT_EQ(poses[1]["curvature"], 1.0 / 7);
  EXPECT_EQ(poses[1]["direction"], 1);
  EXPECT_EQ(poses[40]["direction"], -1);
}

TEST(ResultFile, PosesFarAwayAreAsGoodAsADoubleIs) {
  Scenario far = yard();
  far.start = {4484378811.24645, -354286007.239762, 0.1};
  Scenario near = yard();
  near.start = {far.start.x - 4484378811, far.start.y + 354286007, 0.1};
  const Json far_json = Json::parse(results_to_json({far}, {solved(far)}));
  const Json near_json = Json::parse(results_to_json({near}, {solved(near)}));
  EXPECT_EQ(far_json["path"]["start"]["x"], far.start.x);
  const Json& poses = far_json["path"]["poses"];
  ASSERT_EQ(poses.size(), near_json["path"]["poses"].size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Json& beside = near_json["path"]["poses"][i];
    EXPECT_EQ(poses[i]["x"], beside["x"].get<double>() + 4484378811);
    EXPECT_EQ(poses[i]["y"], beside["y"].get<double>() - 354286007);
    EXPECT_EQ(poses[i]["heading"], beside["heading"]);
  }
}

TEST(ResultFile, TheStartIsWrittenAsTheScenarioWritesIt) {
  Scenario scenario = yard();
  scenario.start.heading = -6.11698657169903;
  ResultRecord record = solved(scenario);
  record.result.path->start = scenario.start;  // as `plan` has it
  const Json json = Json::parse(results_to_json({scenario}, {record}));
  EXPECT_EQ(json["path"]["start"]["heading"], -6.11698657169903);
}

TEST(ResultFile, WithoutAPathThereIsNothingOfAPath) {
  const Json json = Json::parse(results_to_json(yard_file(), {unsolved(yard())}));
  EXPECT_EQ(keys_of(json),
            (Keys{"format", "scenario", "planner", "seed", "status", "time", "iterations", "nodes",
                  "counters", "anytime", "options", "build"}));
  EXPECT_EQ(json["status"], "time_limit");
  EXPECT_EQ(keys_of(json["time"]), Keys{"total"});
  EXPECT_EQ(json["anytime"], Json::array());
}

TEST(ResultFile, APathOfNoLengthIsAPath) {
  ResultRecord record = solved(yard());
  record.result.path->segments.clear();
  const Json json = Json::parse(results_to_json(yard_file(), {record}));
  EXPECT_EQ(json["length"], 0.0);
  EXPECT_EQ(json["path"]["segments"], Json::array());
  EXPECT_EQ(json["path"]["poses"].size(), 1U);
}

TEST(ResultFile, ARowHoldsAResultForEachGoalAndTheFurthestReached) {
  std::vector<ResultRecord> records = {solved(yard()), solved(yard()), unsolved(yard())};
  for (std::size_t i = 0; i < 3; ++i) records[i].distance = row().row[i].distance;
  Json json = Json::parse(results_to_json(row(), records));
  EXPECT_EQ(keys_of(json), (Keys{"format", "scenario", "planner", "seed", "goals", "furthest"}));
  ASSERT_EQ(json["goals"].size(), 3U);
  EXPECT_EQ(json["goals"][1]["distance"], 40);
  EXPECT_EQ(json["goals"][1]["status"], "solved");
  EXPECT_EQ(json["goals"][2]["status"], "time_limit");
  EXPECT_EQ(json["furthest"], 40);
  for (ResultRecord& record : records) record.result.status = PlanStatus::node_limit;
  for (ResultRecord& record : records) record.result.path.reset();
  json = Json::parse(results_to_json(row(), records));
  EXPECT_TRUE(json["furthest"].is_null());
}

TEST(ResultFile, APoseIsALine) {
  const std::string text = results_to_json(yard_file(), {unsolved(yard())});
  EXPECT_EQ(text.substr(0, text.find("\"options\"")), R"({
  "format": "vandplan-result/1",
  "scenario": "yard",
  "planner": "rrt-opt-euc",
  "seed": 18446744073709551615,
  "status": "time_limit",
  "time": {"total": 0.5},
  "iterations": 8123,
  "nodes": 5000,
  "counters": {"nodes": 5000, "edge_checks": 12345},
  "anytime": [],
  )");
  EXPECT_NE(results_to_json(yard_file(), {solved(yard())})
                .find("\n      {\"turn\": \"straight\", \"length\": -12.34},\n"),
            std::string::npos);
}

class ReadResults : public testing::Test {
 protected:
  std::vector<ResultRecord> read(const std::string& text, const ScenarioFile& scenario) {
    return read_results(folder_.put("r.json", text), scenario);
  }

  std::string message_for(const std::string& text, const ScenarioFile& scenario) {
    try {
      (void)read(text, scenario);
    } catch (const InputError& error) {
      const std::string message = error.what();
      return message.substr(message.rfind('/', message.find("r.json")) + 1);
    }
    return "no error";
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(ReadResults, ReadsWhatWasWritten) {
  ResultRecord record = solved(yard());
  record.result.tree = TreeSnapshot{{{0, 0, 0}, {1, 0, 0.5}, {2, 0, 0}}, {-1, 0, -1}};
  const std::vector<ResultRecord> read_back =
      read(results_to_json(yard_file(), {record}), yard_file());
  ASSERT_EQ(read_back.size(), 1U);
  const ResultRecord& copy = read_back[0];
  EXPECT_EQ(copy.scenario, "yard");
  EXPECT_EQ(copy.planner, "rrt-opt-euc");
  EXPECT_EQ(copy.options.budget.seed, record.options.budget.seed);
  EXPECT_EQ(copy.claims.length, length(record.result.path->segments));
  EXPECT_EQ(copy.claims.gear_changes, 2);
  EXPECT_EQ(copy.result.status, PlanStatus::solved);
  EXPECT_EQ(copy.result.path, record.result.path);
  EXPECT_EQ(copy.result.cost, 17.65);
  EXPECT_EQ(copy.result.iterations, 8123);
  EXPECT_EQ(counter(copy.result, "nodes"), 5000);
  EXPECT_EQ(copy.result.time_total, 0.5);
  ASSERT_EQ(copy.result.anytime.size(), 2U);
  EXPECT_EQ(copy.result.anytime[1].iteration, 190);
  ASSERT_TRUE(copy.result.tree);
  EXPECT_EQ(copy.result.tree->poses, record.result.tree->poses);
  EXPECT_EQ(copy.result.tree->parents, record.result.tree->parents);
}

TEST_F(ReadResults, TheReasonOfARunWithoutAPathIsKept) {
  ResultRecord record = unsolved(yard());
  record.result.status = PlanStatus::goal_in_collision;
  record.result.reason = "the footprint hits obstacles[3]";
  const std::string text = results_to_json(yard_file(), {record});
  EXPECT_EQ(Json::parse(text)["reason"], record.result.reason);
  EXPECT_EQ(read(text, yard_file())[0].result.reason, record.result.reason);
}

TEST_F(ReadResults, ReadsARow) {
  std::vector<ResultRecord> records = {solved(yard()), unsolved(yard()), solved(yard())};
  for (std::size_t i = 0; i < 3; ++i) records[i].distance = row().row[i].distance;
  const auto copies = read(results_to_json(row(), records), row());
  ASSERT_EQ(copies.size(), 3U);
  EXPECT_EQ(copies[1].distance, 40);
  EXPECT_EQ(copies[1].result.status, PlanStatus::time_limit);
  EXPECT_FALSE(copies[1].result.path);
  EXPECT_EQ(copies[2].result.path, records[2].result.path);
}

TEST_F(ReadResults, SomebodyElsesFileNeedsOnlyThePath) {
  const auto records = read(R"({"format": "vandplan-result/1", "author": {"name": "me"},
      "path": {"start": {"x": 1, "y": 2, "heading": 3, "v": 0},
               "segments": [{"curvature": 0.1, "length": -2e0}]}})",
                            yard_file());
  ASSERT_EQ(records.size(), 1U);
  EXPECT_EQ(records[0].result.path, (Path{{1, 2, 3}, {{0.1, -2}}}));
  EXPECT_FALSE(records[0].claims.length);
  EXPECT_FALSE(records[0].claims.gear_changes);
}

TEST_F(ReadResults, NumbersAreReadExactly) {
  ResultRecord record = solved(yard());
  record.result.path->segments = {
      {std::nextafter(1.0 / 7, 0), 0.1 + 0.2}, {1e-17, 5e-324}, {1.0 / 7, -0.3, 0.1 + 0.2}};
  const auto copies = read(results_to_json(yard_file(), {record}), yard_file());
  EXPECT_EQ(copies[0].result.path, record.result.path);
}

struct BadResult {
  std::string text;
  std::string message;
};

// A path on line 3, its segments on line 5.
std::string result_with(const std::string& segment) {
  return R"({"format": "vandplan-result/1",
  "status": "solved",
  "path": {
    "start": {"x": 0, "y": 0, "heading": 0},
    "segments": [{"turn": "left", "length": 1},
                 )" +
         segment + "]}}";
}

TEST_F(ReadResults, EveryErrorNamesLineKeyAndWhatWasExpected) {
  const std::string path = R"("path": {"start": {"x": 0, "y": 0, "heading": 0}, "segments": []})";
  const std::string start = "{\"format\": \"vandplan-result/1\"";
  const BadResult bad[] = {
      {"", "r.json:1: is not JSON"},
      {"{\"format\": \"vandplan-result/1\",\n\"status\": solved}", "r.json:2: is not JSON"},
      {start + ",\n\"length\": 1e999}", "r.json:2: is not JSON"},
      {start + ",\n\"length\": NaN}", "r.json:2: is not JSON"},
      {std::string("\0\1\2", 3), "r.json:1: is not JSON"},
      {start + "} x", "r.json:1: is not JSON"},
      {std::string(100'000, '['), "r.json:1: lists and maps are nested too deep"},
      {"[]", "r.json:1: is a list, expected a map of keys"},
      {"{}", "r.json:1: key \"format\" is missing, expected it"},
      {"{\"format\": \"other/2\"}",
       "r.json:1: format: is \"other/2\", expected \"vandplan-result/1\""},
      {"{\"format\": 1,\n\"format\": 2}",
       "r.json:2: key \"format\" is given again, expected it once (first on line 1)"},
      {start + "}", "r.json:1: key \"status\" is missing, expected it"},
      {start + ",\n\"status\": \"done\"}",
       "r.json:2: status: is \"done\", expected one of solved, start_in_collision, "
       "goal_in_collision, iteration_limit, node_limit, time_limit, stopped, no_path, rejected"},
      {start + ",\n\"status\": \"solved\"}", "r.json:1: key \"path\" is missing, expected it"},
      {start + ",\n\"status\": \"stopped\",\n" + path + "}",
       "r.json:3: path: is given though the status is stopped, expected none"},
      {start + ", \"path\": {\n\"segments\": []}}",
       "r.json:1: path: key \"start\" is missing, expected it"},
      {start + ", \"gear_changes\": 4294967296,\n" + path + "}",
       "r.json:1: gear_changes: is 4294967296, expected a count of gear changes"},
      {start + ",\n\"gear_changes\": -1,\n" + path + "}",
       "r.json:2: gear_changes: is \"-1\", expected a whole number, 0 or more"},
      {start + ",\n\"length\":\n2.5e0\n,\"cost\": null,\n" + path + "}",
       "r.json:4: cost: is empty, expected a number"},
      {start + ",\n\"length\":\n\"2\"\n," + path + "}",
       "r.json:3: length: is \"2\", expected a number without quotes"},
      {start + ", \"goals\": [], " + path + "}",
       "r.json:1: goals: is a row, expected the scenario's one goal"},
      {start + ", \"tree\": {\"poses\": [[0, 0, 0], [1, 0, 0]],\n\"parents\": [-1, 1]},\n" + path +
           "}",
       "r.json:2: tree.parents[1]: is 1, expected a node before node 1, or -1"},
      {result_with("{\"turn\": \"left\"}"),
       "r.json:6: path.segments[1]: key \"length\" is missing, expected it"},
      {result_with("{\"turn\": \"left\", \"length\": true}"),
       "r.json:6: path.segments[1].length: is \"true\", expected a number"},
      {result_with("{\"turn\": \"up\", \"length\": 1}"),
       "r.json:6: path.segments[1].turn: is \"up\", expected left, straight or right"},
      {result_with("{\"length\": 1}"),
       "r.json:6: path.segments[1]: has neither, expected either turn or curvature"},
      {result_with("{\"turn\": \"left\", \"curvature\": 0, \"length\": 1}"),
       "r.json:6: path.segments[1]: has both, expected either turn or curvature"},
      {result_with("{\"turn\": \"left\", \"curvature_rate\": 0.1, \"length\": 1}"),
       "r.json:6: path.segments[1].curvature_rate: stands beside turn, expected it beside "
       "curvature"},
      {result_with("{\"curvature\": 0, \"curvature_rate\": \"much\", \"length\": 1}"),
       "r.json:6: path.segments[1].curvature_rate: is \"much\", expected a number"},
      {result_with("{\"curvature\": 0, \"curvature_rate\": 1e999, \"length\": 1}"),
       "r.json:6: is not JSON"},
      {result_with("7"), "r.json:6: path.segments[1]: is \"7\", expected a map of keys"},
  };
  for (const BadResult& one : bad) {
    const std::string message = message_for(one.text, yard_file());
    EXPECT_EQ(message.substr(0, one.message.size()), one.message);
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
  EXPECT_EQ(message_for(start + ",\n\"goals\": []}", row()),
            "r.json:2: goals: has 0 elements, expected the scenario's 3 goals");
  EXPECT_EQ(message_for(start + ",\n" + path + "}", row()),
            "r.json:1: key \"goals\" is missing, expected it");
}

// What no planner could have been given is a mistake of the file.
TEST_F(ReadResults, OptionsOutOfRangeNameTheirLine) {
  const auto message = [&](const std::string& options) {
    return message_for(
        "{\"format\": \"vandplan-result/1\",\n\"options\": {\"seed\": 1,\n" + options +
            "},\n\"path\": {\"start\": {\"x\": 0, \"y\": 0, \"heading\": 0}, \"segments\": []}}",
        yard_file());
  };
  EXPECT_EQ(message("\"margin\": -0.1"),
            "r.json:3: options.margin: -0.1 is not a number from 0 to 1000 [m]");
  EXPECT_EQ(message("\"margin\": 1e300"),
            "r.json:3: options.margin: 1e+300 is not a number from 0 to 1000 [m]");
  EXPECT_EQ(message("\"margin\": 1,\n\"margin_ramp\": -2"),
            "r.json:4: options.margin_ramp: -2 is not a number from 0 to 1000 [m]");
  EXPECT_EQ(message("\"reverse_weight\": 0"),
            "r.json:3: options.reverse_weight: 0 is not a number from 1 to 1000");
  EXPECT_EQ(message("\"gear_change_cost\": -1"),
            "r.json:3: options.gear_change_cost: -1 is not a number from 0 to 10000 [m]");
  EXPECT_EQ(
      message("\"curvature_change_cost\": 10001"),
      "r.json:3: options.curvature_change_cost: 10001 is not a number from 0 to 10000 [m per 1/m]");
  EXPECT_EQ(
      message("\"steering\": \"smooth\""),
      "r.json:3: options.steering: \"smooth\" is not reeds-shepp, continuous-between-stops or "
      "continuous");
  EXPECT_EQ(message("\"margin\": 0.1, \"curvature_change_cost\": 10000"), "no error");
}

// ---- many pairs ----

class ReadPairs : public testing::Test {
 protected:
  static std::string line_of(std::size_t pair, const Pose& goal) {
    Scenario scenario = yard();
    scenario.goal = goal;
    return result_to_json_line(pair, make_problem(scenario), solved(scenario));
  }

  std::string message_for(const std::string& text) {
    try {
      ResultReader reader(folder_.put("r.jsonl", text), file_);
      while (reader.has_pairs() && reader.next()) {
      }
    } catch (const InputError& error) {
      return std::string(error.what()).substr(folder_.path().size() + 1);
    }
    return "no error";
  }

  TemporaryFolder folder_;
  const ScenarioFile file_ = yard_file();
};

TEST_F(ReadPairs, EveryLineHasItsOwnStartAndGoal) {
  const std::string text = "\n" + line_of(1, {20, 0, 0}) + "\n" + line_of(7, {5, 6, 0.5});
  ResultReader reader(folder_.put("r.jsonl", text), file_);
  ASSERT_TRUE(reader.has_pairs());
  const std::optional<PairRecord> first = reader.next();
  ASSERT_TRUE(first);
  EXPECT_EQ(first->pair, 1U);
  EXPECT_EQ(first->poses.start, yard().start);
  EXPECT_EQ(first->record.result.path, solved(yard()).result.path);
  const std::optional<PairRecord> second = reader.next();
  ASSERT_TRUE(second);
  EXPECT_EQ(second->pair, 7U);
  EXPECT_EQ(second->poses.goal, (Pose{5, 6, 0.5}));
  EXPECT_FALSE(reader.next());
}

TEST_F(ReadPairs, AResultOfOneIsNoneOfMany) {
  for (const bool is_compact : {false, true}) {
    const std::string text = results_to_json(file_, {solved(yard())});
    ResultReader reader(folder_.put("r.json", is_compact ? Json::parse(text).dump() : text), file_);
    EXPECT_FALSE(reader.has_pairs());
    EXPECT_EQ(reader.all().size(), 1U);
  }
  const std::string many = folder_.put("r.jsonl", line_of(1, {20, 0, 0}));
  EXPECT_THROW((void)read_results(many, file_), InputError);
}

TEST_F(ReadPairs, MistakesNameTheLineOfTheFile) {
  const std::string good = line_of(1, {20, 0, 0});
  EXPECT_EQ(message_for(good + "\n{\"pair\": 2}\n"),
            "r.jsonl:3: key \"format\" is missing, expected it");
  EXPECT_EQ(message_for(good + "{\"pair\": 2, \"format\": \"vandplan-result/1\"}\n"),
            "r.jsonl:2: key \"start\" is missing, expected it");
  EXPECT_EQ(message_for(good + good + "{\"pair\": \n").substr(0, 23), "r.jsonl:3: is not JSON ");
  std::string far = good;
  far.replace(far.find("\"x\":20.0"), 8, "\"x\":9e6");
  EXPECT_EQ(message_for(good + far).substr(0, 19), "r.jsonl:2: goal: is");
}

// ---- long paths ----

/// A record whose path is a line of so many metres.
ResultRecord straight(double metres) {
  ResultRecord record = solved(yard());
  record.result.path->segments = {{0, metres}};
  return record;
}

TEST(LongResult, ComesInPieces) {
  for (const bool is_line : {false, true}) {
    const ResultRecord record = straight(2000.0);
    std::string whole;
    std::size_t largest = 0;
    const TextSink sink = [&](std::string_view piece) {
      whole += piece;
      largest = std::max(largest, piece.size());
    };
    if (is_line) {
      write_result_line(1, make_problem(yard()), record, sink);
      EXPECT_EQ(whole, result_to_json_line(1, make_problem(yard()), record));
    } else {
      write_results(yard_file(), {record}, sink);
      EXPECT_EQ(whole, results_to_json(yard_file(), {record}));
    }
    EXPECT_EQ(Json::parse(whole)["path"]["poses"].size(), 20'001U);
    EXPECT_GT(whole.size(), 1'000'000U);
    EXPECT_LT(largest, 100'000U);
  }
}

TEST_F(ReadResults, AVeryLongPathStandsWithoutPoses) {
  const std::string text = results_to_json(yard_file(), {straight(200'000.1)});
  const Json json = Json::parse(text);
  EXPECT_EQ(keys_of(json["path"]), (Keys{"start", "segments"}));
  EXPECT_EQ(json["length"], 200'000.1);
  const std::vector<ResultRecord> copies = read(text, yard_file());
  EXPECT_EQ(copies[0].result.path, straight(200'000.1).result.path);
  EXPECT_TRUE(copies[0].claims.poses.empty());
}

TEST(LongResult, ThePosesOfAllGoalsCountTogether) {
  const std::vector<ResultRecord> records(3, straight(66'700.0));
  const Json json = Json::parse(results_to_json(row(), records));
  for (const Json& goal : json["goals"]) EXPECT_FALSE(goal["path"].contains("poses"));
}

TEST_F(ReadResults, PosesAndTreesOfARowFindTheirGoals) {
  std::vector<ResultRecord> records = {straight(1.0), unsolved(yard()), straight(0.25)};
  records[1].result.tree = TreeSnapshot{{{0, 0, 0}, {1, 0, 0.5}}, {-1, 0}};
  records[2].result.tree = TreeSnapshot{{{7, 0, 0}}, {-1}};
  const auto copies = read(results_to_json(row(), records), row());
  EXPECT_EQ(copies[0].claims.poses.size(), 11U);
  EXPECT_EQ(copies[2].claims.poses.size(), 4U);
  EXPECT_EQ(copies[2].claims.poses.back().s, 0.25);
  EXPECT_FALSE(copies[0].result.tree);
  EXPECT_EQ(copies[1].result.tree->parents, records[1].result.tree->parents);
  EXPECT_EQ(copies[2].result.tree->poses, records[2].result.tree->poses);
}

TEST_F(ReadResults, MistakesInLongListsNameTheElement) {
  const auto message = [&](const std::string& before, const std::string& after) {
    std::string text = results_to_json(row(), {straight(1.0), unsolved(yard()), straight(0.25)});
    const std::size_t at = text.rfind(before);
    EXPECT_NE(at, std::string::npos);
    const std::string said = message_for(text.replace(at, before.size(), after), row());
    return said.substr(said.find(' ') + 1);
  };
  EXPECT_EQ(message("\"s\": 0.25, ", ""),
            "goals[2].path.poses[3]: key \"s\" is missing, expected it");
  EXPECT_EQ(message("\"s\": 0.25", "\"s\": \"x\""),
            "goals[2].path.poses[3].s: is \"x\", expected a number without quotes");
  EXPECT_EQ(message("\"direction\": 1", "\"direction\": 2"),
            "goals[2].path.poses[3].direction: is 2, expected 1 or -1");
}

TEST_F(ReadResults, WhatIsInTheWayIsKept) {
  for (const Hit& hit : {Hit{HitKind::obstacle, 3}, Hit{HitKind::kerb, 1}, Hit{HitKind::bounds},
                         Hit{HitKind::inside, 2}, Hit{HitKind::zone, 1}, Hit{HitKind::mask, 0},
                         Hit{HitKind::map, 0, Point{1.25, -0.1}}}) {
    ResultRecord record;
    record.result.status = PlanStatus::goal_in_collision;
    record.result.hit = hit;
    const std::string text = results_to_json(yard_file(), {record});
    EXPECT_EQ(read(text, yard_file()).front().result.hit, hit);
  }
  EXPECT_EQ(message_for(R"({"format": "vandplan-result/1", "status": "goal_in_collision",
"hit": {"what": "walls"}})",
                        yard_file()),
            "r.json:2: hit.what: is \"walls\", expected obstacles, kerbs, map, bounds, inside, "
            "zones or masks");
  EXPECT_THROW((void)results_to_json(yard_file(), {}), InputError);
}

TEST_F(ReadResults, ValuesThatNobodyTakesAreCounted) {
  std::string text = "{\"format\": \"vandplan-result/1\",\n\"junk\": [0";
  for (int i = 0; i < 4'000'000; ++i) text += ",0";
  EXPECT_EQ(message_for(text + "]}", yard_file()),
            "r.json:2: has more than 4000000 values, expected no more");
  text = "{\"format\": \"vandplan-result/1\",\n\"path\": {\"poses\": [{\"junk\": [0";
  for (int i = 0; i < 4'000'000; ++i) text += ",0";
  EXPECT_EQ(message_for(text + "]}]}}", yard_file()),
            "r.json:2: has more than 4000000 values, expected no more");
}

}  // namespace
}  // namespace vandplan
