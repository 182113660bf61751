// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <gtest/gtest.h>

#include <string>

#include "support/temporary_folder.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

std::vector<PosePair> read(const std::string& text) {
  const TemporaryFolder folder;
  return read_pose_pairs(folder.put("p.csv", text)).pairs;
}

std::string message_for(const std::string& text) {
  const TemporaryFolder folder;
  try {
    (void)read_pose_pairs(folder.put("p.csv", text));
  } catch (const InputError& error) {
    return std::string(error.what()).substr(folder.path().size() + 1);
  }
  return "no error";
}

TEST(PosesFile, HeaderCommentsAndBlanksArePassedOver) {
  const auto pairs =
      read("x,y,h,gx,gy,gh\r\n# a comment\r\n\r\n1, 2.5,-0.5 ,3e1,4,5\r\n6,7,8,9,10,11");
  ASSERT_EQ(pairs.size(), 2U);
  EXPECT_EQ(pairs[0].start, (Pose{1, 2.5, -0.5}));
  EXPECT_EQ(pairs[0].goal, (Pose{30, 4, 5}));
  EXPECT_EQ(pairs[1].goal, (Pose{9, 10, 11}));
}

TEST(PosesFile, TheFirstHeadingThatLooksLikeDegreesIsDoubted) {
  const TemporaryFolder folder;
  const PosePairs read = read_pose_pairs(
      folder.put("p.csv", "0,0,6.2831853,1,1,-6.2831853\n0,0,0,5,0,90\n0,0,180,5,0,0\n"));
  EXPECT_EQ(read.pairs.size(), 3U);
  EXPECT_EQ(read.lines, (std::vector<int>{1, 2, 3}));
  ASSERT_EQ(read.warnings.size(), 1U);
  EXPECT_EQ(read.warnings[0].substr(folder.path().size() + 1),
            "p.csv:2: goal_heading: is 90 rad, more than a full turn; 90 degrees are 1.5708 rad");
}

TEST(PosesFile, MistakesNameTheLine) {
  EXPECT_EQ(message_for(""), "p.csv: has no poses, expected a start and a goal on a line");
  EXPECT_EQ(message_for("# nothing\n"),
            "p.csv: has no poses, expected a start and a goal on a line");
  EXPECT_EQ(message_for("1,2,3,4,5,6\n1,2,3\n"),
            "p.csv:2: has 3 values, expected "
            "start_x,start_y,start_heading,goal_x,goal_y,goal_heading");
  EXPECT_EQ(message_for("1,2,3,4,5,6\n1,2,3,4,5,6,7,8\n"),
            "p.csv:2: has more than 6 values, expected "
            "start_x,start_y,start_heading,goal_x,goal_y,goal_heading");
  EXPECT_EQ(message_for("1;2;3;4;5;6\n"),
            "p.csv:1: has 1 value, expected "
            "start_x,start_y,start_heading,goal_x,goal_y,goal_heading");
  EXPECT_EQ(message_for("1,2,3,4,5,6\n1,2,3,4,five,6\n"),
            "p.csv:2: goal_y: is \"five\", expected a finite number");
  EXPECT_EQ(message_for("1,2,3,4,5,inf\n"),
            "p.csv:1: goal_heading: is \"inf\", expected a finite number");
  EXPECT_EQ(message_for("a,b,c,d,e,f\na,b,c,d,e,f\n"),
            "p.csv:2: start_x: is \"a\", expected a finite number");
  EXPECT_EQ(message_for("1,2,3,4,5,6\n\n1e300,2,3,4,5,6\n"),
            "p.csv:3: start.x: is 1e+300, expected a number between -1e+12 and 1e+12");
  EXPECT_EQ(message_for("0,0,0,4e5,3e5,0\n"),
            "p.csv:1: goal: is 500000 m from the start, expected at most 100000 m");
}

// A first line with a number in it is no header, and so no pair is lost.
TEST(PosesFile, AFirstLineWithAMistakeIsNoHeader) {
  EXPECT_EQ(message_for("1O,2,3,4,5,6\n1,2,3,4,5,6\n"),
            "p.csv:1: start_x: is \"1O\", expected a finite number");
  EXPECT_EQ(message_for("start_x,start_y,start_heading,goal_y,goal_x,goal_heading\n1,2,3,4,5,6\n"),
            "p.csv:1: has goal_y in column 4, expected "
            "start_x,start_y,start_heading,goal_x,goal_y,goal_heading");
}

TEST(PosesFile, WhatSpreadsheetsWriteIsRead) {
  for (const char* const text :
       {"\xEF\xBB\xBF"
        "1,2,3,4,5,6\r\n",
        "\"1\",\"2\",\"3\",\"4\",\"5\",\"6\"", "+1,2,3,4,5,6",
        "\"start_x\",start_y,start_heading,goal_x,goal_y,goal_heading\n1,2,3,4,5,6"}) {
    SCOPED_TRACE(text);
    const auto pairs = read(text);
    ASSERT_EQ(pairs.size(), 1U);
    EXPECT_EQ(pairs[0].start, (Pose{1, 2, 3}));
    EXPECT_EQ(pairs[0].goal, (Pose{4, 5, 6}));
  }
}

TEST(PosesFile, HoldsPosesAlone) {
  const TemporaryFolder folder;
  const Poses read =
      read_poses(folder.put("p.csv", "x,y,heading\n1, 2.5,-0.5\n# dock\n3e1,4,90\n"));
  EXPECT_EQ(read.poses, (std::vector<Pose>{{1, 2.5, -0.5}, {30, 4, 90}}));
  EXPECT_EQ(read.lines, (std::vector<int>{2, 4}));
  ASSERT_EQ(read.warnings.size(), 1U);
  EXPECT_NE(read.warnings[0].find("p.csv:4: heading: is 90 rad"), std::string::npos);
}

TEST(PosesFile, MistakesInPosesNameTheLine) {
  const auto told = [](const std::string& text) {
    const TemporaryFolder folder;
    try {
      (void)read_poses(folder.put("p.csv", text));
    } catch (const InputError& error) {
      return std::string(error.what()).substr(folder.path().size() + 1);
    }
    return std::string("no error");
  };
  EXPECT_EQ(told(""), "p.csv: has no poses, expected x,y,heading on a line");
  EXPECT_EQ(told("1,2,3\n1,2\n"), "p.csv:2: has 2 values, expected x,y,heading");
  EXPECT_EQ(told("x,heading,y\n1,2,3\n"), "p.csv:1: has heading in column 2, expected x,y,heading");
}

}  // namespace
}  // namespace vandplan
