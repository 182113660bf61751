// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <thread>
#include <tuple>

#include "evaluation/store.h"
#include "support/process.h"
#include "support/shared_files.h"
#include "support/yard.h"
#include "vandplan/files.h"
#include "vandplan/judge.h"

namespace vandplan {
namespace {

using namespace evaluation;

using Words = std::vector<std::string>;

class EvaluateCommand : public testing::Test {
 protected:
  void SetUp() override { write_content(scenario_, yard()); }

  // A small comparison into a folder, limited by iterations unless something else is said.
  [[nodiscard]] Words words(const std::string& output, const Words& more = {}) const {
    Words all = {
        "evaluate",  "--scenarios", scenario_,  "--planners",    "rrt-bsc-euc,rrt-opt-hlut-4",
        "--repeats", "3",           "--output", folder_ / output};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  [[nodiscard]] std::string store_file(const std::string& output) const {
    return folder_ / (output + "/runs.sqlite");
  }

  // Waits until a process has stored that many runs; false if it does not.
  [[nodiscard]] bool has_stored(const std::string& output, std::size_t count) const {
    for (int i = 0; i < 60000; ++i) {
      if (std::filesystem::exists(store_file(output)) && runs(output).size() >= count) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }

  [[nodiscard]] std::vector<RunRecord> runs(const std::string& output) const {
    return Store::open(store_file(output)).runs();
  }

  TemporaryFolder folder_;
  const std::string scenario_ = folder_ / "yard.yaml";
};

// What a run found, by what was put in.
auto paths_of(const std::vector<RunRecord>& runs) {
  std::map<std::tuple<std::string, std::uint64_t, Region, bool>, std::vector<Segment>> paths;
  for (const RunRecord& run : runs)
    paths[{run.planner, run.seed, run.region, is_profiled(run)}] =
        run.result.path ? run.result.path->segments : std::vector<Segment>{};
  return paths;
}

TEST_F(EvaluateCommand, EndsWithATableAndAReport) {
  const Outcome outcome = run_vandplan(words("out", {"--max-iterations", "200"}));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("| rrt-opt-hlut-4 |"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.err.find("16 of 16 runs"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find("16 runs\n"
                             "     12 = 2 planners x 2 regions x 1 scenario x 3 repeats\n"
                             "      4 = 2 planners x 2 regions x 1 scenario, once more to measure "
                             "phases\n"),
            0U)
      << outcome.err;
  EXPECT_EQ(runs("out").size(), 16U);  // 2 planners, 2 regions, 3 repeats and a profiled run
  EXPECT_NE(content_of(folder_ / "out/index.html").find("</html>"), std::string::npos);
  EXPECT_NE(content_of(folder_ / "out/report.md").find("rrt-bsc-euc"), std::string::npos);
}

TEST_F(EvaluateCommand, TakesTheThesisAsPrintedFirst) {
  const Outcome outcome = run_vandplan({"evaluate", "--scenarios", scenario_, "--max-iterations",
                                        "30", "--output", folder_ / "out", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  std::map<std::string, int> count;
  for (const RunRecord& run : runs("out")) ++count[run.planner];
  EXPECT_EQ(count.size(), 21U);                // both settings of the goal, and the default planner
  EXPECT_EQ(count.at("rrt-bsc-euc"), 2 * 26);  // 25 repeats and a profiled run
  EXPECT_EQ(count.at("rrt-bsc-euc-goal"), 2 * 6);  // fewer
  const auto json = nlohmann::json::parse(outcome.out);
  ASSERT_EQ(json.at("claims").size(), 12U);
  EXPECT_EQ(json.at("claims").at(0).at("setting"), "as printed");
  EXPECT_EQ(json.at("claims").at(11).at("setting"), "goal tried");
  EXPECT_EQ(json.at("verdicts").size(), 3U);
}

TEST_F(EvaluateCommand, PrintsOneJsonObjectInstead) {
  const Outcome outcome = run_vandplan(words("out", {"--max-iterations", "200", "--json"}));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json.at("runs"), 16);
  EXPECT_EQ(json.at("missing"), 0);
  EXPECT_EQ(json.at("scenarios").size(), 2U);  // in two regions
  const auto& scenario = json.at("scenarios").at(1);
  EXPECT_EQ(scenario.at("scenario"), "yard");
  EXPECT_EQ(scenario.at("region"), "scene");
  EXPECT_EQ(scenario.at("planners").at(0).at("planner"), "rrt-bsc-euc");
  EXPECT_EQ(scenario.at("planners").at(1).at("runs"), 3);
  EXPECT_GT(scenario.at("planners").at(1).at("cost_at_end").at("median"), 20.0);
  EXPECT_EQ(json.at("claims").size(), 0U);  // no table beside its twin
  EXPECT_EQ(json.at("options").at("max_iterations"), 200);
  EXPECT_TRUE(std::filesystem::exists(json.at("output").at("page").get<std::string>()));
}

TEST_F(EvaluateCommand, FindsTheSamePathsWithOneJobAndWithTwo) {
  ASSERT_EQ(run_vandplan(words("one", {"--max-iterations", "300"})).status, 0);
  ASSERT_EQ(run_vandplan(words("two", {"--max-iterations", "300", "--jobs", "2"})).status, 0);
  EXPECT_EQ(paths_of(runs("one")), paths_of(runs("two")));
}

TEST_F(EvaluateCommand, StoresOnlyWhatTheJudgeAccepts) {
  ASSERT_EQ(run_vandplan(words("out", {"--max-iterations", "400", "--repeats", "6"})).status, 0);
  Store store = Store::open(store_file("out"));
  const Scenario scenario = scenario_of(store.scenarios().at(0)).scenario;
  const Problem problem = make_problem(scenario);
  int judged = 0;
  for (const RunRecord& run : store.runs()) {
    if (!run.result.path) continue;
    EXPECT_EQ(run.result.path->start, scenario.start);
    const PathCheck check = check_path(problem, *run.result.path, {.length = run.result.cost});
    EXPECT_TRUE(check.valid) << run.planner << ", seed " << run.seed << ": " << check.reason;
    ++judged;
  }
  EXPECT_GT(judged, 10);
}

// As somebody would who does not trust the program: from the export, by the command line.
TEST_F(EvaluateCommand, EveryExportedPathPassesCheck) {
  const Outcome outcome =
      run_vandplan(words("out", {"--max-iterations", "400", "--planners", "anytime,rrt-bsc-hlut-2",
                                 "--export", "json"}));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto exported = nlohmann::json::parse(content_of(folder_ / "out/runs.json"));
  int checked = 0;
  for (const auto& run : exported.at("runs")) {
    if (!run.contains("path")) continue;
    const nlohmann::json result = {{"format", "vandplan-result/1"},
                                   {"status", run.at("status")},
                                   {"cost", run.at("cost")},
                                   {"path", run.at("path")}};
    write_content(folder_ / "result.json", result.dump());
    const Outcome check = run_vandplan({"check", scenario_, folder_ / "result.json"});
    EXPECT_EQ(check.status, 0) << run.at("planner") << check.out << check.err;
    ++checked;
  }
  EXPECT_GT(checked, 10);
}

TEST_F(EvaluateCommand, LosesOnlyRunsInFlightWhenKilledAndResumesWithTheRest) {
  const Words all = words("out", {"--time", "0.15", "--repeats", "20", "--jobs", "2"});
  Process killed(all);
  EXPECT_TRUE(has_stored("out", 6));
  killed.send(SIGKILL);
  EXPECT_EQ(killed.wait().status, -SIGKILL);
  const std::vector<RunRecord> before = runs("out");
  EXPECT_GE(before.size(), 6U);
  ASSERT_LT(before.size(), 84U);

  Words again = all;
  again.push_back("--resume");
  const Outcome outcome = run_vandplan(again);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<RunRecord> after = runs("out");
  EXPECT_EQ(after.size(), 84U);  // 2 planners, 2 regions, 20 repeats and a profiled run
  EXPECT_EQ(paths_of(after).size(), 84U);
  for (std::size_t i = 0; i < before.size(); ++i)  // nothing is run twice
    EXPECT_EQ(before[i].result.time_total, after[i].result.time_total);
}

TEST_F(EvaluateCommand, EndsCleanlyWhenInterrupted) {
  Process interrupted(words("out", {"--time", "0.05", "--repeats", "100"}));
  EXPECT_TRUE(has_stored("out", 5));
  interrupted.send(SIGINT);
  const Outcome outcome = interrupted.wait();
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_NE(outcome.out.find("runs are missing; --resume runs them."), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/index.html"));
}

TEST_F(EvaluateCommand, DoesNotTouchAStoreUnlessToldTo) {
  ASSERT_EQ(run_vandplan(words("out", {"--max-iterations", "20"})).status, 0);
  const Outcome outcome = run_vandplan(words("out", {"--max-iterations", "20"}));
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err.substr(outcome.err.find("vandplan: ")),
            "vandplan: " + store_file("out") +
                ": exists already, expected --resume or another --output\n");
}

TEST_F(EvaluateCommand, MergesCampaigns) {
  ASSERT_EQ(run_vandplan(words("a", {"--max-iterations", "50", "--region", "scene"})).status, 0);
  ASSERT_EQ(run_vandplan(words("b", {"--max-iterations", "50"})).status, 0);
  const Outcome outcome =
      run_vandplan({"evaluate", "--output", folder_ / "both", "--merge", store_file("a"), "--merge",
                    store_file("b"), "--export", "csv,json,ompl"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(paths_of(runs("both")), paths_of(runs("b")));
  const std::string csv = content_of(folder_ / "both/runs.csv");
  EXPECT_EQ(std::ranges::count(csv, '\n'), 17);
  const auto json = nlohmann::json::parse(content_of(folder_ / "both/runs.json"));
  EXPECT_EQ(json.at("runs").size(), 16U);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "both/plannerarena.db"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "both/index.html"));
}

// A campaign in shards: each into a folder of its own, then joined.
class ShardedCampaign : public EvaluateCommand {
 protected:
  void SetUp() override {
    EvaluateCommand::SetUp();
    write_content(folder_ / "second.yaml", replaced(yard(), "yard", "second"));
  }

  [[nodiscard]] Outcome run_part(int number, int of, const std::string& limit = "--max-iterations",
                                 const std::string& amount = "60", const Words& more = {}) const {
    Words all = words(fmt::format("{}-of-{}", number, of),
                      {limit, amount, "--shard", fmt::format("{}/{}", number, of)});
    all.insert(all.end(), {"--scenarios", folder_ / "second.yaml"});
    all.insert(all.end(), more.begin(), more.end());
    return run_vandplan(all);
  }

  void run_all(int of) const {
    for (int number = 1; number <= of; ++number) {
      const Outcome outcome = run_part(number, of);
      ASSERT_EQ(outcome.status, 0) << outcome.err;
    }
  }

  [[nodiscard]] std::string part(int number, int of) const {
    return folder_ / fmt::format("{}-of-{}", number, of);
  }

  [[nodiscard]] Outcome merge(const Words& parts, const std::string& output) const {
    Words all = {"evaluate", "--output", folder_ / output, "--merge"};
    all.insert(all.end(), parts.begin(), parts.end());
    return run_vandplan(all);
  }

  void expect_refused(const Words& parts, const std::string& complaint) const {
    const Outcome outcome = merge(parts, "refused");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.err.find(complaint), std::string::npos) << outcome.err;
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "refused"));
  }
};

TEST_F(ShardedCampaign, GivesTheSameBytesForEveryNumberOfShards) {
  run_all(1);
  run_all(3);
  ASSERT_EQ(merge({part(1, 1)}, "one").status, 0);
  // In any order, by folder or by file.
  const Outcome three = merge({part(3, 3), part(1, 3) + "/runs.sqlite", part(2, 3)}, "three");
  ASSERT_EQ(three.status, 0) << three.err;
  for (const std::string file : {"runs.sqlite", "report.md", "index.html", "gallery.png"}) {
    const std::string once = content_of(folder_ / ("one/" + file));
    EXPECT_GT(once.size(), 1000U) << file;
    EXPECT_TRUE(once == content_of(folder_ / ("three/" + file))) << file;
  }
  EXPECT_NE(three.out.find("on any machine"), std::string::npos) << three.out;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "three/runs.sqlite.merging"));
}

TEST_F(ShardedCampaign, FindsThePathsOfTheWholeCampaign) {
  run_all(3);
  ASSERT_EQ(merge({part(1, 3), part(2, 3), part(3, 3)}, "joined").status, 0);
  const Words whole =
      words("whole", {"--max-iterations", "60", "--scenarios", folder_ / "second.yaml"});
  ASSERT_EQ(run_vandplan(whole).status, 0);
  EXPECT_EQ(runs("joined").size(), 32U);  // 2 planners, 2 regions, 2 scenarios, 3 repeats and one
  EXPECT_EQ(paths_of(runs("joined")), paths_of(runs("whole")));
  for (int number = 1; number <= 3; ++number)
    EXPECT_GT(runs(fmt::format("{}-of-3", number)).size(), 2U);
}

TEST_F(ShardedCampaign, KeepsTimesWhereTheyAreTheBudget) {
  for (const int number : {1, 2}) ASSERT_EQ(run_part(number, 2, "--time", "0.01").status, 0);
  const Outcome outcome = merge({part(1, 2), part(2, 2)}, "joined");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  ASSERT_EQ(runs("joined").size(), 32U);
  for (const RunRecord& run : runs("joined")) EXPECT_TRUE(std::isfinite(run.result.time_total));
  EXPECT_EQ(outcome.out.find("on any machine"), std::string::npos) << outcome.out;
  EXPECT_EQ(Store::open(store_file("joined")).sessions().size(), 2U);
}

TEST_F(ShardedCampaign, DoesTheRestOfAShard) {
  ASSERT_EQ(run_part(1, 2).status, 0);
  const std::size_t all = runs("1-of-2").size();
  EXPECT_EQ(run_part(1, 2).status, 2);  // not without --resume
  const Outcome outcome = run_part(1, 2, "--max-iterations", "60", {"--resume"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(runs("1-of-2").size(), all);
  EXPECT_NE(outcome.out.find(fmt::format("Shard 1/2: {0} of {0} runs in", all)), std::string::npos)
      << outcome.out;
}

TEST_F(ShardedCampaign, NamesWhatDoesNotFit) {
  run_all(2);
  ASSERT_EQ(run_part(2, 3).status, 0);
  expect_refused({part(1, 2)}, "--merge: of 2 shards these are missing: 2");
  expect_refused({part(1, 2), part(1, 2)}, "is shard 1/2 as " + part(1, 2));
  expect_refused({part(1, 2), part(2, 3)}, "is shard 2/3, expected one of 2 as " + part(1, 2));
  ASSERT_EQ(run_vandplan(words("whole", {"--max-iterations", "20"})).status, 0);
  expect_refused({part(1, 2), store_file("whole")}, "holds no shard of a campaign");
  std::filesystem::remove_all(part(2, 2));
  ASSERT_EQ(run_part(2, 2, "--max-iterations", "61").status, 0);
  expect_refused({part(1, 2), part(2, 2)}, "shard 2/2 is of another campaign than " + part(1, 2) +
                                               "/runs.sqlite: max_iterations of rrt-bsc-euc: 61, "
                                               "not 60");
}

TEST_F(ShardedCampaign, RefusesAShardWithRunsMissing) {
  run_all(2);
  const std::size_t all = runs("2-of-2").size();
  evaluation::Database(store_file("2-of-2"), evaluation::Database::Mode::write)
      .execute("DELETE FROM costs; DELETE FROM segments; DELETE FROM runs WHERE id = 1");
  expect_refused(
      {part(1, 2), part(2, 2)},
      fmt::format("shard 2/2 holds {} of its {} runs, expected all of them", all - 1, all));
}

TEST_F(ShardedCampaign, KeepsStoresApart) {
  ASSERT_EQ(run_part(1, 2).status, 0);
  const Words into_first = {"--output", part(1, 2), "--resume"};
  Words second = words("x", {"--max-iterations", "60", "--shard", "2/2"});
  second.insert(second.end(), into_first.begin(), into_first.end());
  const Outcome other = run_vandplan(second);
  EXPECT_EQ(other.status, 2);
  EXPECT_NE(other.err.find("holds shard 1/2, expected another --output for shard 2/2"),
            std::string::npos)
      << other.err;
  Words whole = words("x", {"--max-iterations", "60"});
  whole.insert(whole.end(), into_first.begin(), into_first.end());
  EXPECT_EQ(run_vandplan(whole).status, 2);
  for (const char* const wrong : {"0/2", "3/2", "1", "1/", "/2", "1/2/3", "a/b"}) {
    const Outcome outcome = run_vandplan(words("x", {"--shard", wrong}));
    EXPECT_EQ(outcome.status, 2) << wrong;
    EXPECT_NE(outcome.err.find("is not I/N with I from 1 to N"), std::string::npos) << outcome.err;
  }
}

// A folder as people have it: a map, its image, and two scenarios on it.
class EvaluateCommandOnMaps : public EvaluateCommand {
 protected:
  void SetUp() override {
    std::filesystem::create_directory(maps_);
    write_content(maps_ + "/yard.yaml",
                  "image: yard.pgm\nresolution: 1\norigin: [-10, -20, 0]\nnegate: 0\n"
                  "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
    draw_wall(20);
    const std::string ground = "obstacles:\n  - [[12, -9], [13, -9], [13, 9], [12, 9]]\n";
    for (const char* const name : {"there", "back"})
      write_content(maps_ + "/" + name + ".yaml",
                    replaced(replaced(yard(), "yard", name), ground, "map: yard.yaml\n"));
  }

  // A wall in column 22, that is, at x = 12 m, in all rows but those below.
  void draw_wall(int from) const {
    std::string image = "P5\n50 40\n255\n";
    for (int row = 40; row-- > 0;)
      for (int column = 0; column < 50; ++column)
        image += column == 22 && row >= from ? '\0' : '\xfe';
    std::filesystem::remove(maps_ + "/yard.pgm");
    write_content(maps_ + "/yard.pgm", image);
  }

  [[nodiscard]] Outcome evaluate(const Words& more = {}) const {
    Words all = {"evaluate",         "--scenarios", maps_,          "--planners", "anytime",
                 "--max-iterations", "300",         "--repeats",    "2",          "--region",
                 "bounds",           "--output",    folder_ / "out"};
    all.insert(all.end(), more.begin(), more.end());
    return run_vandplan(all);
  }

  const std::string maps_ = folder_ / "maps";
};

TEST_F(EvaluateCommandOnMaps, SkipsTheMapsOfAFolderAndSaysSo) {
  const Outcome outcome = evaluate();
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err.find(maps_ + "/yard.yaml: skipped, a map, not a scenario\n"), 0U)
      << outcome.err;
  EXPECT_NE(outcome.err.find("4 runs\n      4 = 1 planner x 1 region x 2 scenarios x 2 repeats\n"),
            std::string::npos)
      << outcome.err;
  EXPECT_NE(outcome.out.find("there"), std::string::npos) << outcome.out;
  EXPECT_TRUE(content_of(folder_ / "out/gallery.png").starts_with("\x89PNG"));
  const std::string page = content_of(folder_ / "out/index.html");
  const std::size_t map = page.find("\"image\":\"data:image/png;base64,");
  EXPECT_NE(map, std::string::npos);  // once for both scenarios
  EXPECT_EQ(page.find("\"image\":\"data:image/png;base64,", map + 1), std::string::npos);
}

TEST_F(EvaluateCommandOnMaps, ReportsWithoutTheFiles) {
  ASSERT_EQ(evaluate().status, 0);
  std::filesystem::remove_all(maps_);
  const Outcome outcome = evaluate({"--report-only"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
}

TEST_F(EvaluateCommandOnMaps, ResumesAnewOnAChangedImage) {
  ASSERT_EQ(evaluate().status, 0);
  EXPECT_NE(evaluate({"--resume"}).out.find("\n4 runs"), std::string::npos);
  EXPECT_EQ(runs("out").size(), 4U);  // 2 scenarios, 2 repeats
  draw_wall(15);
  const Outcome again = evaluate({"--resume"});
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_NE(again.out.find("4 runs in the store are of other"), std::string::npos) << again.out;
  const std::vector<RunRecord> all = runs("out");
  ASSERT_EQ(all.size(), 8U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NE(all[i].scenario, all[i + 4].scenario);
}

TEST_F(EvaluateCommand, RefusesBadInputOnOneLine) {
  write_content(folder_ / "no-store.sqlite", std::string(3000, 'x'));
  const std::vector<std::pair<Words, std::string>> kinds = {
      {{"--merge", folder_ / "no-store.sqlite"}, "file is not a database"},
      {{"--merge", folder_ / "absent.sqlite"}, "does not exist"},
      {{"--planners", "rrt"}, "\"rrt\" is unknown"},
      {{"--scenarios", folder_ / "absent.yaml"}, "absent.yaml"},
      {{"--region", "moon"}, "\"moon\" is not bounds, scene or both"},
      {{"--set", "region=scene"}, "is set by the comparison itself"},
      {{"--set", "gaol_bias=1"}, "gaol_bias: unknown option"},
      {{"--repeats", "0"}, "repeats: must be at least 1"},
      {{"--time", "-1"}, "time_limit"},
      {{"--jobs", "1000"}, "jobs: 1000 runs at once"},
      {{"--export", "xml"}, "xml"},
      {{"--set", "goal_bias"}, "\"goal_bias\" is not KEY=VALUE"},
  };
  for (const auto& [options, complaint] : kinds) {
    Words all = {"evaluate", "--output", folder_ / "out"};
    if (options[0] != "--scenarios") all.insert(all.end(), {"--scenarios", scenario_});
    all.insert(all.end(), options.begin(), options.end());
    const Outcome outcome = run_vandplan(all);
    EXPECT_EQ(outcome.status, 2) << options[0] << " " << options[1];
    EXPECT_NE(outcome.err.find(complaint), std::string::npos) << outcome.err;
    std::filesystem::remove_all(folder_ / "out");
  }
}

}  // namespace
}  // namespace vandplan
