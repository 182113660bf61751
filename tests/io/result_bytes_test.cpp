// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Binary results: do they say what JSON says, and is anything else refused?

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "support/temporary_folder.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "vandplan/result_file.h"

namespace vandplan {
namespace {

Scenario quay() {
  Scenario scenario;
  scenario.name = "quay";
  scenario.bounds = {-100, 100, -100, 100};
  scenario.start = {0.3, -1.0 / 3, 0.1};
  scenario.goal = {20, 0, 0};
  return scenario;
}

ResultRecord planned_record(const Scenario& scenario) {
  ResultRecord record{.scenario = scenario.name, .planner = "anytime"};
  record.options.budget.seed = std::numeric_limits<std::uint64_t>::max();
  record.options.cost.gear_change_cost = 5.5;
  record.options.clearance.margin = 0.25;
  PlanResult& result = record.result;
  result.status = PlanStatus::solved;
  result.path = Path{scenario.start, {{1.0 / 7, 3.2}, {0, -12.34}, {0.01, 2, 0.003}}};
  result.cost = 17.65;
  result.lower_bound = 1.0 / 3;
  result.iterations = 8123;
  result.counters = {{"nodes", 5000}};
  result.time_total = 0.5;
  result.anytime = {{0.0031, 61, 375.9}, {0.0102, 190, 17.65}};
  return record;
}

ResultRecord without_path(const Scenario& scenario) {
  ResultRecord record = planned_record(scenario);
  record.result.path.reset();
  record.result.status = PlanStatus::goal_in_collision;
  record.result.reason = "the footprint hits obstacles[3]";
  return record;
}

void expect_same_cost(const std::optional<StatedCost>& a, const std::optional<StatedCost>& b) {
  ASSERT_EQ(a.has_value(), b.has_value());
  if (!a) return;
  EXPECT_EQ(a->cost, b->cost);
  EXPECT_EQ(a->lower_bound, b->lower_bound);
  EXPECT_EQ(a->rule.gear_change_cost, b->rule.gear_change_cost);
  EXPECT_EQ(a->rule.reverse_weight, b->rule.reverse_weight);
}

/// All that both forms state.
void expect_same(const ResultRecord& a, const ResultRecord& b) {
  EXPECT_EQ(a.scenario, b.scenario);
  EXPECT_EQ(a.planner, b.planner);
  EXPECT_EQ(a.distance, b.distance);
  EXPECT_EQ(a.options.budget.seed, b.options.budget.seed);
  EXPECT_EQ(a.result.status, b.result.status);
  EXPECT_EQ(a.result.reason, b.result.reason);
  EXPECT_EQ(a.result.path, b.result.path);
  EXPECT_EQ(a.result.time_total, b.result.time_total);
  EXPECT_EQ(a.result.iterations, b.result.iterations);
  EXPECT_EQ(counter(a.result, "nodes"), counter(b.result, "nodes"));
  expect_same_cost(a.claims.cost, b.claims.cost);
  EXPECT_EQ(a.claims.clearance.margin, b.claims.clearance.margin);
  EXPECT_EQ(a.claims.steering, b.claims.steering);
  EXPECT_EQ(a.claims.start_hitch_angle, b.claims.start_hitch_angle);
}

class BinaryResult : public testing::Test {
 protected:
  std::string written(const std::vector<ResultRecord>& records, const std::string& name) {
    PairWriter writer(folder_ / name, records.front());
    for (std::size_t i = 0; i < records.size(); ++i) {
      writer.write(7 * i + 1, make_problem(quay()), records[i]);
    }
    writer.commit();
    return folder_ / name;
  }

  std::vector<PairRecord> read(const std::string& file) {
    ResultReader reader(file, file_);
    if (!reader.has_pairs()) {
      (void)reader.all();
      return {};
    }
    std::vector<PairRecord> records;
    while (const std::optional<PairRecord> record = reader.next()) records.push_back(*record);
    return records;
  }

  /// What is wrong with some bytes.
  std::string complaint(const std::string& bytes) {
    try {
      (void)read(folder_.put("r.vpr", bytes));
    } catch (const InputError& error) {
      return std::string(error.what()).substr(folder_.path().size() + 1);
    }
    return "nothing";
  }

  std::string good() {
    return read_file(written({planned_record(quay()), without_path(quay())}, "good.vpr"),
                     1U << 20U);
  }

