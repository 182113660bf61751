// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// A program outside the repository compares its own planners with ours.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stop_token>
#include <thread>

#include "support/temporary_folder.h"
#include "vandplan/evaluation.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

using evaluation::Campaign;
using evaluation::Comparison;
using evaluation::Progress;

ScenarioFile open_yard() {
  ScenarioFile file;
  file.scenario.name = "yard";
  file.scenario.bounds = {-50.0, 50.0, -50.0, 50.0};
  file.scenario.goal = {20.0, 10.0, 1.0};
  return file;
}

// Takes the shortest path, whatever stands in its way; how often it was asked is its state.
Planner direct_planner(int& asked) {
  return {.name = "zz-direct",
          .summary = "drives straight there",
          .function = [&asked](const Task& task, const PlanOptions&) {
            ++asked;
            const Piece piece = reeds_shepp(task.start, task.goal, task.vehicle.min_turning_radius);
            PlannerAnswer answer{.status = PlanStatus::solved};
            answer.segments.emplace(piece.view().begin(), piece.view().end());
            return answer;
          }};
}

Planner wrong_planner() {
  return {.name = "zz-wrong",
          .summary = "stops too early",
          .function = [](const Task&, const PlanOptions&) {
            PlannerAnswer answer{.status = PlanStatus::solved};
            answer.segments = {{0.0, 3.0}};
            return answer;
          }};
}

// Goes on until it is stopped, but for the call that warms up and the first run.
Planner endless_planner(int& asked) {
  return {.name = "zz-endless",
          .summary = "waits to be stopped",
          .function = [&asked](const Task&, const PlanOptions& options) {
            if (++asked > 2) {
              while (!options.budget.stop.stop_requested()) std::this_thread::yield();
            }
            return PlannerAnswer{};
          }};
}

Campaign small_campaign(int& asked) {
  return {.scenarios = {{open_yard(), "yard.yaml"}},
          .planners = {direct_planner(asked), wrong_planner(), planner_named("anytime")},
          .regions = {Region::bounds},
          .repeats = 3,
          .settings = {{"max_iterations", "200"}}};
}

std::string content_of(const std::string& file) {
  std::ifstream input(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(input), {}};
}

const nlohmann::json& entry(const nlohmann::json& list, const std::string& planner) {
  for (const auto& found : list)
    if (found.at("planner") == planner) return found;
  throw std::out_of_range(planner);
}

TEST(Compare, JudgesAndReportsPlannersOfOthersLikeOurs) {
  const TemporaryFolder folder;
  int asked = 0;
  Progress last;
  const Comparison found =
      evaluation::compare(small_campaign(asked), folder / "out",
                          {.report = [&](const Progress& progress) { last = progress; }});
  EXPECT_EQ(found.missing, 0);
  EXPECT_EQ(last.done, 9);
  EXPECT_EQ(last.total, 9);
  EXPECT_EQ(asked, 4);  // once to warm up
  const auto json = nlohmann::json::parse(found.json);
  const auto& methods = json.at("scenarios").at(0).at("planners");
  EXPECT_EQ(entry(methods, "zz-direct").at("solved"), 3);
  EXPECT_EQ(entry(methods, "anytime").at("solved"), 3);
  EXPECT_NEAR(entry(methods, "zz-direct").at("cost_at_end").at("median").get<double>(),
              entry(methods, "anytime").at("cost_at_end").at("median").get<double>(), 1e-9);
  EXPECT_NE(found.headline.find("| zz-direct |"), std::string::npos) << found.headline;
  EXPECT_NE(content_of(found.text).find("zz-direct"), std::string::npos);
  EXPECT_NE(content_of(found.page).find("drives straight there"), std::string::npos);
  EXPECT_TRUE(content_of(found.gallery).starts_with("\x89PNG"));
  EXPECT_TRUE(std::filesystem::exists(found.store));
}

TEST(Compare, CountsARejectedPathAsUnsolvedSaysWhyAndGoesOn) {
  const TemporaryFolder folder;
  int asked = 0;
  const Comparison found = evaluation::compare(small_campaign(asked), folder / "out");
  const auto json = nlohmann::json::parse(found.json);
  const auto& wrong = entry(json.at("scenarios").at(0).at("planners"), "zz-wrong");
  EXPECT_EQ(wrong.at("runs"), 3);
  EXPECT_EQ(wrong.at("solved"), 0);
  EXPECT_EQ(wrong.at("rejected"), 3);
  ASSERT_EQ(json.at("rejected").size(), 1U);
  EXPECT_NE(json.at("rejected").at(0).at("reason").get<std::string>().find("the path ends"),
            std::string::npos);
  EXPECT_NE(found.headline.find(
                "3 paths of zz-wrong were rejected by the judge, the first because the path ends "),
            std::string::npos)
      << found.headline;
}

TEST(Compare, DoesWhatIsMissing) {
  const TemporaryFolder folder;
  int asked = 0;
  Campaign campaign = small_campaign(asked);
  static_cast<void>(evaluation::compare(campaign, folder / "out"));
  campaign.repeats = 4;
  int done = 0;
  static_cast<void>(evaluation::compare(campaign, folder / "out",
                                        {.report = [&](const Progress& now) { done = now.done; }}));
  EXPECT_EQ(done, 3);
}

TEST(Compare, EndsWhenItIsStopped) {
  const TemporaryFolder folder;
  int asked = 0;
  std::stop_source stop;
  const auto stop_early = [&](const Progress& now) {
    if (now.done >= 1) stop.request_stop();
  };
  const Campaign campaign{.scenarios = {{open_yard(), "yard.yaml"}},
                          .planners = {endless_planner(asked)},
                          .regions = {Region::bounds},
                          .repeats = 9};
  const Comparison found = evaluation::compare(campaign, folder / "out",
                                               {.stop = stop.get_token(), .report = stop_early});
  EXPECT_EQ(found.missing, 8);
  EXPECT_TRUE(std::filesystem::exists(found.page));
}

}  // namespace
}  // namespace vandplan
