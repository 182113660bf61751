// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Bad input of every kind ends with exit status 2, one line on stderr and nothing written.
#include <gtest/gtest.h>

#include <sys/stat.h>

#include <algorithm>
#include <bit>
#include <cstdint>

#include "support/process.h"
#include "support/yard.h"

namespace vandplan {
namespace {

class BadInput : public testing::Test {
 protected:
  void SetUp() override { write_content(scenario_, yard()); }

  /// The complaint, without its newline and the name of the program before it.
  std::string complaint(const std::vector<std::string>& arguments,
                        const ProcessOptions& options = {}) {
    const Outcome outcome = run_vandplan(arguments, options);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    const std::string name = "vandplan: ";
    EXPECT_EQ(outcome.err.substr(0, name.size()), name);
    if (outcome.err.size() <= name.size()) return outcome.err;
    return outcome.err.substr(name.size(), outcome.err.size() - name.size() - 1);
  }

  std::string complaint_of_plan(std::vector<std::string> options) {
    options.insert(options.begin(), {"plan", scenario_});
    return complaint(options);
  }

  /// What `plan` says about the scenario with `from` turned into `to`, after the file's name.
  std::string complaint_about(const std::string& from, const std::string& to) {
    write_content(scenario_, replaced(yard(), from, to));
    const std::string output = folder_ / "result.json";
    const std::string text = complaint_of_plan({"--output", output});
    EXPECT_FALSE(std::filesystem::exists(output));
    EXPECT_EQ(text.substr(0, scenario_.size() + 1), scenario_ + ":");
    return text.size() > scenario_.size() ? text.substr(scenario_.size() + 1) : text;
  }

