// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Does the adapter answer with the bits of the command line?

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "ros/yard.h"
#include "support/process.h"
#include "vandplan/random.h"

namespace vandplan::ros {
namespace {

using Json = nlohmann::json;

/// The map of a costmap as a picture of map_server: black is occupied, white free. Rows from above.
std::string picture_of(const Costmap& costmap) {
  std::string text =
      "P5\n" + std::to_string(costmap.columns) + " " + std::to_string(costmap.rows) + "\n255\n";
  for (std::int32_t row = costmap.rows - 1; row >= 0; --row) {
    for (std::int32_t column = 0; column < costmap.columns; ++column) {
      const std::size_t index =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(costmap.columns) +
          static_cast<std::size_t>(column);
      text += costmap.costs[index] == nav2_lethal_cost ? '\0' : '\xff';
    }
  }
  return text;
}

std::vector<Segment> segments_in(const Json& path) {
  std::vector<Segment> segments;
  for (const Json& segment : path.at("segments")) {
    const std::string turn = segment.value("turn", "");
    const double radius = small_request({}, {}).vehicle.min_turning_radius;
    const double side = turn == "left" ? 1.0 : turn == "right" ? -1.0 : 0.0;
    segments.push_back({segment.value("curvature", side / radius), segment.at("length"),
                        segment.value("curvature_rate", 0.0)});
  }
  return segments;
}

TEST(RosAdapter, AnswersWithTheBitsOfTheCommandLine) {
  const TemporaryFolder folder;
  Rng rng(23);
  for (int i = 0; i < 8; ++i) {
    OwnedCostmap costmap(200, 120, 0.1, {-3.25, 7.5, 0});
    for (int k = 0; k < 6; ++k) {
      CellRange box = any_range(40, 30, rng);
      box.column += static_cast<std::int32_t>(uniform(50, 110, rng));
      box.row += static_cast<std::int32_t>(uniform(0, 90, rng));
      costmap.fill(box, nav2_lethal_cost);
    }
    write_content(folder / "map.pgm", picture_of(costmap.view()));
    write_content(folder / "map.yaml",
                  "image: map.pgm\nresolution: 0.1\norigin: [-3.25, 7.5, 0]\nnegate: 0\n"
                  "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
    write_content(folder / "yard.yaml",
                  "name: yard\nmap: map.yaml\nstart: {x: -1.5, y: 12, heading: 0.5}\n"
                  "goal: {x: 14.5, y: 14, heading: -1}\n"
                  "vehicle: {wheelbase: 0.5, front_overhang: 0, rear_overhang: 0.1, width: 0.4, "
                  "min_turning_radius: 0.4}\n");
    const vandplan::Outcome outcome =
        run_vandplan({"plan", folder / "yard.yaml", "--json", "--max-iterations", "1500", "--set",
                      "margin=0.05"});
    Planner planner;
    planner.take(costmap.view());
    const Answer answer =
        planner.plan(small_request({-1.5, 12, 0.5}, {14.5, 14, -1}, 1500, {{"margin", 0.05}}));
    ASSERT_EQ(outcome.status, answer.outcome == Outcome::solved ? 0 : 1) << outcome.err;
    if (outcome.status != 0) continue;
    const Json result = Json::parse(outcome.out);
    EXPECT_EQ(result.at("cost").get<double>(), answer.cost);
    EXPECT_EQ(segments_in(result.at("path")), answer.parts.front().segments);
  }
}

}  // namespace
}  // namespace vandplan::ros
