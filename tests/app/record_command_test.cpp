// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// --record.
#include <gtest/gtest.h>

#include <set>

#include "support/mcap_reader.h"
#include "support/process.h"
#include "support/yard.h"

namespace vandplan {
namespace {

class RecordCommand : public testing::Test {
 protected:
  void SetUp() override { write_content(scenario_, yard()); }

  Outcome run(const std::string& command, std::vector<std::string> options,
              const ProcessOptions& process = {}) {
    options.insert(options.begin(), {command, scenario_});
    return run_vandplan(options, process);
  }
  Outcome plan(std::vector<std::string> options, const ProcessOptions& process = {}) {
    options.insert(options.end(), {"--max-iterations", "300"});
    return run("plan", options, process);
  }
  /// The one line of a call that ends with status 2, without the name of the folder.
  std::string complaint(const Outcome& outcome) {
    EXPECT_EQ(outcome.status, 2) << outcome.out;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    std::string line = outcome.err.substr(0, outcome.err.size() - 1);
    const std::size_t at = line.find(folder_.path());
    if (at != std::string::npos) line.erase(at, folder_.path().size() + 1);
    return line;
  }
  std::set<std::string> topics() {
    std::set<std::string> all;
    for (const McapMessage& message : mcap_messages(content_of(recording_))) {
      all.insert(message.topic);
    }
    return all;
  }

  TemporaryFolder folder_;
  const std::string scenario_ = folder_ / "yard.yaml";
  const std::string result_ = folder_ / "result.json";
  const std::string recording_ = folder_ / "r.mcap";
};

TEST_F(RecordCommand, PlanRecordsItsRunAndThePlannedDrive) {
  const Outcome outcome = plan({"--record", recording_});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out.substr(0, 13), "yard, anytime");
  const std::set<std::string> all = topics();
  for (const char* const topic : {"/ground", "/improvement", "/path", "/motion", "/log"}) {
    EXPECT_TRUE(all.contains(topic)) << topic;
  }
  EXPECT_FALSE(all.contains("/driven"));
}

TEST_F(RecordCommand, DriveRecordsTheDriveAndItsPlan) {
  EXPECT_EQ(plan({"--output", result_}).status, 0);
  const Outcome outcome = run("drive", {result_, "--record", recording_, "--noise", "1"});
  EXPECT_NE(outcome.status, 2) << outcome.err;
  EXPECT_TRUE(topics().contains("/driven"));
  EXPECT_TRUE(topics().contains("/plan"));
}

TEST_F(RecordCommand, DriveWithReplanningRecordsTheDrive) {
  const Outcome outcome =
      run("drive", {"--replan", "0.5", "--set", "max_iterations=300", "--record", recording_});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(topics().contains("/driven"));
  EXPECT_FALSE(topics().contains("/path"));
}

TEST_F(RecordCommand, WhatCannotBeRecordedIsRefusedBeforeItIsPlanned) {
  EXPECT_EQ(complaint(plan({"--record", "-"})), "vandplan: --record: is -, expected a file");
  EXPECT_EQ(complaint(plan({"--record", folder_ / "r.json"})),
            "vandplan: r.json: ends in .json, but a recording is MCAP, expected a name that ends "
            "in .mcap");
  EXPECT_EQ(complaint(plan({"--record", folder_ / "none/r.mcap"})),
            "vandplan: none/r.mcap: cannot write: No such file or directory");
  EXPECT_EQ(complaint(run("drive", {"--replan", "0.5", "--record", "-"})),
            "vandplan: --record: is -, expected a file");
  write_content(scenario_, replaced(yard(), "goal: {x: 20, y: 5, heading: 0}",
                                    "goals: [{distance: 1, goal: {x: 20, y: 5, heading: 0}}]"));
  EXPECT_EQ(complaint(plan({"--record", recording_})),
            "vandplan: --record: is for one path, the scenario has a row of goals");
}

TEST_F(RecordCommand, AFullDiskLeavesTheOldRecording) {
  write_content(recording_, "old");
  EXPECT_EQ(complaint(plan({"--record", recording_}, {.largest_file = 100})),
            "vandplan: r.mcap: cannot write: File too large");
  EXPECT_EQ(content_of(recording_), "old");
}

}  // namespace
}  // namespace vandplan
