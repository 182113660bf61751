// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/store.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "evaluation/options_json.h"
#include "support/grids.h"
#include "support/made_up_runs.h"
#include "support/temporary_folder.h"
#include "vandplan/input_error.h"

namespace vandplan::evaluation {
namespace {

const Environment here{"1.0", "GNU 12", "Release", "0123", "a processor", 2, "Debian"};
const StoredScenario open_yard{"open", "scenarios/open.yaml", "name: open\n"};

RunRecord solved_run(Store& store, std::uint64_t seed) {
  RunRecord run;
  run.environment = store.index_of(here);
  run.scenario = store.index_of(open_yard);
  run.goal = 2;
  run.planner = "rrt-bsc-euc";
  run.region = Region::scene;
  run.seed = seed;
  PlanOptions options;
  options.budget.time_limit = 0.1;
  options.planner.set("goal_bias", 1.0 / 3.0);
  options.planner.set("region", std::string("scene"));
  run.options = options;
  run.jobs = 2;
  run.started = "2026-11-21T05:16:33Z";
  run.result.status = PlanStatus::solved;
  run.result.path = Path{{0.1, 4.5e9, -0.3}, {{1.0 / 7.0, 1.0 / 3.0}, {0.0, -2e-7, 1.0 / 9.0}}};
  run.result.cost = 1.0 / 3.0 + 2e-7;
  run.result.iterations = 812;
  run.result.time_total = 0.0625;
  run.result.anytime = {{0.01, 7, 1e3}, {0.02, 90, 1.0 / 3.0 + 2e-7}};
  run.result.counters = {{"nodes", 500}, {"exact_solves", 1234}, {"edge_checks", 567}};
  run.result.phases = {{"ranking", 0.5}, {"steering", 0.25}, {"checking", 0.125}, {"setup", 0.001}};
  return run;
}

RunRecord unsolved_run(Store& store, std::uint64_t seed) {
  RunRecord run = solved_run(store, seed);
  run.result = PlanResult{};
  run.result.status = PlanStatus::rejected;
  run.result.reason = "ends beside the goal";
  return run;
}

void expect_equal(const RunRecord& a, const RunRecord& b) {
  EXPECT_EQ(a.environment, b.environment);
  EXPECT_EQ(a.scenario, b.scenario);
  EXPECT_EQ(a.goal, b.goal);
  EXPECT_EQ(a.planner, b.planner);
  EXPECT_EQ(a.region, b.region);
  EXPECT_EQ(*a.options, *b.options);
  EXPECT_EQ(a.seed, b.seed);
  EXPECT_EQ(a.jobs, b.jobs);
  EXPECT_EQ(a.started, b.started);
  EXPECT_EQ(a.result.status, b.result.status);
  EXPECT_EQ(a.result.path, b.result.path);
  EXPECT_EQ(a.result.cost, b.result.cost);
  EXPECT_EQ(a.result.iterations, b.result.iterations);
  EXPECT_EQ(a.result.time_total, b.result.time_total);
  EXPECT_EQ(a.result.reason, b.result.reason);
  EXPECT_EQ(a.result.counters, b.result.counters);
  EXPECT_EQ(a.result.phases, b.result.phases);
  EXPECT_EQ(a.result.anytime, b.result.anytime);
}

// What opening the file says is wrong with it.
std::string complaint(const std::string& file) {
  try {
    const Store store = Store::open(file);
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing";
}

TEST(Store, GivesBackEveryRunBitForBit) {
  const TemporaryFolder folder;
  const std::string file = folder / "runs.sqlite";
  {
    Store store = Store::create(file);
    EXPECT_TRUE(store.add(solved_run(store, 1)));
    EXPECT_TRUE(store.add(unsolved_run(store, 0xffffffffffffffff)));
  }
  Store store = Store::open(file);
  const std::vector<RunRecord> runs = store.runs();
  ASSERT_EQ(runs.size(), 2U);
  expect_equal(runs[0], solved_run(store, 1));
  expect_equal(runs[1], unsolved_run(store, 0xffffffffffffffff));
  EXPECT_EQ(store.environments(), std::vector<Environment>{here});
  ASSERT_EQ(store.scenarios().size(), 1U);
  EXPECT_EQ(store.scenarios()[0].yaml, open_yard.yaml);
  EXPECT_EQ(store.scenarios()[0].file, open_yard.file);
}

TEST(Store, KeepsARunOnce) {
  const TemporaryFolder folder;
  Store store = Store::create(folder / "runs.sqlite");
  EXPECT_FALSE(store.contains(solved_run(store, 1)));
  EXPECT_TRUE(store.add(solved_run(store, 1)));
  EXPECT_TRUE(store.contains(solved_run(store, 1)));
  EXPECT_FALSE(store.add(unsolved_run(store, 1)));
  EXPECT_EQ(store.runs().size(), 1U);
}

TEST(Store, TellsRunsApartByEverythingThatIsPutIn) {
  const TemporaryFolder folder;
  Store store = Store::create(folder / "runs.sqlite");
  const RunRecord run = solved_run(store, 1);
  store.add(run);
  Environment elsewhere = here;
  elsewhere.executable = "4567";
  std::vector<RunRecord> others(7, run);
  others[0].environment = store.index_of(elsewhere);
  others[1].scenario = store.index_of(StoredScenario{"open", "scenarios/open.yaml", "name: o\n"});
  others[2].goal = 0;
  others[3].planner = "rrt-opt-euc";
  others[4].seed = 2;
  others[5].options.change(
      [](PlanOptions& options) { options.planner.set("max_parents", std::int64_t{49}); });
  others[6].region = Region::bounds;
  for (const RunRecord& other : others) EXPECT_FALSE(store.contains(other));
}

TEST(Store, ReadsOneStateWhileNewSettingsComeIn) {
  const TemporaryFolder folder;
  const std::string file = folder / "runs.sqlite";
  Store store = Store::create(file);
  std::thread writer([&] {
    RunRecord run = solved_run(store, 1);
    for (std::int64_t i = 1; i <= 400; ++i) {
      // A setting that no run before it had.
      run.options.change([i](PlanOptions& options) { options.planner.set("max_parents", i); });
      store.add(run);
    }
  });
  std::size_t count = 0;
  try {
    Store second = Store::open(file);
    while (count < 400) count = second.runs().size();
  } catch (const std::exception& error) {
    ADD_FAILURE() << error.what() << " after " << count << " runs";
  }
  writer.join();
}

TEST(Store, CanBeReadAndWrittenWhileARunIsBeingAddedElsewhere) {
  const TemporaryFolder folder;
  const std::string file = folder / "runs.sqlite";
  Store store = Store::create(file);
  store.add(solved_run(store, 1));
  Store second = Store::open(file);
  EXPECT_EQ(second.runs().size(), 1U);
  store.add(solved_run(store, 2));
  EXPECT_EQ(second.runs().size(), 2U);
}

ScenarioFile on_a_map(const OccupancyGrid& map) {
  ScenarioFile file = open_ground("yard");
  file.scenario.map_file = "map.yaml";
  file.scenario.map = map;
  return file;
}

TEST(Store, KeepsTheMapOfAScenario) {
  const TemporaryFolder folder;
  const std::string file = folder / "runs.sqlite";
  OccupancyGrid map = grid_of({"#.?", "..#"}, 30.1, {-1.5, 2, 0.25});
  map.unknown_is_free = true;
  ScenarioFile turned = on_a_map(map);
  turned.scenario.curvatures = {0.1, -0.05};
  {
    Store store = Store::create(file);
    store.index_of(stored(turned, "no/such/yard.yaml"));
  }
  Store first = Store::open(file), second = Store::create(folder / "second.sqlite");
  second.merge(first);
  for (Store* const store : {&first, &second}) {
    const Scenario scenario = scenario_of(store->scenarios().at(0)).scenario;
    ASSERT_TRUE(scenario.map);
    EXPECT_EQ(*scenario.map->cells, *map.cells);
    EXPECT_EQ(scenario.map->columns, 3);
    EXPECT_EQ(scenario.map->rows, 2);
    EXPECT_EQ(scenario.map->resolution, map.resolution);
    EXPECT_EQ(scenario.map->origin, map.origin);
    EXPECT_TRUE(scenario.map->unknown_is_free);
    EXPECT_EQ(scenario.map_file, "map.yaml");
    EXPECT_EQ(scenario.curvatures, turned.scenario.curvatures);
  }
}

TEST(Store, TellsScenariosApartByTheirMaps) {
  const TemporaryFolder folder;
  Store store = Store::create(folder / "runs.sqlite");
  const OccupancyGrid map = grid_of({"#..", "..."}, 30);
  OccupancyGrid shifted = map, finer = map;
  shifted.origin.y = 0.5;
  finer.resolution = 29;
  std::vector<ScenarioFile> scenarios = {on_a_map(map),
                                         on_a_map(grid_of({"#..", ".#."}, 30)),
                                         on_a_map(grid_of({"#.", "..", ".."}, 30)),
                                         on_a_map(shifted),
                                         on_a_map(finer),
                                         open_ground("yard")};
  for (int twice = 0; twice < 2; ++twice)
    for (std::size_t i = 0; i < scenarios.size(); ++i)
      EXPECT_EQ(store.index_of(stored(scenarios[i], "yard.yaml")), i);
  EXPECT_EQ(store.scenarios().size(), scenarios.size());
}

TEST(Store, MergesWhatIsNew) {
  const TemporaryFolder folder;
  Store first = Store::create(folder / "first.sqlite");
  Store second = Store::create(folder / "second.sqlite");
  first.add(solved_run(first, 1));
  second.index_of(Environment{});  // so that indices differ
  second.index_of(StoredScenario{"other", "other.yaml", "name: other\n"});
  second.add(solved_run(second, 1));
  second.add(solved_run(second, 2));
  second.add(Session{.environment = 1, .started = "2026-11-21T05:16:33Z", .runs = 2});
  EXPECT_EQ(first.merge(second), 1);
  const std::vector<RunRecord> runs = first.runs();
  ASSERT_EQ(runs.size(), 2U);
  expect_equal(runs[1], solved_run(first, 2));
  EXPECT_EQ(first.sessions().size(), 1U);
  EXPECT_EQ(first.merge(second), 0);
  EXPECT_EQ(first.sessions().size(), 1U);
}

TEST(Store, RefusesWhatIsNotThere) {
  const TemporaryFolder folder;
  const std::string file = folder / "runs.sqlite";
  EXPECT_EQ(complaint(file), file + ": does not exist");
}

TEST(Store, RefusesToReplaceAFile) {
  const TemporaryFolder folder;
  const std::string file = folder / "runs.sqlite";
  const Store store = Store::create(file);
  EXPECT_THROW(static_cast<void>(Store::create(file)), InputError);
}

TEST(Store, RefusesToReplaceALinkToNothing) {
  const TemporaryFolder folder;
  const std::string link = folder / "runs.sqlite";
  std::filesystem::create_symlink(folder / "elsewhere", link);
  try {
    static_cast<void>(Store::create(link));
    ADD_FAILURE() << "made a store";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), link + ": is a link to nothing");
  }
  EXPECT_TRUE(std::filesystem::is_symlink(link));
}

TEST(Store, RefusesAFileThatIsNoDatabase) {
  const TemporaryFolder folder;
  const std::string file = folder / "runs.sqlite";
  std::ofstream(file) << std::string(5000, 'x');
  EXPECT_EQ(complaint(file), file + ": file is not a database");
  std::ofstream(file, std::ios::trunc).flush();
  EXPECT_EQ(complaint(file), file + ": is not a result store of vandplan");
}

TEST(Store, RefusesAnotherFormat) {
  const TemporaryFolder folder;
  const std::string file = folder / "runs.sqlite";
  { const Store store = Store::create(file); }
  Database(file, Database::Mode::write).execute("PRAGMA user_version = 99");
  EXPECT_EQ(complaint(file),
            file + ": is a result store of format 99, expected " + std::to_string(Store::format));
  // The second one knew no clothoids.
  Database(file, Database::Mode::write).execute("PRAGMA user_version = 2");
  EXPECT_EQ(complaint(file), file + ": is a result store of format 2, expected 4");
}

TEST(Store, AddsToTheThirdFormatWhatItLacks) {
  const TemporaryFolder folder;
  const std::string file = folder / "runs.sqlite";
  {
    Store store = Store::create(file);
    store.add(unsolved_run(store, 1));
  }
  Database(file, Database::Mode::write)
      .execute("ALTER TABLE runs DROP COLUMN time_setup; PRAGMA user_version = 3");
  Store store = Store::open(file);
  store.add(solved_run(store, 2));
  ASSERT_EQ(store.runs().size(), 2U);
  expect_equal(store.runs()[0], unsolved_run(store, 1));
  expect_equal(store.runs()[1], solved_run(store, 2));
}

TEST(Store, RefusesADamagedFile) {
  const TemporaryFolder folder;
  const std::string file = folder / "runs.sqlite";
  {
    Store store = Store::create(file);
    for (std::uint64_t seed = 0; seed < 200; ++seed) store.add(solved_run(store, seed));
  }
  const auto size = std::filesystem::file_size(file);
  {
    std::fstream bytes(file, std::ios::in | std::ios::out | std::ios::binary);
    bytes.seekp(static_cast<std::streamoff>(size / 2));
    bytes << std::string(size / 4, '\x5a');
  }
  EXPECT_NE(complaint(file).find(file + ": "), std::string::npos);
  EXPECT_NE(complaint(file).find("is damaged"), std::string::npos) << complaint(file);
  std::filesystem::resize_file(file, size / 2);
  EXPECT_NE(complaint(file), "nothing");
}

TEST(Store, RefusesRowsThatReferToNothing) {
  const TemporaryFolder folder;
  const std::string file = folder / "runs.sqlite";
  {
    Store store = Store::create(file);
    store.add(solved_run(store, 1));
  }
  Database(file, Database::Mode::write).execute("DELETE FROM scenarios");
  EXPECT_EQ(complaint(file), file + ": is damaged: a row of runs refers to nothing");
}

TEST(Store, WritesOptionsAsJsonThatReadsBack) {
  PlanOptions options;
  options.budget.time_limit = 1e-7;
  options.budget.max_iterations = 1'000'000'000'000;
  options.cost.initial_gear = InitialGear::reverse;
  options.steering = Steering::continuous_between_stops;
  options.planner.set("goal_bias", 1.0 / 3.0);
  options.planner.set("weight", 2.0);  // stays a number that need not be whole
  options.planner.set("max_nodes", std::int64_t{2});
  options.planner.set("keep_tree", true);
  options.planner.set("region", std::string("scene"));
  EXPECT_EQ(options_from_json(options_to_json(options)), options);
  options.budget.processor_time = true;
  EXPECT_EQ(options_from_json(options_to_json(options)), options);
}

TEST(Store, RefusesOptionsThatAreNoJson) {
  EXPECT_THROW(static_cast<void>(options_from_json("{\"goal_bias\": ")), InputError);
  EXPECT_THROW(static_cast<void>(options_from_json("{\"goal_bias\": [0.1]}")), InputError);
}

}  // namespace
}  // namespace vandplan::evaluation
