// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>

#include "support/process.h"
#include "support/shared_files.h"
#include "support/yard.h"
#include "vandplan/planner.h"

namespace vandplan {
namespace {

using Json = nlohmann::json;

TEST(CommandLine, VersionIsOneLine) {
  const Outcome outcome = run_vandplan({"--version"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out.substr(0, 9), "vandplan ");
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 1);
}

// A commit in brackets, unless nobody knows it.
TEST(CommandLine, VersionNamesTheCommit) {
  const std::string text = run_vandplan({"--version"}).out;
  if (!std::filesystem::exists(repository() / ".git")) GTEST_SKIP() << "not a checkout";
  EXPECT_TRUE(std::regex_match(
      text, std::regex("vandplan [0-9]+\\.[0-9]+\\.[0-9]+ \\([0-9a-f]{7,40}(\\+changes)?\\)\n")))
      << text;
}

/// The page shows the help of every command as it is.
TEST(CommandLine, APageHoldsTheHelpOfEveryCommand) {
  const std::string page = content_of(repository() / "app/help.md");
  const std::vector<std::vector<std::string>> commands = {{},
                                                          {"plan"},
                                                          {"check"},
                                                          {"draw"},
                                                          {"smooth"},
                                                          {"speed"},
                                                          {"drive"},
                                                          {"evaluate"},
                                                          {"table", "build"},
                                                          {"table", "info"},
                                                          {"table", "check"},
                                                          {"table", "export"},
                                                          {"study", "range"},
                                                          {"study", "accuracy"},
                                                          {"study", "trailer-accuracy"},
                                                          {"study", "growth"},
                                                          {"study", "symmetry"},
                                                          {"study", "steering"},
                                                          {"study", "searches"},
                                                          {"convert", "geojson"},
                                                          {"convert", "lanelet2"},
                                                          {"convert", "opendrive"},
                                                          {"convert", "commonroad"},
                                                          {"convert", "tpcap"},
                                                          {"convert", "movingai"},
                                                          {"convert", "dynobench"},
                                                          {"convert", "footprint"},
                                                          {"planners"}};
  for (std::vector<std::string> command : commands) {
    command.push_back("--help");
    const Outcome outcome = run_vandplan(command);
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_NE(page.find("```\n" + outcome.out + "```\n"), std::string::npos)
        << "app/help.md is not up to date, see tools/update_help";
  }
}

TEST(CommandLine, HelpOnPlanFitsAScreen) {
  std::istringstream help(run_vandplan({"plan", "--help"}).out);
  int lines = 0;
  for (std::string line; std::getline(help, line); ++lines) EXPECT_LE(line.size(), 100U) << line;
  EXPECT_LE(lines, 75);
  EXPECT_GE(lines, 30);
}

TEST(PlannersCommand, ListsTheOptionsOfAll) {
  const Outcome outcome = run_vandplan({"planners", "--options"});
  EXPECT_EQ(outcome.status, 0);
  for (const Planner& planner : planners()) {
    for (const OptionInfo& info : planner.options) {
      EXPECT_NE(outcome.out.find("\n  " + info.name + "="), std::string::npos) << info.name;
    }
  }
  EXPECT_NE(content_of(repository() / "app/help.md").find("```\n" + outcome.out + "```\n"),
            std::string::npos);
}

// An option that families share stands there once, with their names.
TEST(PlannersCommand, SaysOnceWhatFamiliesShare) {
  const std::string list = run_vandplan({"planners", "--options"}).out;
  const std::string flat = std::regex_replace(list, std::regex("\\s+"), " ");
  const std::string region =
      " region=bounds sampling region; bounds or scene (anytime, rrt-... (28), prm, hrrt-... (3), "
      "rrt-connect, rrt-star) ";
  const std::size_t place = flat.find(region);
  ASSERT_NE(place, std::string::npos) << list;
  EXPECT_EQ(flat.find(" region="), place);
  EXPECT_EQ(flat.rfind(" region="), place);
  EXPECT_LT(place, flat.find(" Keys of anytime alone: min_stroke="));
  EXPECT_NE(list.find("\nKeys of rrt-... (28) alone:\n"), std::string::npos) << list;
  EXPECT_EQ(list.find("Keys of rrt-connect alone:\nKeys"), std::string::npos) << list;
}

TEST(PlannersCommand, ListsEveryPlannerAndMarksTheDefault) {
  const Outcome text = run_vandplan({"planners"});
  EXPECT_EQ(text.status, 0);
  const auto lines = std::count(text.out.begin(), text.out.end(), '\n');
  EXPECT_EQ(lines, static_cast<std::ptrdiff_t>(planners().size()));
  const std::size_t mark = text.out.find("(the default)\n");
  ASSERT_NE(mark, std::string::npos);
  const std::size_t line = text.out.rfind('\n', mark) + 1;
  EXPECT_EQ(text.out.substr(line, default_planner().name.size()), default_planner().name);

  const Json json = Json::parse(run_vandplan({"planners", "--json"}).out);
  EXPECT_EQ(json.at("default"), default_planner().name);
  EXPECT_EQ(json.at("planners").size(), planners().size());
}

TEST(PlannersCommand, OnePlannerIsToldWithItsOptions) {
  const Outcome text = run_vandplan({"planners", "rrt-bsc-euc"});
  EXPECT_EQ(text.status, 0) << text.err;
  EXPECT_NE(text.out.find("\n  goal_bias=0.05 "), std::string::npos) << text.out;
  EXPECT_EQ(text.out.find("reverse_weight"), std::string::npos) << text.out;
  const Json json = Json::parse(run_vandplan({"planners", "rrt-bsc-euc", "--json"}).out);
  EXPECT_EQ(json.at("properties").at("family"), "rrt");
  EXPECT_EQ(json.at("properties").at("capabilities"), Json({"gears", "steering", "trailers"}));
  EXPECT_EQ(json.at("properties").at("honours_steering"), true);
  EXPECT_EQ(json.at("properties").at("honours_prices"), false);
  EXPECT_EQ(json.at("options").at(0).contains("range"), true);
  EXPECT_EQ(run_vandplan({"planners", "best"}).status, 2);
}

// ---- draw ----

class DrawCommand : public testing::Test {
 protected:
  void SetUp() override { write_content(scenario_, yard()); }

