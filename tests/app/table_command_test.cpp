// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>
#include <numbers>
#include <vector>

#include "support/process.h"
#include "vandplan/tables.h"

namespace vandplan {
namespace {

using Json = nlohmann::json;

class TableCommand : public testing::Test {
 protected:
  Json json_of(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "table");
    arguments.push_back("--json");
    const Outcome outcome = run_vandplan(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return Json::parse(outcome.out);
  }

  /// The one line that a refusal is, without the program's name; nothing is left behind.
  std::string complaint(std::vector<std::string> arguments, const ProcessOptions& options = {}) {
    const std::vector<std::string> before = folder_.names();
    arguments.insert(arguments.begin(), "table");
    const Outcome outcome = run_vandplan(arguments, options);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(folder_.names().size(), before.size());
    const std::string name = "vandplan: ";
    EXPECT_EQ(outcome.err.substr(0, name.size()), name);
    return outcome.err.substr(name.size(), outcome.err.size() - name.size() - 1);
  }

  /// What `info` says of a file with this content, after the file's name.
  std::string complaint_about(const std::string& content) {
    write_content(file_, content);
    const std::string text = complaint({"info", file_});
    EXPECT_EQ(text.substr(0, file_.size() + 2), file_ + ": ");
    return text.substr(std::min(text.size(), file_.size() + 2));
  }

  /// The bytes that a compiler makes of the entries in table.h. The header stands alone, and the
  /// language is the oldest one it is for.
  std::string compiled_entries(const std::string& space, const std::string& checks) {
    write_content(folder_ / "main.cpp", "#include \"table.h\"\n#include <cstdio>\nint main() {" +
                                            checks + "\n  return std::fwrite(" + space +
                                            "::entries, sizeof " + space +
                                            "::entries, 1, stdout) == 1 ? 0 : 1;\n}\n");
    const std::string compile = std::string(VANDPLAN_COMPILER) +
                                " -std=c++17 -Wall -Wextra -Werror '" + (folder_ / "main.cpp") +
                                "' -o '" + (folder_ / "main") + "'";
    EXPECT_EQ(std::system(compile.c_str()), 0);
    EXPECT_EQ(std::system(((folder_ / "main") + " > " + (folder_ / "entries")).c_str()), 0);
    return content_of(folder_ / "entries");
  }