  /// The same with other bytes at a place of the first result, counted from its mark.
  template <class Unsigned>
  std::string spoilt(std::size_t place, Unsigned value) {
    std::string bytes = good();
    const std::size_t first = 24 + base::read_at<std::uint32_t>(bytes, 20);
    std::string other;
    base::append(other, value);
    return complaint(bytes.replace(first + place, other.size(), other));
  }
  std::string spoilt(std::size_t place, double value) {
    return spoilt(place, std::bit_cast<std::uint64_t>(value));
  }

  TemporaryFolder folder_;
  const ScenarioFile file_{quay()};
};

TEST_F(BinaryResult, SaysOfPairsWhatJsonSays) {
  const std::vector<ResultRecord> records = {planned_record(quay()), without_path(quay()),
                                             planned_record(quay())};
  const auto binary = read(written(records, "r.vpr"));
  const auto json = read(written(records, "r.jsonl"));
  ASSERT_EQ(binary.size(), 3U);
  ASSERT_EQ(json.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(binary[i].pair, 7 * i + 1);
    EXPECT_EQ(binary[i].poses.start, json[i].poses.start);
    EXPECT_EQ(binary[i].poses.goal, json[i].poses.goal);
    expect_same(binary[i].record, json[i].record);
  }
  EXPECT_EQ(binary[0].record.claims.clearance.margin, 0.25);
  EXPECT_TRUE(binary[0].record.claims.cost);
  EXPECT_LT(read_file(folder_ / "r.vpr", 1U << 20U).size() * 10,
            read_file(folder_ / "r.jsonl", 1U << 20U).size());
}

TEST_F(BinaryResult, SaysOfGoalsWhatJsonSays) {
  const ScenarioFile row{quay(), {{20.0, {20, 0, 0}, {}}, {40.0, {40, 0, 0}, {}}}};
  for (const ScenarioFile& file : {file_, row}) {
    std::vector<ResultRecord> records;
    for (std::size_t i = 0; i < file.size(); ++i) {
      records.push_back(i == 0 ? planned_record(quay()) : without_path(quay()));
      if (file.is_row()) records.back().distance = file.row[i].distance;
    }
    write_results(folder_ / "r.VPR", file, records);
    write_results(folder_ / "r.json", file, records);
    EXPECT_TRUE(read_file(folder_ / "r.VPR", 1U << 20U).starts_with("vp-plans"));
    const auto binary = read_results(folder_ / "r.VPR", file);
    const auto json = read_results(folder_ / "r.json", file);
    ASSERT_EQ(binary.size(), json.size());
    for (std::size_t i = 0; i < json.size(); ++i) expect_same(binary[i], json[i]);
    EXPECT_FALSE(ResultReader(folder_ / "r.VPR", file).has_pairs());
  }
  EXPECT_THROW((void)read_results(folder_ / "r.VPR", file_), InputError);
  write_results(folder_ / "one.vpr", file_, {planned_record(quay())});
  EXPECT_THROW((void)read_results(folder_ / "one.vpr", row), InputError);
  EXPECT_THROW((void)read_results(written({planned_record(quay())}, "r.vpr"), file_), InputError);
}

// A set of goals has no pose of its own: without one the goal would be at the origin.
TEST_F(BinaryResult, OfASetOfGoalsFarFromTheOriginIsRead) {
  Scenario scenario = quay();
  scenario.start = {5e5, 6.6e6, 0};
  scenario.goal_set = {{.x = {5e5 + 20, 5e5 + 20}, .y = {6.6e6, 6.6e6}}};
  const ScenarioFile file{scenario};
  for (const ResultRecord& record : {planned_record(scenario), without_path(scenario)}) {
    write_results(folder_ / "r.vpr", file, {record});
    const ResultRecord read_back = read_results(folder_ / "r.vpr", file).front();
    EXPECT_EQ(read_back.result.status, record.result.status);
    EXPECT_EQ(read_back.result.path, record.result.path);
  }
}

TEST_F(BinaryResult, CarriesTheTimesOfADrive) {
  ResultRecord record = planned_record(quay());
  record.result.speeds = SpeedProfile{
      .knots = {{0, 0, 0, 1, 0.5}, {2, 2, 2, -1, 0}}, .stops = {{1, 2, 3, 4, 5}}, .duration = 9};
  const PairRecord read_back = read(written({record}, "r.vpr")).front();
  ASSERT_TRUE(read_back.record.result.speeds);
  const SpeedProfile& speeds = *read_back.record.result.speeds;
  EXPECT_EQ(speeds.duration, 9);
  EXPECT_EQ(speeds.standing, 3);
  ASSERT_EQ(speeds.knots.size(), 2U);
  EXPECT_EQ(speeds.knots[0].jerk, 0.5);
  EXPECT_EQ(speeds.knots[1].a, -1);
  ASSERT_EQ(speeds.stops.size(), 1U);
  EXPECT_EQ(speeds.stops[0].curvature_after, 5);
}

TEST_F(BinaryResult, CarriesTheAngleOfATrailer) {
  Scenario scenario = quay();
  scenario.vehicle = vehicle_named("tractor-semitrailer");
  scenario.hitch_angles.start = 0.3;
  const ScenarioFile file{scenario};
  write_results(folder_ / "r.vpr", file, {planned_record(scenario)});
  EXPECT_EQ(read_results(folder_ / "r.vpr", file).front().claims.start_hitch_angle, 0.3);
}

TEST_F(BinaryResult, IsRefusedWhenAByteIsMissingOrAltered) {
  const std::string bytes = good();
  ASSERT_EQ(complaint(bytes), "nothing");
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    EXPECT_NE(complaint(bytes.substr(0, i)), "nothing") << i;
    std::string other = bytes;
    other[i] = static_cast<char>(other[i] ^ 0x10);
    EXPECT_NE(complaint(other), "nothing") << i;
  }
  EXPECT_EQ(complaint(bytes + " "), "r.vpr: goes on behind its check sum, expected its end");
  EXPECT_EQ(complaint(bytes.substr(0, bytes.size() - 1)),
            "r.vpr: ends too early, in or behind result 2, expected a whole file");
}

TEST_F(BinaryResult, SaysWhatIsWrong) {
  const auto altered = [&](std::size_t at, const std::string& by) {
    return complaint(good().replace(at, by.size(), by));
  };
  EXPECT_EQ(altered(8, "\x01\x02\x03\x04"),
            "r.vpr: has the byte order mark 0x4030201, expected 0x1020304");
  EXPECT_EQ(altered(12, "\x02"), "r.vpr: is of version 2 of the format, expected 1");
  EXPECT_EQ(altered(16, "\x02"), "r.vpr: holds results of kind 2, expected 0 or 1");
  EXPECT_EQ(altered(20, "\xFF\xFF\xFF\xFF"),
            "r.vpr: begins with a text of 4294967295 bytes, expected at most 16777216");
  EXPECT_EQ(altered(24, "["), complaint(good().replace(24, 1, "[")));
  EXPECT_EQ(altered(24, "[").substr(0, 20), "r.vpr:1: is not JSON");
  EXPECT_EQ(spoilt(0, 2U), "r.vpr: result 1 begins with 2, expected 1");
  EXPECT_EQ(spoilt(4, 9U), "r.vpr: result 1 has a status of 9, expected 0 to 8");
  EXPECT_EQ(spoilt(4, 1U),
            "r.vpr: result 1 has a path though its status is start_in_collision, expected none");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(spoilt(16, nan), "r.vpr: result 1 has a start of nan, expected a finite number");
  EXPECT_EQ(spoilt(72, -std::numeric_limits<double>::infinity()),
            "r.vpr: result 1 has a cost of -inf, expected a finite number");
  EXPECT_EQ(spoilt(40, 9e6).substr(0, 32), "r.vpr: result 1 has a goal that ");
  EXPECT_EQ(spoilt(112, std::uint64_t{1} << 63U),
            "r.vpr: result 1 has 9223372036854775808 iterations, expected at most "
            "9223372036854775807");
  EXPECT_EQ(spoilt(144, nan), "r.vpr: result 1 has a curvature of nan, expected a finite number");
}

TEST_F(BinaryResult, AsksForNoMemoryOnTheWordOfACount) {
  EXPECT_EQ(spoilt(128, ~0U),
            "r.vpr: result 1 has lists of 103079215080 bytes, expected at most 536870912");
  EXPECT_EQ(spoilt(128, 20'000'000U),
            "r.vpr: ends too early, in or behind result 1, expected a whole file");
  EXPECT_EQ(spoilt(136, 1U), "r.vpr: result 1 has 1 stops without knots, expected none");
}

TEST_F(BinaryResult, LeavesWhatWasThereUntilItIsWhole) {
  const std::string file = folder_.put("r.vpr", "old");
  {
    PairWriter writer(file, planned_record(quay()));
    writer.write(1, make_problem(quay()), planned_record(quay()));
  }
  EXPECT_EQ(read_file(file, 100), "old");
}

}  // namespace
}  // namespace vandplan
