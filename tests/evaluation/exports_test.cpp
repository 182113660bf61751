// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/exports.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "evaluation/sqlite.h"
#include "support/made_up_runs.h"
#include "support/temporary_folder.h"

namespace vandplan::evaluation {
namespace {

/// Two planners in both regions, on open ground and to both goals of a row; rrt-bsc-euc solves
/// every second run.
class Exports : public testing::Test {
 protected:
  Exports() {
    const Environment here{"0.1.0", "GNU 12", "Release", "0123", "a \"fast\" processor",
                           2,       "Linux"};
    const std::size_t environment = store_.index_of(here);
    for (const ScenarioFile& scenario : {open_ground("open"), open_ground("row", 2)}) {
      const std::size_t index = store_.index_of(stored(scenario, scenario.scenario.name + ".yaml"));
      for (std::size_t goal = 0; goal < scenario.size(); ++goal)
        for (const std::string planner : {"rrt-bsc-euc", "rrt-opt-hlut-4"})
          for (const Region region : {Region::bounds, Region::scene})
            for (std::uint64_t seed = 1; seed <= 4; ++seed) {
              const bool solved = planner == "rrt-opt-hlut-4" || seed % 2 == 0;
              RunRecord run = solved ? made_up_run(planner, seed, 100.0 + static_cast<double>(seed))
                                     : made_up_run(planner, seed, {});
              run.environment = environment;
              run.scenario = index;
              run.goal = goal;
              run.region = region;
              store_.add(run);
            }
    }
    RunRecord profiled = made_up_run("rrt-bsc-euc", 5, 100.0);
    profiled.environment = environment;
    profiled.options.change([](PlanOptions& options) { options.planner.set("profile", true); });
    store_.add(profiled);
  }

  TemporaryFolder folder_;
  Store store_ = Store::create(folder_ / "runs.sqlite");
};

TEST_F(Exports, CsvHasALineForEveryRun) {
  const std::string csv = runs_to_csv(store_);
  EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + 48 + 1);
  EXPECT_NE(csv.find("\nopen,0,rrt-bsc-euc,bounds,1,time_limit,,,,,0.1,1000,900,"),
            std::string::npos)
      << csv;
  EXPECT_NE(csv.find("\nrow,1,rrt-opt-hlut-4,scene,4,solved,,104,0,0.001,0.1,1000,900,"),
            std::string::npos)
      << csv;
  EXPECT_NE(csv.find(",\"a \"\"fast\"\" processor\","), std::string::npos) << csv;
}

TEST_F(Exports, CsvHasNoFormula) {
  const std::size_t index = store_.index_of(stored(open_ground("=1+1, \"a\""), "f.yaml"));
  RunRecord run = made_up_run("rrt-bsc-euc", 77, 100.0);
  run.scenario = index;
  run.result.reason = "@SUM(A1)";
  store_.add(run);
  const std::string csv = runs_to_csv(store_);
  EXPECT_NE(csv.find("\n\"'=1+1, \"\"a\"\"\",0,rrt-bsc-euc,bounds,77,solved,'@SUM(A1),100,"),
            std::string::npos)
      << csv;
}

TEST_F(Exports, AnOmplDatabaseGoesWhereALinkLeads) {
  const std::string link = folder_ / "link.db";
  std::filesystem::create_symlink("target.db", link);
  for (int time = 0; time < 2; ++time) {  // leads to nothing, then to a database
    write_ompl_database(store_, link);
    EXPECT_TRUE(std::filesystem::is_symlink(link));
    Database database(folder_ / "target.db", Database::Mode::read);
    Statement rows(database, "SELECT count(*) FROM experiments");
    ASSERT_TRUE(rows.step());
    EXPECT_NE(rows.text(0), "0");
    EXPECT_FALSE(std::filesystem::exists(link + ".new"));
  }
}

// ---- What Planner Arena 1.5 reads (its server.R), as SQL ----

// runs_ext: every run with its planner and its experiment.
constexpr const char* joined =
    " FROM runs JOIN plannerConfigs ON plannerConfigs.id = runs.plannerid"
    " JOIN experiments ON experiments.id = runs.experimentid ";

class PlannerArena : public Exports {
 protected:
  PlannerArena() : database_(written(), Database::Mode::read) {}

  std::string written() {
    const std::string file = folder_ / "plannerarena.db";
    write_ompl_database(store_, file);
    return file;
  }

