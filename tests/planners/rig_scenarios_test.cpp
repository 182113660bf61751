// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// The scenarios with trailers: the default planner solves each of them within a budget of
// iterations, as the judge sees it. What differs from seed to seed comes after the first path.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "support/cases.h"
#include "support/shared_files.h"
#include "vandplan/files.h"
#include "vandplan/planner.h"

namespace vandplan {
namespace {

struct TrailerScenario {
  const char* file;
  int most_gear_changes;  // of any path that a driver would call one
};

class TrailerScenarios : public testing::TestWithParam<TrailerScenario> {};

TEST_P(TrailerScenarios, AreSolved) {
  const std::string path =
      (repository() / "scenarios/trailer" / GetParam().file).string() + ".yaml";
  PlanOptions options;
  options.cost = driver_style;
  options.budget = {.max_iterations = is_sanitized ? 100 : 10000, .seed = 1};
  const PlanResult result = plan(read_problems(path).problems.front(), options);
  if (is_sanitized) return;
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_TRUE(result.check->valid);
  EXPECT_LE(result.check->gear_changes, GetParam().most_gear_changes);
}

INSTANTIATE_TEST_SUITE_P(All, TrailerScenarios,
                         testing::Values(TrailerScenario{"dock", 3},
                                         TrailerScenario{"parallel-parking", 8},
                                         TrailerScenario{"reverse-corner", 5},
                                         TrailerScenario{"turn-in-street", 8},
                                         TrailerScenario{"turn-round-yard", 6}),
                         [](const auto& instance) {
                           std::string name = instance.param.file;
                           std::erase(name, '-');
                           return name;
                         });

// Where little more than the rig fits, searches that keep the margin find nothing.
TEST(TrailerScenarioMargins, AreKeptWhereThereIsRoomForThem) {
  if (is_sanitized) GTEST_SKIP() << "takes minutes";
  const auto clearance = [](const char* file, double margin) {
    const std::string path = (repository() / "scenarios/trailer" / file).string();
    PlanOptions options{.cost = driver_style, .clearance = {.margin = margin}};
    options.budget = {.max_iterations = 40000, .seed = 1};
    const PlanResult result = plan(read_problems(path).problems.front(), options);
    return result.path ? result.check->clearance.value_or(0.0) : 0.0;
  };
  EXPECT_GE(clearance("parallel-parking.yaml", 0.04), 0.04);
  EXPECT_GE(clearance("reverse-corner.yaml", 0.06), 0.06);
}

TEST(TrailerScenarioFiles, AllAreTried) {
  int files = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(repository() / "scenarios/trailer")) {
    files += entry.path().extension() == ".yaml" ? 1 : 0;
  }
  EXPECT_EQ(files, 5) << "a scenario that is not in the list above";
}

}  // namespace
}  // namespace vandplan