  TemporaryFolder folder_;
  const std::string file_ = folder_ / "my.table";
};

// ---- build and info ----

TEST_F(TableCommand, BuildsTheTablesOfTheThesisByName) {
  for (int number = 1; number <= 4; ++number) {
    const std::string name = "hlut-" + std::to_string(number);
    const Json json = json_of({"build", name, "-o", file_});
    EXPECT_EQ(json.at("thesis_table"), name);
    EXPECT_EQ(content_of(file_), table_to_bytes(thesis_table(number))) << name;
  }
}

TEST_F(TableCommand, BuildsAnyOtherTable) {
  json_of({"build", "hlut-3", "--extent", "6", "--step", "1.5", "--radius", "5", "-o", file_});
  const HeuristicTable table = table_from_bytes(content_of(file_), file_);
  const HeuristicTableOptions options{
      .extent = 6.0, .step = 1.5, .heading_cells = 24, .turning_radius = 5.0};
  EXPECT_EQ(table.options(), options);
  EXPECT_TRUE(std::ranges::equal(table.entries(), HeuristicTable(options).entries()));

  json_of({"build", "--headings", "6", "-o", file_});
  EXPECT_EQ(table_from_bytes(content_of(file_), file_).options(),
            (HeuristicTableOptions{.extent = 10, .step = 1, .heading_cells = 6}));
}

TEST_F(TableCommand, InfoSaysWhatAFileHolds) {
  json_of({"build", "hlut-4", "-o", file_});
  const Json json = json_of({"info", file_});
  EXPECT_EQ(json.at("content"), "Reeds-Shepp lengths");
  EXPECT_EQ(json.at("thesis_table"), "hlut-4");
  EXPECT_EQ(json.at("turning_radius"), 7.0);
  EXPECT_EQ(json.at("extent"), 30.0);
  EXPECT_EQ(json.at("step"), 1.0);
  EXPECT_EQ(json.at("positions"), 31);
  EXPECT_EQ(json.at("headings"), 25);
  EXPECT_EQ(json.at("entries"), 600'625);
  EXPECT_EQ(json.at("bytes"), content_of(file_).size());
  const Outcome text = run_vandplan({"table", "info", file_});
  EXPECT_NE(text.out.find("0 to 30 m in steps of 1 m: 31 positions each"), std::string::npos);
  EXPECT_NE(text.out.find("in steps of pi/12: 25 each"), std::string::npos);
  EXPECT_NE(text.out.find("600625"), std::string::npos);
  EXPECT_NE(text.out.find(json.at("checksum")), std::string::npos);
}

TEST_F(TableCommand, FilesGoThroughPipes) {
  const std::string piped = folder_ / "piped";
  ASSERT_EQ(run_vandplan({"table", "build", "hlut-1", "-o", "-"}, {.output = piped}).status, 0);
  EXPECT_EQ(content_of(piped), table_to_bytes(thesis_table(1)));
  const Outcome outcome = run_vandplan({"table", "info", "-"}, {.input = piped});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out.substr(0, 16), "standard input: ");
}

TEST_F(TableCommand, TheTableOfBoundsIsAFileToo) {
  json_of({"build", "bounds", "-o", file_});
  EXPECT_EQ(content_of(file_), bound_table_to_bytes());
  const Json info = json_of({"info", file_});
  EXPECT_EQ(info.at("content"), "bounds of Reeds-Shepp lengths");
  EXPECT_EQ(info.at("entries"), info.at("cells").at("radial").get<int>() *
                                    info.at("cells").at("side").get<int>() *
                                    info.at("cells").at("turn").get<int>());
  const Json check = json_of({"check", file_, "--sample", "10000"});
  EXPECT_EQ(check.at("pairs"), 10'000);
  EXPECT_EQ(check.at("outside"), 0);
  EXPECT_EQ(check.at("same_as_library"), true);
}

// ---- check ----

TEST_F(TableCommand, CheckRecomputesEveryEntry) {
  const Json json = json_of({"check", "hlut-3"});
  EXPECT_EQ(json.at("compared"), 75'625);
  EXPECT_EQ(json.at("wrong"), 0);
  EXPECT_GT(json.at("worst_difference"), 0.0);
  EXPECT_LT(json.at("worst_difference"), 1e-5);
  EXPECT_EQ(json_of({"check", "hlut-3", "--sample", "500"}).at("compared"), 500);
}

TEST_F(TableCommand, CheckFailsForAWrongEntryBehindARightChecksum) {
  const HeuristicTable good = thesis_table(1);
  std::vector<float> entries(good.entries().begin(), good.entries().end());
  entries[good.index_of({4, 3, 2, 1})] += 0.25F;
  write_content(file_, table_to_bytes({good.options(), entries}));
  const Outcome outcome = run_vandplan({"table", "check", file_});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.out.find("worst difference 0.25 m, from x 4 m, y 3 m"), std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("WRONG: 1 "), std::string::npos);
}

// ---- export ----

TEST_F(TableCommand, ExportedHeaderCompilesToTheSameEntries) {
  const std::string header = folder_ / "table.h";
  EXPECT_EQ(json_of({"export", "hlut-3", "-o", header}).at("namespace"), "hlut_3");
  const std::string bytes = compiled_entries("hlut_3", R"(
  static_assert(hlut_3::turning_radius == 7 && hlut_3::extent == 10 && hlut_3::step == 1);
  static_assert(hlut_3::heading_cells == 24 && hlut_3::headings == 25 && hlut_3::positions == 11);)");
  const HeuristicTable table(thesis_table_options(3));
  ASSERT_EQ(bytes.size(), table.entries().size_bytes());
  for (std::size_t i = 0; i < table.entries().size(); ++i) {
    float entry = 0.0F;
    std::memcpy(&entry, &bytes[i * sizeof entry], sizeof entry);
    ASSERT_EQ(entry, table.entries()[i]) << i;
  }
}

TEST_F(TableCommand, ExportedBoundsCompileToTheSameEntries) {
  json_of({"export", "bounds", "-o", folder_ / "table.h"});
  const std::string bytes = compiled_entries("bounds", R"(
  static_assert(bounds::radial_cells * bounds::side_cells * bounds::turn_cells * 2 ==
                sizeof bounds::entries / sizeof(unsigned));)");
  EXPECT_TRUE(bytes == bound_table_to_bytes().substr(table_file_head_size));
}

/// The planes of a cell, as docs/formats.md says to use them, give what the look-up gives.
TEST_F(TableCommand, ExportedPlanesAreTheBounds) {
  const std::string csv = folder_ / "bounds.csv";
  json_of({"export", "bounds", "-o", csv});
  const Json cells = json_of({"info", "bounds"}).at("cells");
  std::ifstream lines(csv);
  std::string line;
  std::getline(lines, line);
  int compared = 0;
  for (int count = 0; std::getline(lines, line); ++count) {
    if (count % 997 != 0) continue;  // not the first one, where lengths are not smooth
    double radial, side, turn, base, width, slope_radial, slope_side, slope_turn;
    ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf", &radial, &side, &turn,
                          &base, &width, &slope_radial, &slope_side, &slope_turn),
              8);
    const double u = (radial + 0.25) / cells.at("radial").get<double>();
    const double v = (side + 0.5) / cells.at("side").get<double>();
    const double r = 4.0 * u / (1.0 - u);
    const double bearing = std::atan2(v, 1.0 - v);
    const double half = (turn + 0.75) / cells.at("turn").get<double>() * std::numbers::pi / 2;
    const LengthBounds bounds =
        length_bounds({0.0, 0.0, -half}, {r * std::cos(bearing), r * std::sin(bearing), half}, 1.0);
    const double excess = base + 0.25 * slope_radial + 0.5 * slope_side + 0.75 * slope_turn;
    EXPECT_NEAR(bounds.high, r + excess + width, 1e-3 + 1e-5 * r) << line;
    EXPECT_NEAR(bounds.low, std::max(r + std::max(excess, 0.0), 2 * half), 1e-3 + 1e-5 * r) << line;
    ++compared;
  }
  EXPECT_GT(compared, 100);
}

TEST_F(TableCommand, ExportedCsvHasALineForEveryEntry) {
  json_of({"build", "--extent", "2", "--headings", "4", "--radius", "1", "-o", file_});
  const std::string csv = folder_ / "my.csv";
  EXPECT_EQ(json_of({"export", file_, "-o", csv}).at("format"), "csv");
  const std::string text = content_of(csv);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1 + 3 * 3 * 5 * 5);
  EXPECT_EQ(text.substr(0, text.find('\n')), "x,y,heading_node,heading_sample,length");
  EXPECT_NE(text.find("\n2,0,0,0,2\n"), std::string::npos);  // two metres straight back
}