  /// Every value of a query, row by row.
  std::vector<std::string> values(const std::string& sql, int columns = 1) {
    std::vector<std::string> found;
    Statement rows(database_, sql);
    while (rows.step())
      for (int i = 0; i < columns; ++i) found.push_back(rows.text(i));
    return found;
  }

  std::vector<std::string> columns(const std::string& table) {
    return values("SELECT name FROM pragma_table_info('" + table + "') ORDER BY cid");
  }

  Database database_;
};

using Strings = std::vector<std::string>;

TEST_F(PlannerArena, FindsItsTablesAndColumns) {
  EXPECT_EQ(values("SELECT name FROM sqlite_master WHERE type = 'table'"
                   " AND name NOT LIKE 'sqlite%' ORDER BY name"),
            (Strings{"enums", "experiments", "plannerConfigs", "progress", "runs"}));
  // Whatever follows the twelfth column is taken for a parameter of the problem, ...
  EXPECT_EQ(columns("experiments"),
            (Strings{"id", "name", "totaltime", "timelimit", "memorylimit", "runcount", "version",
                     "hostname", "cpuinfo", "date", "seed", "setup", "region", "distance"}));
  EXPECT_EQ(columns("plannerConfigs"), (Strings{"id", "name", "settings"}));
  EXPECT_EQ(columns("enums"), (Strings{"name", "value", "description"}));
  // ... and what follows three ids, or an id and the time, for something to plot.
  const Strings runs = columns("runs");
  EXPECT_EQ(Strings(runs.begin(), runs.begin() + 5),
            (Strings{"id", "experimentid", "plannerid", "time", "solved"}));
  EXPECT_EQ(columns("progress"), (Strings{"runid", "time", "best_cost"}));
}

TEST_F(PlannerArena, OffersProblemsVersionsPlannersAndParameters) {
  EXPECT_EQ(values("SELECT DISTINCT name FROM experiments"), (Strings{"open", "row"}));
  EXPECT_EQ(values("SELECT DISTINCT version FROM experiments"), (Strings{"vandplan 0.1.0"}));
  EXPECT_EQ(values("SELECT DISTINCT plannerConfigs.name" + std::string(joined)),
            (Strings{"rrt-bsc-euc", "rrt-opt-hlut-4"}));
  EXPECT_EQ(values("SELECT DISTINCT region FROM experiments WHERE name = 'row' ORDER BY 1"),
            (Strings{"bounds", "scene"}));
  EXPECT_EQ(values("SELECT DISTINCT distance FROM experiments WHERE name = 'row' ORDER BY 1"),
            (Strings{"20.0", "40.0"}));
  EXPECT_EQ(values("SELECT DISTINCT distance FROM experiments WHERE name = 'open'"
                   " AND distance IS NOT NULL"),
            Strings{});
}

TEST_F(PlannerArena, PlotsWhatWasMeasured) {
  EXPECT_EQ(database_.integer("SELECT count(*)" + std::string(joined)), 48);  // none is profiled
  EXPECT_EQ(values("SELECT plannerConfigs.name, count(*), avg(solved), max(solution_length)" +
                       std::string(joined) +
                       "WHERE experiments.name = 'row' AND version = 'vandplan 0.1.0'"
                       " AND region = 'scene' AND distance = 40"
                       " GROUP BY plannerConfigs.name ORDER BY 1",
                   4),
            (Strings{"rrt-bsc-euc", "4", "0.5", "104.0", "rrt-opt-hlut-4", "4", "1.0", "104.0"}));
  EXPECT_EQ(values("SELECT runcount, totaltime, timelimit FROM experiments WHERE name = 'open'"
                   " AND region = 'bounds'",
                   3),
            (Strings{"8", "0.8", "0.1"}));
  // Every status has a name.
  EXPECT_EQ(values("SELECT DISTINCT description FROM runs LEFT JOIN enums"
                   " ON enums.name = 'status' AND enums.value = runs.status ORDER BY 1"),
            (Strings{"solved", "time_limit"}));
}

TEST_F(PlannerArena, PlotsProgress) {
  EXPECT_EQ(values("SELECT progress.time, best_cost" + std::string(joined) +
                       "JOIN progress ON progress.runid = runs.id"
                       " WHERE experiments.name = 'open' AND region = 'bounds'"
                       " AND plannerConfigs.name = 'rrt-bsc-euc' AND random_seed = 4"
                       " ORDER BY progress.time",
                   2),
            (Strings{"0.001", "208.0", "0.002", "104.0"}));
  EXPECT_EQ(database_.integer("SELECT count(*) FROM progress"), 36 * 2);
}

}  // namespace
}  // namespace vandplan::evaluation