  TemporaryFolder folder_;
  const std::string scenario_ = folder_ / "yard.yaml";
};

TEST_F(DrawCommand, DrawsASceneWithoutAResult) {
  const std::string file = folder_ / "yard.png";
  const Outcome outcome = run_vandplan({"draw", scenario_, "-o", file});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(content_of(file).substr(0, 4), "\x89PNG");
}

TEST_F(DrawCommand, DrawsWhatPlanDraws) {
  const std::string result = folder_ / "result.json";
  const std::string planned = folder_ / "planned.svg";
  const std::string drawn = folder_ / "drawn.svg";
  ASSERT_EQ(run_vandplan({"plan", scenario_, "--planner", "rrt-opt-euc-goal", "--max-iterations",
                          "300", "--set", "keep_tree=true", "--output", result, "--draw", planned})
                .status,
            0);
  const Outcome outcome = run_vandplan({"draw", scenario_, result, "-o", drawn, "--json"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(Json::parse(outcome.out).at("output"), drawn);
  EXPECT_NE(content_of(drawn), "");
  EXPECT_TRUE(content_of(drawn) == content_of(planned));
}

TEST_F(DrawCommand, AStripOfCurvatureIsThereOnRequest) {
  const std::string result = folder_ / "result.json";
  const std::string planned = folder_ / "planned.svg";
  const std::string drawn = folder_ / "drawn.svg";
  const std::string plain = folder_ / "plain.svg";
  ASSERT_EQ(run_vandplan({"plan", scenario_, "--max-iterations", "300", "--output", result,
                          "--draw", planned, "--curvature-strip"})
                .status,
            0);
  ASSERT_EQ(run_vandplan({"draw", scenario_, result, "-o", plain}).status, 0);
  ASSERT_EQ(run_vandplan({"draw", scenario_, result, "-o", drawn, "--curvature-strip"}).status, 0);
  EXPECT_TRUE(content_of(drawn) == content_of(planned));
  EXPECT_GT(content_of(drawn).size(), content_of(plain).size());

  EXPECT_EQ(run_vandplan({"draw", scenario_, "-o", drawn, "--curvature-strip"}).status, 2);
  write_content(scenario_, replaced(yard(), "goal: {x: 20, y: 5, heading: 0}",
                                    "goals: [{distance: 1, goal: {x: 20, y: 5, heading: 0}}]"));
  const Outcome row = run_vandplan({"plan", scenario_, "--draw", drawn, "--curvature-strip"});
  EXPECT_EQ(row.status, 2);
  EXPECT_EQ(row.err,
            "vandplan: --curvature-strip: is for one path, the scenario has a row of goals\n");
}

TEST_F(DrawCommand, NothingIsDrawnOfBadInput) {
  const std::string file = folder_ / "yard.pdf";
  write_content(scenario_, replaced(yard(), "width: 2.55", "width: wide"));
  EXPECT_EQ(run_vandplan({"draw", scenario_, "-o", file}).status, 2);
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST_F(DrawCommand, OutputIsNeeded) {
  const Outcome outcome = run_vandplan({"draw", scenario_});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err, "vandplan: --output is required\n");
}

// ---- convert ----

TEST(ConvertCommand, AFootprintTurnsByItsRadiusOrItsSteeringAngle) {
  const TemporaryFolder folder;
  write_content(folder / "footprint.yaml", "[[4, 1], [4, -1], [-1, -1], [-1, 1]]");
  const auto convert = [&](std::vector<std::string> how) {
    how.insert(how.begin(), {"convert", "footprint", folder / "footprint.yaml", "--wheelbase",
                             "2.5", "-o", folder / "car.yaml"});
    return run_vandplan(how);
  };
  EXPECT_EQ(convert({"--max-steering-angle", "0.5"}).status, 0);
  EXPECT_NE(content_of(folder / "car.yaml").find("min_turning_radius: 4.576"), std::string::npos);
  EXPECT_EQ(convert({}).err,
            "vandplan: --min-turning-radius: is missing, expected it or --max-steering-angle\n");
  EXPECT_EQ(convert({"--min-turning-radius", "4", "--max-steering-angle", "0.5"}).status, 2);
  const Outcome degrees = convert({"--max-steering-angle", "35"});
  EXPECT_EQ(degrees.status, 2);
  EXPECT_NE(degrees.err.find("max_steering_angle: is 35, expected more than 0"), std::string::npos);
}

TEST(ConvertCommand, ASiteBecomesAScenarioThatIsPlanned) {
  const TemporaryFolder folder;
  write_content(folder / "footprint.yaml", "[[4, 1], [4, -1], [-1, -1], [-1, 1]]");
  const Outcome vehicle =
      run_vandplan({"convert", "footprint", folder / "footprint.yaml", "--wheelbase", "2.5",
                    "--min-turning-radius", "4", "-o", folder / "car.yaml"});
  ASSERT_EQ(vehicle.status, 0) << vehicle.err;
  EXPECT_NE(vehicle.out.find("a rectangle of 5.000 x 2.000 m"), std::string::npos) << vehicle.out;
  EXPECT_NE(vehicle.out.find("added: 0.0000 m2, 0.0 %"), std::string::npos) << vehicle.out;
  write_content(folder / "site.geojson",
                R"({"type": "FeatureCollection", "features": [{"type": "Feature",
                "properties": {"barrier": "wall"}, "geometry": {"type": "LineString",
                "coordinates": [[10, -8], [10, 3]]}}]})");
  const std::string scenario = folder / "site.yaml";
  const Outcome converted = run_vandplan({"convert", "geojson", folder / "site.geojson", "--metres",
                                          "--start", "-3,0,0", "--goal", "20,-2.5,0", "--vehicle",
                                          folder / "car.yaml", "-o", scenario, "--json"});
  ASSERT_EQ(converted.status, 0) << converted.err;
  EXPECT_EQ(Json::parse(converted.out)["scenario"], "site");
  EXPECT_EQ(run_vandplan({"plan", scenario, "--max-iterations", "500"}).status, 0);
  EXPECT_EQ(run_vandplan({"convert", "geojson", folder / "site.geojson", "--metres", "--start",
                          "1,2", "-o", scenario})
                .err,
            "vandplan: --start: is 1,2, expected X,Y,HEADING\n");
}

TEST(ConvertCommand, UnknownFormatIsNamed) {
  const Outcome outcome = run_vandplan({"convert", "dxf", "a.dxf"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("dxf"), std::string::npos) << outcome.err;
  EXPECT_EQ(
      run_vandplan({"convert"}).err,
      "vandplan: convert: a format is missing, expected geojson, lanelet2, opendrive, commonroad, "
      "tpcap, movingai, dynobench or footprint\n");
}

TEST(ConvertCommand, MapsOfRoadsBecomeScenariosThatPlan) {
  const TemporaryFolder folder;
  const std::string scenario = folder / "road.yaml";
  const auto converted = [&](const std::string& format, const std::string& file,
                             const std::string& goal) {
    const Outcome outcome =
        run_vandplan({"convert", format, (repository() / "examples" / file).string(), "--start",
                      "5,-1.75,0", "--goal", goal, "-o", scenario});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(run_vandplan({"plan", scenario, "--max-iterations", "2000"}).status, 0);
    return outcome.out + outcome.err;
  };
  EXPECT_NE(converted("lanelet2", "lanelets.osm", "30,-9,0").find("  lanes: 2, areas: 1"),
            std::string::npos);
  EXPECT_NE(converted("opendrive", "road.xodr", "51.75,50,1.5708")
                .find("vandplan: warning: left out: lane sidewalk (1)\n"),
            std::string::npos);
  EXPECT_NE(content_of(scenario).find("zones:\n"), std::string::npos);
  const Outcome bad = run_vandplan(
      {"convert", "lanelet2", "a.osm", "--start", "1,2", "--goal", "1,2,3", "-o", scenario});
  EXPECT_EQ(bad.err, "vandplan: --start: is 1,2, expected X,Y,HEADING\n");
}

TEST(ConvertCommand, ACommonRoadScenarioIsSolvedInItsFormat) {
  const TemporaryFolder folder;
  const std::string street = (repository() / "examples" / "street.xml").string();
  const std::string scenario = folder / "street.yaml";
  const std::string result = folder / "result.json";
  const std::string solution = folder / "solution.xml";
  ASSERT_EQ(run_vandplan({"convert", "commonroad", street, "-o", scenario}).status, 0);
  ASSERT_EQ(run_vandplan({"plan", scenario, "--max-iterations", "3000", "--output", result}).status,
            0);
  const Outcome outcome =
      run_vandplan({"convert", "commonroad", street, "--solution", result, "-o", solution});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(content_of(solution).find("<ksTrajectory planningProblem=\"5\">"), std::string::npos);
  EXPECT_EQ(run_vandplan({"convert", "commonroad", street, "--solution", result, "--vehicle", "van",
                          "-o", solution})
                .status,
            2);
  // A path through the parked car is no solution.
  write_content(
      result, R"({"format": "vandplan-result/1", "path": {"start": {"x": 6, "y": -2, "heading": 0},
                "segments": [{"turn": "straight", "length": 60}]}})");
  const Outcome refused = run_vandplan(
      {"convert", "commonroad", street, "--solution", result, "-o", folder / "none.xml"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_FALSE(std::filesystem::exists(folder / "none.xml"));
}

TEST(ConvertCommand, TpcapCaseBecomesAScenarioThatPlans) {
  // Ten metres ahead, with one obstacle of four corners far to the side.
  const TemporaryFolder folder;
  const std::string scenario = folder / "case.yaml";
  write_content(folder / "case.csv", "0,0,0,10,0,0,1,4,30,20,31,20,31,21,30,21\n");
  const Outcome converted = run_vandplan({"convert", "tpcap", folder / "case.csv", "-o", scenario});
  ASSERT_EQ(converted.status, 0) << converted.err;
  EXPECT_EQ(run_vandplan({"plan", scenario, "--max-iterations", "100"}).status, 0);
}

TEST(ConvertCommand, WhatCannotBeWrittenLeavesNoMapBehind) {
  const TemporaryFolder folder;
  write_content(folder / "a.map", "type octile\nheight 1\nwidth 2\nmap\n..\n");
  write_content(folder / "a.scen", "version 1\n0\ta.map\t2\t1\t0\t0\t1\t0\t1\n");
  std::filesystem::create_directory(folder / "yard.yaml");
  const Outcome outcome = run_vandplan(
      {"convert", "movingai", folder / "a.map", folder / "a.scen", "-o", folder / "yard.yaml"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err,
            "vandplan: " + (folder / "yard.yaml") + ": cannot write: Is a directory\n");
  EXPECT_EQ(folder.names().size(), 3U);
}

}  // namespace
}  // namespace vandplan