// ---- bad input ----

TEST_F(TableCommand, RefusesAFileThatIsNotATable) {
  EXPECT_EQ(complaint_about(""), "is empty, expected a table file");
  EXPECT_EQ(complaint_about("name: yard\n"), "not a table file: does not start with 'vp-table'");
}

TEST_F(TableCommand, RefusesATruncatedAnAlteredAndANewerFile) {
  const std::string good = table_to_bytes(thesis_table(1));
  EXPECT_EQ(complaint_about(good.substr(0, 20)), "truncated: 20 bytes, the header alone has 96");
  EXPECT_EQ(complaint_about(good.substr(0, 1000)), "truncated: 1000 bytes, expected 96 + 4 * 9801");
  std::string altered = good;
  altered[5000] = static_cast<char>(altered[5000] ^ 1);
  EXPECT_EQ(complaint_about(altered), "altered: the checksum does not fit the content");
  std::string newer = good;
  newer[12] = 2;
  EXPECT_EQ(complaint_about(newer), "version 2 of the format, this program reads version 1");
}

TEST_F(TableCommand, RefusesAHugeFileWithoutReadingIt) {
  write_content(file_, "");
  std::filesystem::resize_file(file_, 20'000'000'000);  // a hole: no disk, and must be no memory
  EXPECT_EQ(complaint({"info", file_}),
            file_ + ": not a table file: does not start with 'vp-table'");
  write_content(file_, table_to_bytes(thesis_table(1)));
  std::filesystem::resize_file(file_, 20'000'000'000);
  EXPECT_EQ(complaint({"check", file_}), file_ + ": is too large, expected at most 39300 bytes");
  std::string boasting = table_to_bytes(thesis_table(1));
  boasting[87] = 1;  // the highest byte of the count
  EXPECT_EQ(complaint_about(boasting),
            "says that it holds 72057594037937737 entries, expected at most 268435456");
}

TEST_F(TableCommand, RefusesAFileThatIsNotThereOrAFolder) {
  EXPECT_EQ(complaint({"info", folder_ / "none"}),
            (folder_ / "none") + ": cannot open: No such file or directory");
  EXPECT_EQ(complaint({"check", folder_.path()}), folder_.path() + ": cannot read: Is a directory");
}

TEST_F(TableCommand, RefusesAbsurdSizesBeforeItTakesMemory) {
  EXPECT_EQ(complaint({"build", "--extent", "300", "--headings", "100", "-o", file_}),
            "--step: the table would hold 924220801 entries, expected at most 268435456");
  EXPECT_EQ(complaint({"build", "--step", "1e-6", "-o", file_}).substr(0, 29),
            "--step: the table would hold ");
}

TEST_F(TableCommand, RefusesOptionsOutOfRange) {
  const auto build = [&](const char* flag, const char* value) {
    return complaint({"build", flag, value, "-o", file_});
  };
  EXPECT_EQ(build("--extent", "-1"), "--extent: is -1, expected more than 0 m");
  EXPECT_EQ(build("--extent", "nan"), "--extent: is nan, expected more than 0 m");
  EXPECT_EQ(build("--step", "3"), "--extent: is 10, expected a multiple of the step");
  EXPECT_EQ(build("--headings", "0"), "--headings: is 0, expected at least 1");
  EXPECT_EQ(build("--radius", "0"), "--radius: is 0, expected more than 0 m");
  EXPECT_EQ(build("--radius", "R"), "--radius: \"R\" is not a number in range");
  EXPECT_EQ(complaint({"build", "hlut-5", "-o", file_}),
            "table: \"hlut-5\" is unknown, expected hlut-1 to hlut-4 or bounds");
  EXPECT_EQ(complaint({"build", "bounds", "--step", "1", "-o", file_}),
            "bounds: has no options: one table serves every radius and distance");
}

TEST_F(TableCommand, RefusesAnOutputThatCannotBeWritten) {
  EXPECT_EQ(complaint({"build", "-o", folder_ / "none/x"}),
            (folder_ / "none/x") + ": cannot write: No such file or directory");
  EXPECT_EQ(complaint({"build", "-o", folder_.path()}),
            folder_.path() + ": cannot write: Is a directory");
  EXPECT_EQ(complaint({"export", "hlut-1", "-o", folder_ / "x.txt"}),
            (folder_ / "x.txt") + ": must end in .h, .hpp or .csv, or --format must be given");
  EXPECT_EQ(complaint({"export", "hlut-1", "--name", "a-b", "-o", folder_ / "x.h"}),
            "name: \"a-b\" is not a C++ identifier");
}

TEST_F(TableCommand, AFullDiskLeavesTheOldFile) {
  write_content(file_, "old");
  EXPECT_EQ(complaint({"build", "-o", file_}, {.largest_file = 100}),
            file_ + ": cannot write: File too large");
  EXPECT_EQ(content_of(file_), "old");
}

TEST_F(TableCommand, NeedsACommand) {
  EXPECT_EQ(complaint({}),
            "table: a command is missing, expected build, info, check, export or site");
}

// ---- tables of a site ----

constexpr const char* yard =
    "name: yard\n"
    "vehicle: {wheelbase: 4.5, front_overhang: 1.4, rear_overhang: 1.6, width: 2.55, "
    "min_turning_radius: 7.0}\n"
    "bounds: {x: [-30, 30], y: [-30, 30]}\n"
    "obstacles: [[[-5, 5], [15, 5], [15, 6], [-5, 6]]]\n"
    "goal: {x: 0, y: 0, heading: 0}\n";

std::string yard_from(const std::string& start) { return yard + ("start: " + start + "\n"); }

TEST_F(TableCommand, OfASiteIsTheBeginOfAPlan) {
  write_content(folder_ / "a.yaml", yard_from("{x: 10, y: 15, heading: 3}"));
  write_content(folder_ / "b.yaml", yard_from("{x: -17, y: 9, heading: 1}"));
  const std::string table = folder_ / "yard.vst";
  const Json made = json_of({"site", folder_ / "a.yaml", "-o", table});
  EXPECT_EQ(made["goals"], 1);
  EXPECT_EQ(made["bytes"], content_of(table).size());
  const Json info = json_of({"info", table});
  EXPECT_EQ(info["goals"].size(), 1U);
  EXPECT_EQ(info["headings"], 36);
  EXPECT_EQ(info["bytes"], made["bytes"]);
  for (const char* scenario : {"a.yaml", "b.yaml"}) {
    const Outcome outcome = run_vandplan(
        {"plan", folder_ / scenario, "--site", table, "--max-iterations", "50", "--json"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(Json::parse(outcome.out)["status"], "solved");
  }
}

TEST_F(TableCommand, OfASiteGuidesSearches) {
  const std::string scenario = folder_ / "a.yaml";
  const std::string table = folder_ / "yard.vst";
  write_content(scenario, yard_from("{x: 10, y: 15, heading: 3}"));
  (void)json_of({"site", scenario, "--set", "style=shortest", "-o", table});
  const auto planned = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"plan", scenario, "--max-iterations", "20000", "--planner"});
    return run_vandplan(more);
  };
  for (const char* const planner : {"hybrid-a-star:site", "rrt-opt-site-goal"}) {
    const Outcome outcome = planned({planner, "--site", table, "--json"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(Json::parse(outcome.out)["planner"], planner);
    EXPECT_EQ(planned({planner}).err,
              "vandplan: site: the estimate needs a table of the site, expected --site FILE.vst, "
              "site=TABLE in Python, PlanOptions::site in C++\n");
  }
  EXPECT_EQ(planned({"hybrid-a-star:choi", "--site", table}).err,
            "vandplan: site: is for estimate=site or max_with=site\n");
  EXPECT_EQ(planned({"hybrid-a-star:site", "--site", table, "--set", "reverse_weight=3"}).err,
            "vandplan: " + table +
                ": the table was made for other options: prices (style), gears or margin differ\n");
}

TEST_F(TableCommand, OfASiteIsRefusedElsewhere) {
  const std::string scenario = folder_ / "a.yaml";
  const std::string table = folder_ / "yard.vst";
  write_content(scenario, yard_from("{x: 10, y: 15, heading: 3}"));
  write_content(folder_ / "docks.csv", "x,y,heading\n20,-10,1\n0,0,0\n");
  const Json made = json_of({"site", scenario, "--goals", folder_ / "docks.csv", "-o", table});
  EXPECT_EQ(made["goals"], 2);
  const auto planned = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"plan", scenario, "--site", table, "--max-iterations", "9"});
    return run_vandplan(more);
  };
  EXPECT_EQ(planned({}).status, 0);
  const Outcome dearer = planned({"--set", "reverse_weight=3"});
  EXPECT_EQ(dearer.status, 2);
  EXPECT_EQ(dearer.err,
            "vandplan: " + table +
                ": the table was made for other options: prices (style), gears or margin "
                "differ\n");
  const std::string bytes = content_of(table);
  write_content(table, bytes.substr(0, bytes.size() - 1));
  EXPECT_EQ(planned({}).err, "vandplan: " + table +
                                 ": truncated: " + std::to_string(bytes.size() - 1) +
                                 " bytes, expected " + std::to_string(bytes.size()) + "\n");
  const std::string output = folder_ / "x.vst";
  EXPECT_EQ(complaint({"site", scenario, "--cell", "9", "-o", output}),
            "--cell: expected 0.01 to 1 turning radii");
  write_content(folder_ / "docks.csv", "20,-10,1\n5,5.5,0\n");
  EXPECT_EQ(complaint({"site", scenario, "--goals", folder_ / "docks.csv", "-o", output}),
            (folder_ / "docks.csv") +
                ":2: is not free (of obstacles, or by zones), expected a pose "
                "where the vehicle can stand");
  write_content(folder_ / "docks.csv", "20,-10,1\n0,0\n");
  EXPECT_EQ(
      complaint({"site", scenario, "--goals", folder_ / "docks.csv", "-o", folder_ / "x.vst"}),
      (folder_ / "docks.csv") + ":2: has 2 values, expected x,y,heading");
}