  TemporaryFolder folder_;
  const std::string scenario_ = folder_ / "yard.yaml";
};

// ---- scenario files ----

TEST_F(BadInput, MissingKey) {
  EXPECT_EQ(complaint_about("start: {x: 0, y: 0, heading: 0}\n", ""),
            "1: key \"start\" is missing, expected it");
  EXPECT_EQ(complaint_about("width: 2.55, ", ""),
            "2: vehicle: key \"width\" is missing, expected it");
}

TEST_F(BadInput, UnknownKey) {
  EXPECT_EQ(complaint_about("goal: {x", "goal: {z: 1, x"),
            "5: goal: unknown key \"z\", expected one of x, y, area, heading, either_way, "
            "trailer, any_of, curvature, hitch_angles, straight, stop");
}

TEST_F(BadInput, KeyGivenTwice) {
  EXPECT_EQ(complaint_about("obstacles:", "name:"),
            "6: key \"name\" is given again, expected it once (first on line 1)");
}

TEST_F(BadInput, WrongType) {
  EXPECT_EQ(complaint_about("x: 20", "x: {}"), "5: goal.x: is a map of keys, expected a number");
  EXPECT_EQ(complaint_about("x: 20", "x: [20]"),
            "5: goal.x: has 1 element, expected [smallest, largest]");
  EXPECT_EQ(complaint_about("x: 20", "x: far"), "5: goal.x: is \"far\", expected a number");
}

TEST_F(BadInput, NumberWithAComma) {
  EXPECT_EQ(complaint_about("x: 20", "x: 20,5"),
            "5: goal: has the digits \"5\" behind a comma, expected a number with a point");
  EXPECT_EQ(
      complaint_about("goal: {x: 20, y: 5, heading: 0}", "goal:\n  x: 20,5\n  y: 5\n  heading: 0"),
      "6: goal.x: is \"20,5\", expected a number, with a point instead of the comma");
}

TEST_F(BadInput, LineThatBeginsWithATab) {
  EXPECT_EQ(complaint_about("goal: {x: 20, y: 5, heading: 0}", "goal:\n\tx: 20\n\ty: 5"),
            "6: begins with a tab, expected spaces");
}

TEST_F(BadInput, NumberThatIsNotFinite) {
  EXPECT_EQ(complaint_about("x: 20", "x: .nan"),
            "5: goal.x: is \".nan\", expected a finite number");
  EXPECT_EQ(complaint_about("x: 20", "x: -.inf"),
            "5: goal.x: is \"-.inf\", expected a finite number");
  EXPECT_EQ(complaint_about("x: 20", "x: 1e400"),
            "5: goal.x: is \"1e400\", expected a number that fits a double");
}

TEST_F(BadInput, LengthOutOfRange) {
  EXPECT_EQ(complaint_about("width: 2.55", "width: 0"),
            "2: vehicle.width: is 0, expected more than 0 m");
}

TEST_F(BadInput, CrossedBounds) {
  EXPECT_EQ(complaint_about("x: [-50, 50]", "x: [50, -50]"),
            "3: bounds.x: is [50, -50], expected the smaller number first");
}

TEST_F(BadInput, PolygonThatCrossesItself) {
  EXPECT_EQ(complaint_about("[13, 9], [12, 9]", "[12, 9], [13, 9]").substr(0, 24),
            "7: obstacles[0]: crosses");
}

TEST_F(BadInput, PolygonWithTwoCorners) {
  EXPECT_EQ(complaint_about(", [13, 9], [12, 9]", ""),
            "7: obstacles[0]: has 2 corners, expected at least 3");
}

TEST_F(BadInput, SyntaxError) {
  EXPECT_EQ(complaint_about("start:", "start: {").substr(0, 2), "4:");
}

TEST_F(BadInput, EmptyFile) {
  write_content(scenario_, "");
  EXPECT_EQ(complaint_of_plan({}), scenario_ + ":1: is empty, expected keys and values");
}

TEST_F(BadInput, HugeFile) {
  // A hole of 20 GB costs no disk and must cost no memory.
  std::filesystem::resize_file(scenario_, 20'000'000'000);
  EXPECT_EQ(complaint_of_plan({}), scenario_ + ": is too large, expected at most 67108864 bytes");
}

TEST_F(BadInput, FileThatIsNoText) {
  write_content(scenario_, "name: \xff\xfe");
  EXPECT_EQ(complaint_of_plan({}), scenario_ + ":1: is not a text file, expected YAML in UTF-8");
}

TEST_F(BadInput, FileThatIsNotThere) {
  const std::string file = folder_ / "none.yaml";
  EXPECT_EQ(complaint({"plan", file}), file + ": cannot open: No such file or directory");
}

TEST_F(BadInput, FolderInsteadOfAFile) {
  EXPECT_EQ(complaint({"plan", folder_.path()}), folder_.path() + ": cannot read: Is a directory");
}

TEST_F(BadInput, PipesAreNotWaitedFor) {
  const std::string pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const std::string problem = pipe + ": is a pipe, expected a regular file; - is standard input";
  EXPECT_EQ(complaint({"plan", pipe}), problem);
  EXPECT_EQ(complaint({"check", scenario_, pipe}), problem);
  EXPECT_EQ(complaint_of_plan({"--poses", pipe}), problem);
  EXPECT_EQ(complaint({"table", "info", pipe}), problem);
  EXPECT_EQ(complaint({"convert", "tpcap", pipe, "-o", folder_ / "a.yaml"}), problem);
  write_content(scenario_, yard() + "map: m.yaml\n");
  write_content(folder_ / "m.yaml",
                "image: pipe\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\n"
                "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  EXPECT_EQ(complaint_of_plan({}), (folder_ / "m.yaml") + ":1: image: " + problem);
}

TEST_F(BadInput, ATableWithARadiusOutOfRange) {
  // 2 x 2 positions and 3 x 3 headings; the checksum fits.
  std::string table = "vp-table\x04\x03\x02\x01\x01";
  table += std::string(3, '\0') + "reeds-shepp-4d  metre radian    ";
  const auto append = [&table](std::uint64_t word) {
    for (int i = 0; i < 64; i += 8) table += static_cast<char>(word >> i & 0xFFU);
  };
  for (const double length : {1e200, 1.0, 1.0}) append(std::bit_cast<std::uint64_t>(length));
  append(2);   // steps of a full turn
  append(36);  // entries
  append(0);
  write_content(folder_ / "t.table", table + std::string(144, '\0'));
  EXPECT_EQ(complaint({"table", "info", folder_ / "t.table"}),
            (folder_ / "t.table") + ": turning_radius: is 1e+200, expected 0.000001 to 1000000 m");
}

TEST_F(BadInput, StandardInputIsNamed) {
  EXPECT_EQ(complaint({"plan", "-"}), "standard input:1: is empty, expected keys and values");
}

// ---- where to write ----

TEST_F(BadInput, OutputFolderThatIsNotThere) {
  const std::string file = folder_ / "none/result.json";
  EXPECT_EQ(complaint_of_plan({"--output", file, "--time", "60"}),
            file + ": cannot write: No such file or directory");
}

TEST_F(BadInput, OutputThatIsAFolder) {
  EXPECT_EQ(complaint_of_plan({"--output", folder_.path(), "--time", "60"}),
            folder_.path() + ": cannot write: Is a directory");
}

TEST_F(BadInput, OutputWithoutAName) {
  EXPECT_EQ(complaint_of_plan({"--output", "", "--time", "60"}),
            ": cannot write: No such file or directory");
}

TEST_F(BadInput, OutputWhoseEndingPromisesAnotherFormat) {
  const std::string file = folder_ / "poses.CSV";
  EXPECT_EQ(
      complaint_of_plan({"--output", file, "--time", "60"}),
      file +
          ": ends in .CSV, but a result is JSON, binary or GeoJSON, expected a name that ends in "
          ".json");
  EXPECT_EQ(complaint_of_plan({"--poses", scenario_, "--output", folder_ / "a.yaml"}),
            (folder_ / "a.yaml") +
                ": ends in .yaml, but results of --poses are JSON Lines or binary, "
                "expected a name that ends in .jsonl");
  write_content(folder_ / "case.csv", "0,0,0,10,0,0,1,4,30,20,31,20,31,21,30,21\n");
  EXPECT_EQ(complaint({"convert", "tpcap", folder_ / "case.csv", "-o", folder_ / "a.json"}),
            (folder_ / "a.json") +
                ": ends in .json, but a scenario is YAML, expected a name that "
                "ends in .yaml");
}

TEST_F(BadInput, PictureOfUnknownKind) {
  const std::string file = folder_ / "yard.gif";
  EXPECT_EQ(complaint_of_plan({"--draw", file, "--time", "60"}),
            file + ": a picture must end in .png, .svg or .pdf");
}

TEST_F(BadInput, FullDiskLeavesTheOldResult) {
  const std::string file = folder_ / "result.json";
  write_content(file, "old");
  EXPECT_EQ(complaint({"plan", scenario_, "--max-iterations", "50", "--output", file},
                      {.largest_file = 100}),
            file + ": cannot write: File too large");
  EXPECT_EQ(content_of(file), "old");
  const std::filesystem::directory_iterator left(folder_.path());
  EXPECT_EQ(std::distance(begin(left), end(left)), 2);  // the scenario and the old result
}

TEST_F(BadInput, FullStandardOutput) {
  const std::string problem = "standard output: cannot write: No space left on device";
  EXPECT_EQ(complaint({"plan", scenario_, "--max-iterations", "50"}, {.output = "/dev/full"}),
            problem);
  // More than is kept back until the end.
  EXPECT_EQ(
      complaint({"plan", scenario_, "--max-iterations", "50", "--json"}, {.output = "/dev/full"}),
      problem);
}

TEST_F(BadInput, LackOfMemoryIsSaidInOneLine) {
  if (!memory_can_be_limited) GTEST_SKIP() << "AddressSanitizer needs more";
  for (const rlim_t memory : {60'000'000U, 100'000'000U, 200'000'000U}) {
    EXPECT_EQ(complaint({"plan", scenario_, "--planner", "rrt-bsc-euc", "--max-nodes", "10000000",
                         "--max-iterations", "1"},
                        {.memory = memory}),
              "out of memory");
  }
}

TEST_F(BadInput, NobodyIsThereToHearAComplaint) {
  for (const ProcessOptions& options :
       {ProcessOptions{.closed = {2}}, ProcessOptions{.closed = {0, 1, 2}},
        ProcessOptions{.error = "/dev/full"}}) {
    const Outcome outcome = run_vandplan({"plan", folder_ / "none.yaml"}, options);
    EXPECT_EQ(outcome.status, 2);
  }
}

// ---- the command line ----

TEST_F(BadInput, NoCommand) {
  EXPECT_EQ(complaint({}), "a command is missing, see vandplan --help");
}

TEST_F(BadInput, UnknownCommand) {
  EXPECT_EQ(complaint({"fly"}),
            "\"fly\" is no command, expected one of plan, check, draw, speed, drive, smooth, "
            "evaluate, table, study, convert, planners, matrix");
  EXPECT_EQ(complaint({"paln"}).substr(0, 46), "\"paln\" is no command, did you mean plan? Expec");
  EXPECT_EQ(complaint({"table", "bild"}),
            "\"bild\" is no command, did you mean build? Expected one of build, info, check, "
            "export, site");
}

TEST_F(BadInput, OneArgumentTooMany) {
  EXPECT_EQ(complaint_of_plan({"other.yaml"}),
            "\"other.yaml\" is one argument too many, see vandplan plan --help");
}

TEST_F(BadInput, MissingScenario) { EXPECT_EQ(complaint({"plan"}), "SCENARIO is required"); }

TEST_F(BadInput, UnknownPlanner) {
  EXPECT_EQ(complaint_of_plan({"--planner", "best"}).substr(0, 44),
            "planner: \"best\" is unknown, expected one of ");
  EXPECT_EQ(complaint_of_plan({"--planner", "swift"}),
            "planner: \"swift\" is unknown, expected one of anytime, rrt-... (28), "
            "hybrid-a-star, lattice-a-star, lattice-ara-star, ltba-star, field-d-star, prm, hrrt, "
            "ikrrt, bkrrt, rrt-connect, rrt-star");
  EXPECT_NE(complaint_of_plan({"--planner", "anytme"}).find("did you mean anytime? Expected one"),
            std::string::npos);
}

TEST_F(BadInput, UnknownOption) {
  EXPECT_EQ(complaint_of_plan({"--sed=1"}),
            "--sed: unknown option, did you mean --seed? See vandplan plan --help");
  EXPECT_EQ(complaint_of_plan({"-o", "r.json"}),
            "-o: unknown option, did you mean --output? See vandplan plan --help");
  EXPECT_EQ(complaint_of_plan({"--nothing"}),
            "--nothing: unknown option, see vandplan plan --help");
}

TEST_F(BadInput, KeyOfSetAsAnOption) {
  EXPECT_EQ(complaint_of_plan({"--margin", "0.3"}),
            "--margin: unknown option, expected --set margin=0.3");
  EXPECT_EQ(complaint_of_plan({"--gear-change-cost=3"}),
            "--gear-change-cost: unknown option, expected --set gear_change_cost=3");
  EXPECT_EQ(complaint_of_plan({"--gear_change_prise", "3"}),
            "--gear_change_prise: unknown option, did you mean --set gear_change_cost=3? See "
            "vandplan plan --help");
}

TEST_F(BadInput, OptionGivenTwiceOrWithoutItsValue) {
  EXPECT_EQ(complaint_of_plan({"--time", "1", "--time", "2"}),
            "--time: is given more than once, expected one value");
  EXPECT_EQ(complaint_of_plan({"--time"}), "--time: is given without a value, expected one");
}

TEST_F(BadInput, NumberThatIsNone) {
  EXPECT_EQ(complaint_of_plan({"--seed", "first"}).substr(0, 37),
            "--seed: \"first\" is not a whole number");
  EXPECT_EQ(complaint_of_plan({"--time", "1s"}).substr(0, 28), "--time: \"1s\" is not a number");
}

TEST_F(BadInput, NumberOutOfRange) {
  const auto place = [&](const std::vector<std::string>& options) {
    const std::string text = complaint_of_plan(options);
    return text.substr(0, text.find(':'));
  };
  EXPECT_EQ(complaint_of_plan({"--time", "-1"}), "--time: -1 is not a number >= 0 [s]");
  EXPECT_EQ(complaint_of_plan({"--time", "nan"}), "--time: nan is not a number >= 0 [s]");
  EXPECT_EQ(place({"--max-iterations", "-1"}), "--max-iterations");
  EXPECT_EQ(place({"--planner", "rrt-opt-euc", "--max-nodes", "0"}), "--max-nodes");
  EXPECT_EQ(place({"--max-nodes", "1e3", "--planner", "rrt-opt-euc"}), "--max-nodes");
  EXPECT_EQ(place({"--seed", "18446744073709551616"}), "--seed");
  EXPECT_EQ(place({"--region", "all"}), "--region");
  EXPECT_EQ(place({"--set", "goal_bias=2", "--planner", "rrt-opt-euc"}), "goal_bias");
}

TEST_F(BadInput, UnknownKeyOfSet) {
  EXPECT_EQ(complaint_of_plan({"--set", "planner=best"}).substr(0, 50),
            "planner: unknown option, expected one of style, se");
  EXPECT_EQ(complaint_of_plan({"--set", "gear_change_price=3"}).substr(0, 78),
            "gear_change_price: unknown option, did you mean gear_change_cost? Expected one");
  EXPECT_EQ(complaint_of_plan({"--set", "seed"}), "--set: \"seed\" is not KEY=VALUE");
}

}  // namespace
}  // namespace vandplan
