// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "support/process.h"

namespace vandplan {
namespace {

using Json = nlohmann::json;

class StudyCommand : public testing::Test {
 protected:
  Json json_of(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "study");
    arguments.insert(arguments.end(), {"--json", "-o", folder()});
    const Outcome outcome = run_vandplan(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const Json json = Json::parse(outcome.out);
    for (const std::string file : json.at("files")) EXPECT_NE(content_of(file), "") << file;
    return json;
  }

  std::string complaint(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "study");
    const Outcome outcome = run_vandplan(arguments);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    const std::string name = "vandplan: ";
    EXPECT_EQ(outcome.err.substr(0, name.size()), name);
    return outcome.err.substr(name.size(), outcome.err.size() - name.size() - 1);
  }

  void expect_pictures(const std::string& name) {
    EXPECT_EQ(content_of(folder() + "/" + name + ".png").substr(0, 4), "\x89PNG");
    const std::string svg = content_of(folder() + "/" + name + ".svg");
    EXPECT_NE(svg.substr(0, 400).find("<svg"), std::string::npos);
    EXPECT_NE(svg.find("</svg>"), std::string::npos);
  }

  /// Made by the command.
  [[nodiscard]] std::string folder() const { return folder_ / "made/by it"; }

  TemporaryFolder folder_;
};

TEST_F(StudyCommand, RangeWritesNumbersAndPictures) {
  const Json json = json_of({"range", "--pairs", "500"});
  EXPECT_EQ(json.at("pairs"), 500);
  EXPECT_NEAR(json.at("rings").at(10).at("reeds_shepp").at("mean").get<double>(), 6.3, 0.1);
  expect_pictures("range");
}

TEST_F(StudyCommand, AccuracyTakesTablesByNameAndByFile) {
  const std::string table = folder_ / "my_own.table";
  ASSERT_EQ(
      run_vandplan({"table", "build", "--extent", "10", "--headings", "12", "-o", table}).status,
      0);
  const Json json = json_of({"accuracy", "--pairs", "20000", "--table", "hlut-1," + table});
  const Json& estimates = json.at("estimates");
  ASSERT_EQ(estimates.size(), 4U);  // Euclid first, the lower bound last
  EXPECT_EQ(estimates.at(0).at("over_estimates"), 0.0);
  EXPECT_NEAR(estimates.at(1).at("within_10_percent").get<double>(), 0.61, 0.03);
  EXPECT_GT(estimates.at(2).at("within_10_percent"), estimates.at(1).at("within_10_percent"));
  EXPECT_EQ(estimates.at(3).at("over_estimates"), 0.0);
  EXPECT_GT(estimates.at(3).at("within_10_percent"), 0.99);
  expect_pictures("accuracy");
}

TEST_F(StudyCommand, TrailerAccuracyComparesEstimatesForARig) {
  const Json json = json_of({"trailer-accuracy", "--pairs", "2000", "--vehicle", "car-caravan"});
  const Json& estimates = json.at("estimates");
  ASSERT_EQ(estimates.size(), 4U);
  EXPECT_EQ(estimates.at(0).at("over_estimates"), 0.0);
  EXPECT_EQ(estimates.at(2).at("over_estimates"), 0.0);
  EXPECT_GT(estimates.at(3).at("within_10_percent"), estimates.at(2).at("within_10_percent"));
  expect_pictures("trailer-accuracy");
  EXPECT_EQ(complaint({"trailer-accuracy", "--vehicle", "city-bus"}),
            "--vehicle: city-bus has no trailer, expected one that has");
}

TEST_F(StudyCommand, GrowthWritesNumbersAndPictures) {
  const Json json = json_of({"growth", "--seed", "3"});
  EXPECT_EQ(json.at("stages").size(), 6U);
  EXPECT_EQ(json.at("stages").at(5).at("nodes"), 100'000);
  expect_pictures("growth");
}

TEST_F(StudyCommand, SymmetryWritesNumbersAndPictures) {
  EXPECT_LT(json_of({"symmetry", "--pairs", "1000"}).at("worst_difference"), 1e-9);
  expect_pictures("symmetry");
}

TEST_F(StudyCommand, SteeringWritesNumbersAndPictures) {
  const Json json = json_of({"steering", "--radius", "5"});
  EXPECT_EQ(json.at("examples").at(1).at("reeds_shepp").at("word"), "S-");
  expect_pictures("steering");
}

TEST_F(StudyCommand, SearchesShowsEveryPlannerOfTheFamilyInBothScenarios) {
  const Json json = json_of({"searches", "--iterations", "150"});
  std::map<std::string, std::set<std::string>> scenarios;
  for (const Json& run : json.at("runs")) {
    scenarios[run.at("planner")].insert(run.at("scenario").get<std::string>());
    EXPECT_LE(run.at("iterations"), 150) << run;
    EXPECT_NE(run.at("status"), "rejected") << run;
  }
  for (const char* planner : {"prm", "field-d-star", "rrt-opt-hlut-4", "anytime"}) {
    EXPECT_EQ(scenarios[planner], (std::set<std::string>{"3-h-shape", "7-cage-to-cage"}));
  }
  EXPECT_EQ(content_of(folder() + "/searches_3-h-shape_prm.csv").substr(0, 10), "shade,x,y\n");
  EXPECT_EQ(content_of(folder() + "/searches.csv").substr(0, 12), "run,scenario");
  expect_pictures("searches");
}

TEST_F(StudyCommand, SitesComparesSearchesOnASiteOfMine) {
  const std::string yard = folder_.put("yard.yaml", R"(
name: yard
vehicle: {wheelbase: 2.5, front_overhang: 0.8, rear_overhang: 0.8, width: 1.8, min_turning_radius: 4}
bounds: {x: [-15, 15], y: [-15, 15]}
start: {x: 9, y: 0, heading: 0}
goal: {x: 0, y: 0, heading: 0}
obstacles:
  - [[4, -8], [5, -8], [5, 8], [4, 8]]
)");
  const Json json = json_of({"sites", yard, "--starts", "1", "--time", "0.02", "--training", "99"});
  EXPECT_EQ(json.at("problems"), 1);
  EXPECT_EQ(json.at("searches").at(0).at("search"), "hybrid A*");
  EXPECT_EQ(json.at("searches").at(0).at("planners").back().at("planner"), "hybrid-a-star:site");
  EXPECT_EQ(json.at("searches").at(0).at("planners").back().at("solved"), 1);
  EXPECT_EQ(json.at("searches").at(0).at("networks").at(0).at("of"), "hybrid-a-star:site, network");
  EXPECT_GE(json.at("tables").size(), 3U);
  EXPECT_EQ(json.at("estimates").back().at("estimate"), "exact length or any-angle way");
  expect_pictures("sites");
  EXPECT_EQ(complaint({"sites", "--training", "0"}).substr(0, 11), "--training:");
  EXPECT_EQ(complaint({"sites", "--starts", "0"}).substr(0, 9), "--starts:");
  EXPECT_EQ(complaint({"sites", folder_ / "none.yaml"}),
            (folder_ / "none.yaml") + ": cannot open: No such file or directory");
}

TEST_F(StudyCommand, TheSameSeedGivesTheSameNumbers) {
  const auto csv_of = [&](const char* seed) {
    json_of({"range", "--pairs", "50", "--seed", seed});
    return content_of(folder() + "/range.csv");
  };
  const std::string first = csv_of("1");
  EXPECT_NE(csv_of("2"), first);
  EXPECT_EQ(csv_of("1"), first);
}

TEST_F(StudyCommand, WithoutGnuplotTheNumbersAreThereAndOneLineSaysWhatToInstall) {
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", folder_.path().c_str(), 1);
  const Outcome outcome = run_vandplan({"study", "steering", "-o", folder()});
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err,
            "vandplan: no pictures, because gnuplot is not installed (Debian: apt install "
            "gnuplot-nox); once it is: cd '" +
                folder() + "' && gnuplot steering.gp\n");
  EXPECT_NE(content_of(folder() + "/steering.csv"), "");
  EXPECT_NE(content_of(folder() + "/steering.gp"), "");
  EXPECT_FALSE(std::filesystem::exists(folder() + "/steering.png"));
  // And the script does what the line says.
  const std::string call = "cd '" + folder() + "' && gnuplot steering.gp";
  EXPECT_EQ(std::system(call.c_str()), 0);
  expect_pictures("steering");
}

TEST_F(StudyCommand, AGnuplotThatFailsIsToldOf) {
  folder_.put("gnuplot", "#!/bin/sh\necho out of ink\nexit 3\n");
  std::filesystem::permissions(folder_ / "gnuplot", std::filesystem::perms::owner_all);
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", (folder_.path() + ":" + path).c_str(), 1);
  const Outcome outcome = run_vandplan({"study", "steering", "-o", folder()});
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("steering.gp: out of ink"), std::string::npos) << outcome.err;
}