TEST_F(TableCommand, OfASiteRefusesAPairBeforeItPlans) {
  const std::string scenario = folder_ / "a.yaml";
  const std::string table = folder_ / "yard.vst";
  const std::string pairs = folder_ / "pairs.csv";
  write_content(scenario, yard_from("{x: 10, y: 15, heading: 3}"));
  write_content(pairs, "10,15,3,0,0,0\n# to a dock that is not in the table\n-17,9,1,1,0,0\n");
  (void)json_of({"site", scenario, "-o", table});
  const auto planned = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"plan", scenario, "--poses", pairs, "--site", table,
                               "--max-iterations", "9", "--output", folder_ / "r.jsonl"});
    return run_vandplan(more);
  };
  const Outcome outcome = planned({});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err,
            "vandplan: " + pairs + ":3: the table has no such goal, expected one of its 1\n");
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(planned({"--set", "reverse_weight=3"}).err,
            "vandplan: " + table +
                ": the table was made for other options: prices (style), gears or margin differ\n");
  write_content(pairs, "10,15,3,0,0,0\n-17,9,1,0,0,0\n");
  EXPECT_EQ(planned({}).status, 0);
}

TEST_F(TableCommand, OfASiteTakesTheGoalsOfASet) {
  const std::string scenario = folder_ / "a.yaml";
  std::string text = yard_from("{x: 10, y: 15, heading: 3}");
  const std::string goal = "goal: {x: 0, y: 0, heading: 0}\n";
  const auto with_goal = [&](const std::string& other) {
    std::string changed = text;
    changed.replace(changed.find(goal), goal.size(), other + "\n");
    write_content(scenario, changed);
  };
  with_goal(
      "goal: {any_of: [{x: 0, y: 0, heading: 0, straight: 3}, {x: 5, y: 5.5, heading: 0}, "
      "{x: 20, y: -10, heading: 1}]}");
  const std::string table = folder_ / "yard.vst";
  const Outcome made = run_vandplan({"table", "site", scenario, "-o", table, "--json"});
  EXPECT_EQ(made.status, 0);
  EXPECT_EQ(made.err,
            "vandplan: warning: " + scenario + ": 1 of its goals are not free and left out\n");
  EXPECT_EQ(Json::parse(made.out)["goals"], 2);
  EXPECT_EQ(json_of({"info", table})["goals"], Json::parse("[[0, 0, 0], [20, -10, 1]]"));
  EXPECT_EQ(run_vandplan({"plan", scenario, "--site", table, "--max-iterations", "99"}).status, 0);
  with_goal("goal: {x: [0, 3], y: 0, heading: 0}");
  EXPECT_EQ(complaint({"site", scenario, "-o", table}),
            scenario +
                ": the goal of the scenario holds infinitely many poses, expected a list of "
                "poses: --goals FILE.csv");
}

