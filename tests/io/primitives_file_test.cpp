// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Primitives of Nav2 and SBPL become exact ones, or are refused with their line.
#include "vandplan/files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "support/temporary_folder.h"
#include "vandplan/input_error.h"
#include "vandplan/search.h"

namespace vandplan {
namespace {

constexpr double step = 0.5;
constexpr double quarter = std::numbers::pi / 2;

/// Four headings: a step ahead, and a quarter turn to the left of 4 steps.
struct Motion {
  int from, to, dx, dy;
  Piece piece;
};

std::vector<Motion> motions() {
  std::vector<Motion> all;
  for (int h = 0; h < 4; ++h) {
    Piece line;
    line.segments[line.count++] = {0.0, step};
    line.length = step;
    Piece turn;
    turn.segments[turn.count++] = {1 / (4 * step), quarter * 4 * step};
    turn.length = quarter * 4 * step;
    const int cos = h == 0 ? 1 : h == 2 ? -1 : 0;
    const int sin = h == 1 ? 1 : h == 3 ? -1 : 0;
    all.push_back({h, h, cos, sin, line});
    all.push_back({h, (h + 1) % 4, 4 * (cos - sin), 4 * (sin + cos), turn});
  }
  return all;
}

std::string formatted(const char* format, double a, double b, double c) {
  char text[120];
  std::snprintf(text, sizeof text, format, a, b, c);
  return text;
}

std::vector<Pose> poses_of(const Motion& motion) {
  const Path path{{0, 0, motion.from * quarter},
                  {motion.piece.view().begin(), motion.piece.view().end()}};
  std::vector<Pose> poses;
  for (int i = 0; i <= 8; ++i) poses.push_back(pose_at(path, motion.piece.length * i / 8));
  return poses;
}

std::string sbpl_text(const std::vector<Motion>& all) {
  std::string text = "resolution_m: 0.500000\nnumberofangles: 4\ntotalnumberofprimitives: " +
                     std::to_string(all.size()) + "\n";
  for (const Motion& m : all) {
    text += "primID: 0\nstartangle_c: " + std::to_string(m.from) +
            "\nendpose_c: " + std::to_string(m.dx) + " " + std::to_string(m.dy) + " " +
            std::to_string(m.to) + "\nadditionalactioncostmult: 1\nintermediateposes: 9\n";
    for (const Pose& p : poses_of(m)) text += formatted("%.4f %.4f %.4f\n", p.x, p.y, p.heading);
  }
  return text;
}

std::string nav2_text(const std::vector<Motion>& all) {
  std::string text =
      "{\"version\": 1.0, \"lattice_metadata\": {\"motion_model\": \"ackermann\",\n"
      "\"grid_resolution\": 0.5,\n"
      "\"heading_angles\": [0.0, 1.5707963267948966, 3.141592653589793, 4.71238898038469]},\n"
      "\"primitives\": [\n";
  for (const Motion& m : all) {
    text += (&m == &all.front() ? "" : ",\n") +
            ("{\"trajectory_id\": 0, \"start_angle_index\": " + std::to_string(m.from)) +
            ", \"end_angle_index\": " + std::to_string(m.to) + ", \"poses\": [";
    const auto poses = poses_of(m);
    for (std::size_t i = 1; i < poses.size(); ++i) {
      if (i > 1) text += ", ";
      text += formatted("[%.5f, %.5f, %.12f]", poses[i].x, poses[i].y, poses[i].heading);
    }
    text += "]}";
  }
  return text + "]}\n";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

class PrimitivesFile : public testing::Test {
 protected:
  std::shared_ptr<const search::Primitives> read(const std::string& name, const std::string& text) {
    return read_primitives(folder_.put(name, text));
  }
  std::string refusal(const std::string& name, const std::string& text) {
    const std::string file = folder_.put(name, text);
    try {
      (void)read_primitives(file);
    } catch (const InputError& error) {
      const std::string message = error.what();
      return message.starts_with(file) ? message.substr(file.size()) : message;
    }
    return "";
  }
  TemporaryFolder folder_;
};

void expect_motions(const search::Primitives& primitives, bool in_reverse_too) {
  const auto all = motions();
  EXPECT_EQ(primitives.step(), step);
  EXPECT_EQ(primitives.headings().size(), 4U);
  ASSERT_EQ(primitives.all().size(), all.size() * (in_reverse_too ? 2U : 1U));
  EXPECT_NEAR(primitives.largest_curvature(), 1 / (4 * step), 1e-3);
  int reverse = 0;
  for (const search::Primitive& p : primitives.all()) {
    const double heading = primitives.headings()[static_cast<std::size_t>(p.from)];
    const Pose end = search::end_of({0, 0, heading}, p.piece);
    EXPECT_NEAR(end.x, p.dx * step, 1e-9);
    EXPECT_NEAR(end.y, p.dy * step, 1e-9);
    EXPECT_NEAR(p.piece.length, p.from == p.to ? step : quarter * 4 * step, 1e-3);
    if (p.piece.segments[0].length < 0) ++reverse;
  }
  EXPECT_EQ(reverse, in_reverse_too ? 8 : 0);
}

TEST_F(PrimitivesFile, OfSbplIsReadExactly) {
  expect_motions(*read("a.mprim", sbpl_text(motions())), false);
}

TEST_F(PrimitivesFile, OfNav2IsReadExactlyAndInReverseToo) {
  expect_motions(*read("a.json", nav2_text(motions())), true);
}

TEST_F(PrimitivesFile, PassesOverTurnsOnTheSpot) {
  std::string text = replaced(sbpl_text(motions()), "primitives: 8", "primitives: 9");
  text +=
      "primID: 1\nstartangle_c: 0\nendpose_c: 0 0 1\nadditionalactioncostmult: 5\n"
      "intermediateposes: 2\n0 0 0\n0 0 1.5708\n";
  expect_motions(*read("a.mprim", text), false);
}

TEST_F(PrimitivesFile, OfSbplIsRefusedWithItsLine) {
  const std::string good = sbpl_text(motions());
  const auto with = [&](const std::string& from, const std::string& to) {
    return refusal("a.mprim", replaced(good, from, to));
  };
  EXPECT_EQ(with("resolution_m", "resolution"), ":1: has another key, expected \"resolution_m:\"");
  EXPECT_EQ(with("0.500000", "0"), ":1: has no resolution above 0 m");
  EXPECT_EQ(with("numberofangles: 4", "numberofangles: 0"),
            ":2: has 0, expected a whole number from 1 to 1000");
  EXPECT_EQ(with("startangle_c: 0", "startangle_c: 4"),
            ":5: has 4, expected a whole number from 0 to 3");
  EXPECT_EQ(with("0.0000 0.0000 0.0000", "0.0000 x"), ":9: holds something else than numbers");
  EXPECT_EQ(with("0.0000 0.0000 0.0000", "0.0000"), ":9: has 1 numbers, expected 3");
  EXPECT_EQ(
      with("0.0000 0.0000 0.0000", "0.0000 0.0000 0.2000"),
      ":4: has a heading of 0.2 rad, expected a part of the turn or the direction of a grid point");
  EXPECT_EQ(with("endpose_c: 1 0 0", "endpose_c: 3 0 0"),
            ":17: ends at 0.5, 0 m, expected endpose_c, 1.5, 0 m");
  EXPECT_EQ(
      with("0.2500 0.0000 0.0000", "0.2500 0.4000 0.0000"),
      ":4: no arcs and lines of one gear pass its poses within 0.25 m, expected a motion that "
      "can be driven");
  EXPECT_EQ(refusal("a.mprim", good.substr(0, good.size() / 2)).substr(0, 4), ":60:");
  EXPECT_EQ(refusal("a.txt", good),
            ": is no file of primitives, expected .json (Nav2) or .mprim (SBPL)");
}

TEST_F(PrimitivesFile, OfNav2IsRefusedWithItsLine) {
  const std::string good = nav2_text(motions());
  const auto with = [&](const std::string& from, const std::string& to) {
    return refusal("a.json", replaced(good, from, to));
  };
  EXPECT_EQ(with("grid_resolution\": 0.5", "grid_resolution\": -1"),
            ":2: lattice_metadata.grid_resolution: is not above 0, expected metres");
  EXPECT_EQ(with("\"start_angle_index\": 0", "\"start_angle_index\": 4"),
            ":5: primitives[0].start_angle_index: is 4, expected the index of one of 4 headings");
  EXPECT_EQ(with("[0.06250, 0.00000, 0.000000000000]", "[0.06250, 0.00000]"),
            ":5: primitives[0].poses[0]: has 2 elements, expected [x, y, heading]");
  EXPECT_EQ(with("[0.50000, 0.00000,", "[0.60000, 0.00000,"),
            ":5: ends at 0.6 m, expected a multiple of the resolution, 0.5 m");
}

}  // namespace
}  // namespace vandplan