TEST_F(StudyCommand, RefusesBadInput) {
  EXPECT_EQ(complaint({}),
            "study: a study is missing, expected range, accuracy, trailer-accuracy, "
            "growth, symmetry, steering, searches or sites");
  EXPECT_EQ(complaint({"range", "--radius", "-7"}), "--radius: is -7, expected 0.001 to 1000000 m");
  EXPECT_EQ(complaint({"range", "--reach", "nan"}), "--reach: is nan, expected 0.001 to 1000000 m");
  EXPECT_EQ(complaint({"searches", "--iterations", "0"}).substr(0, 13), "--iterations:");
  EXPECT_EQ(complaint({"accuracy", "--pairs", "0"}).substr(0, 8), "--pairs:");
  EXPECT_EQ(complaint({"accuracy", "--pairs", "100000000000"}).substr(0, 8), "--pairs:");
  EXPECT_EQ(complaint({"accuracy", "--table", folder_ / "none"}),
            (folder_ / "none") + ": cannot open: No such file or directory");
  EXPECT_EQ(complaint({"growth", "--pairs", "5"}).substr(0, 24), "--pairs: unknown option,");
}

TEST_F(StudyCommand, RefusesAFolderThatCannotBeMade) {
  const std::string file = folder_.put("file", "");
  EXPECT_EQ(complaint({"steering", "-o", file}),
            file + ": cannot be made a folder: Not a directory");
  EXPECT_EQ(complaint({"steering", "-o", file + "/x"}),
            file + "/x: cannot be made a folder: Not a directory");
}

}  // namespace
}  // namespace vandplan