TEST_F(TableCommand, OfASiteTakesARowOfGoalsInOneWorld) {
  const std::string scenario = folder_ / "row.yaml";
  const std::string table = folder_ / "row.vst";
  const auto with_obstacles = [&](const std::string& own) {
    std::string text = yard_from("{x: 10, y: 15, heading: 3}");
    const std::string goal = "goal: {x: 0, y: 0, heading: 0}\n";
    text.replace(text.find(goal), goal.size(),
                 "goals:\n  - {distance: 1, goal: {x: 0, y: 0, heading: 0}}\n"
                 "  - {distance: 2, goal: {x: 20, y: -10, heading: 1}" +
                     own + "}\n");
    write_content(scenario, text);
  };
  with_obstacles(", obstacles: [[[-20, -20], [-19, -20], [-19, -19]]]");
  EXPECT_EQ(complaint({"site", scenario, "-o", table}),
            scenario +
                ": goals[1] has other obstacles than goals[0], expected the same, as a table is of "
                "one world, or --goals FILE.csv");
  with_obstacles("");
  EXPECT_EQ(json_of({"site", scenario, "-o", table})["goals"], 2);
  EXPECT_EQ(run_vandplan({"plan", scenario, "--site", table, "--max-iterations", "99"}).status, 0);
}

TEST_F(TableCommand, OfASiteSaysWhichOptionsMeanNothing) {
  const std::string scenario = folder_ / "a.yaml";
  const std::string goals = folder_ / "goals.csv";
  const std::string table = folder_ / "yard.vst";
  write_content(scenario, yard_from("{x: 10, y: 15, heading: 3}"));
  write_content(goals, "0,0,0\n");
  const std::string said =
      "counts for plans, and none are made: expected prices, gears or margin, or a matrix of "
      "plans, "
      "which has max_iterations\n";
  const std::vector<std::string> to_table = {"table", "site", scenario, "-o", table};
  const std::vector<std::string> to_matrix = {"matrix",  scenario, "--starts", goals,
                                              "--goals", goals,    "-o",       folder_ / "m.csv"};
  for (std::vector<std::string> command : {to_table, to_matrix}) {
    for (const std::string key : {"time_limit", "max_iterations", "seed", "threads"}) {
      command.insert(command.end(), {"--set", key + "=3"});
      const Outcome refused = run_vandplan(command);
      EXPECT_EQ(refused.status, 2);
      EXPECT_EQ(refused.err, "vandplan: " + key + ": " + said);
      command.resize(command.size() - 2);
    }
  }
  std::vector<std::string> plans = to_matrix;
  plans.insert(plans.end(), {"--max-iterations", "9", "--set", "seed=3"});
  const Outcome planned = run_vandplan(plans);
  EXPECT_EQ(planned.status, 0);
  EXPECT_EQ(planned.err, "");
  plans.insert(plans.end(), {"--set", "max_iterations=8"});
  EXPECT_EQ(run_vandplan(plans).err,
            "vandplan: max_iterations: is given twice, expected --max-iterations alone\n");
}

TEST_F(TableCommand, AMatrixSaysWhyAnEntryIsEmpty) {
  const std::string scenario = folder_ / "a.yaml";
  const std::string starts = folder_ / "starts.csv";
  const std::string goals = folder_ / "goals.csv";
  std::string text = yard_from("{x: 10, y: 15, heading: 3}");
  text.replace(text.find("bounds: {x: [-30, 30]"), 21, "bounds: {x: [-30, 90]");
  write_content(scenario, text);
  write_content(starts, "x,y,heading\n10,15,3\n# in the wall\n5,5.5,0\n80,9,1\n");
  write_content(goals, "20,-10,1\n0,0,0\n");
  const auto matrix = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"matrix", scenario, "--starts", starts, "--goals", goals, "-o",
                               folder_ / "m.csv", "--json"});
    return run_vandplan(more);
  };
  const std::string in_wall =
      "vandplan: warning: " + starts +
      ":4: start 1 has no cost to any goal: the start is not free (of obstacles, or by "
      "zones)\n";
  const Outcome ways = matrix({});
  EXPECT_EQ(ways.status, 0);
  EXPECT_EQ(ways.err, in_wall);  // the table was made for these starts
  (void)json_of({"site", scenario, "--goals", goals, "-o", folder_ / "yard.vst"});
  const Outcome known = matrix({"--site", folder_ / "yard.vst"});
  EXPECT_EQ(known.err,
            in_wall + "vandplan: warning: " + starts +
                ":5: start 2 has no cost to any goal: the start is outside of the table\n");
  const Json counts = Json::parse(known.out);
  EXPECT_EQ(counts["with_way"], 2);
  EXPECT_EQ(counts["without"], Json::parse(R"({"start_in_collision": 2, "outside": 2})"));
  ASSERT_EQ(counts["cheapest"].size(), 1U);  // the other starts have no costs
  const Json cheapest = counts["cheapest"][0];
  EXPECT_EQ(cheapest["start"], 0);
  EXPECT_LE(cheapest["lower_bound"], cheapest["cost"]);
  EXPECT_TRUE(cheapest["proven"].is_boolean());
  const std::string of_start =
      "\n0," + cheapest["goal"].dump() + "," + cheapest["cost"].dump() + ",";
  EXPECT_NE(content_of(folder_ / "m.csv").find(of_start), std::string::npos) << of_start;
  const Outcome plans = matrix({"--max-iterations", "900"});
  EXPECT_EQ(plans.err, in_wall);
  EXPECT_EQ(Json::parse(plans.out)["without"], Json::parse(R"({"start_in_collision": 2})"));
  write_content(goals, "20,-10,1\n5,5.5,0\n");
  const Outcome blocked = matrix({});
  EXPECT_EQ(blocked.err, "vandplan: warning: " + goals +
                             ":2: goal 1 has no costs: the goal is not free (of obstacles, or by "
                             "zones)\n" +
                             in_wall);
  EXPECT_EQ(Json::parse(blocked.out)["without"],
            Json::parse(R"({"goal_in_collision": 2, "start_in_collision": 2})"));
  write_content(goals, "20,-10,1\n0,0,0\n");
  std::string many;
  for (int i = 0; i < 30; ++i) many += "5,5.5,0\n";
  write_content(starts, many);
  const std::string told = matrix({}).err;
  EXPECT_EQ(std::count(told.begin(), told.end(), '\n'), 21);
  EXPECT_NE(told.find(starts + ": 10 more such lines; --json counts the reasons\n"),
            std::string::npos);
}

TEST_F(TableCommand, OfASiteGivesAMatrix) {
  const std::string scenario = folder_ / "a.yaml";
  const std::string table = folder_ / "yard.vst";
  const std::string goals = folder_ / "goals.csv";
  write_content(scenario, yard_from("{x: -17, y: 15, heading: 1}"));  // as far as the starts
  write_content(folder_ / "starts.csv", "10,15,3\n5,5.5,0\n-17,9,1\n");
  write_content(goals, "20,-10,1\n0,0,0\n");
  const auto matrix = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"matrix", scenario, "--starts", folder_ / "starts.csv", "--goals",
                               goals, "-o", folder_ / "m.csv"});
    return run_vandplan(more);
  };
  EXPECT_EQ(matrix({}).status, 0);
  const std::string made = content_of(folder_ / "m.csv");
  EXPECT_EQ(made.substr(0, made.find('\n')), "start,goal,cost,lower_bound");
  EXPECT_EQ(std::count(made.begin(), made.end(), '\n'), 7);
  EXPECT_NE(made.find("\n1,0,,inf\n"), std::string::npos);  // the second start is in a wall
  EXPECT_EQ(made.find("\n2,1,,"), std::string::npos);
  (void)json_of({"site", scenario, "--goals", goals, "-o", table});
  EXPECT_EQ(matrix({"--site", table}).status, 0);
  EXPECT_EQ(content_of(folder_ / "m.csv"), made);
  std::string rig = content_of(scenario);
  rig.insert(rig.find("}\nbounds"),
             ", trailers: [{wheelbase: 5, front_overhang: 1, rear_overhang: 1, width: 2}]");
  write_content(scenario, rig);
  EXPECT_EQ(matrix({"--site", table}).err,
            "vandplan: " + scenario +
                ": has a trailer, and ways of a table are of the tractor alone: expected "
                "--max-iterations, for costs of plans\n");
  write_content(folder_ / "starts.csv", "10,15,3\n5,5.5,0\n");
  EXPECT_EQ(matrix({"--site", table, "--max-iterations", "60"}).status, 0);
  const std::string planned = content_of(folder_ / "m.csv");
  EXPECT_EQ(std::count(planned.begin(), planned.end(), '\n'), 5);
  EXPECT_NE(planned.find("\n1,0,,inf\n"), std::string::npos) << planned;
  EXPECT_EQ(planned.find("\n0,0,,"), std::string::npos) << planned;
  EXPECT_EQ(matrix({"--site", table, "--max-iterations", "0"}).status, 2);
  write_content(scenario, yard_from("{x: -17, y: 15, heading: 1}"));
  write_content(goals, "0,0,0\n1,0,0\n");
  EXPECT_EQ(matrix({"--site", table}).err,
            "vandplan: " + goals + ":2: the table has no such goal, expected one of its 2\n");
  write_content(goals, "0,0,0\n");
  write_content(folder_ / "starts.csv", "10,15,3\n");
  EXPECT_EQ(matrix({"--site", table}).status, 0);
  const std::string row = made.substr(made.find("\n0,1,") + 5);
  EXPECT_EQ(content_of(folder_ / "m.csv"),
            "start,goal,cost,lower_bound\n0,0," + row.substr(0, row.find('\n') + 1));
}

}  // namespace
}  // namespace vandplan
