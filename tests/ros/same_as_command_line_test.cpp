// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Does the adapter answer with the bits of the command line?

#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <numeric>

#include "ros/yard.h"
#include "support/process.h"
#include "vandplan/random.h"

namespace vandplan::ros {
namespace {

using Json = nlohmann::json;

/// A picture of map_server with a brightness for each cost. Rows from above.
std::string picture_of(const Costmap& costmap, const std::function<char(std::uint8_t)>& shade) {
  std::string text =
      "P5\n" + std::to_string(costmap.columns) + " " + std::to_string(costmap.rows) + "\n255\n";
  for (std::int32_t row = costmap.rows - 1; row >= 0; --row) {
    for (std::int32_t column = 0; column < costmap.columns; ++column) {
      const std::size_t index =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(costmap.columns) +
          static_cast<std::size_t>(column);
      text += shade(costmap.costs[index]);
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
  std::vector<std::uint8_t> all_costs(256);
  std::iota(all_costs.begin(), all_costs.end(), std::uint8_t{0});
  Rng rng(23);
  int solved = 0;
  for (int i = 0; i < 8; ++i) {
    OwnedCostmap costmap(200, 120, 0.1, {-3.25, 7.5, 0});
    for (int k = 0; k < 6; ++k) {
      CellRange box = any_range(40, 30, rng);
      box.column += static_cast<std::int32_t>(uniform(50, 110, rng));
      box.row += static_cast<std::int32_t>(uniform(0, 90, rng));
      costmap.fill(box, nav2_lethal_cost);
    }
    // Graded costs around, of which the brightness of a raw picture is the percentage.
    for (int k = 0; k < 6; ++k) {
      costmap.fill(any_range(200, 120, rng), static_cast<std::uint8_t>(uniform(0, 253, rng)));
    }
    costmap.fill({75, 48, 24, 16}, 0);  // the via point is free
    const std::vector<std::uint8_t> percents =
        percents_of({.costs = all_costs, .columns = 256, .rows = 1}, {}, {0, 0, 256, 1});
    write_content(folder / "map.pgm", picture_of(costmap.view(), [](std::uint8_t cost) {
                    return cost == nav2_lethal_cost ? '\0' : '\xff';
                  }));
    write_content(folder / "costs.pgm", picture_of(costmap.view(), [&](std::uint8_t cost) {
                    return static_cast<char>(percents[cost]);
                  }));
    const std::string shape =
        "resolution: 0.1\norigin: [-3.25, 7.5, 0]\nnegate: 0\n"
        "occupied_thresh: 0.65\nfree_thresh: 0.196\n";
    write_content(folder / "map.yaml", "image: map.pgm\n" + shape);
    write_content(folder / "costs.yaml", "image: costs.pgm\nmode: raw\n" + shape);
    write_content(folder / "yard.yaml",
                  "name: yard\nmap: map.yaml\nmasks: [{map: costs.yaml, as: cost, of: 2}]\n"
                  "via: [{x: 5, y: 13, heading: 0.2}]\nstart: {x: -1.5, y: 12, heading: 0.5}\n"
                  "goal: {x: 14.5, y: 14, heading: -1}\n"
                  "vehicle: {wheelbase: 0.5, front_overhang: 0, rear_overhang: 0.1, width: 0.4, "
                  "min_turning_radius: 0.4}\n");
    const vandplan::Outcome outcome =
        run_vandplan({"plan", folder / "yard.yaml", "--json", "--max-iterations", "1500", "--set",
                      "margin=0.05"});
    Planner planner;
    planner.take(costmap.view());
    Request request = small_request({-1.5, 12, 0.5}, {14.5, 14, -1}, 1500, {{"margin", 0.05}});
    request.viapoints = {{{5, 13, 0.2}}};
    const Answer answer = planner.plan(request);
    // Where it does not drive through the via point, the adapter tries to stand there.
    ASSERT_LE(outcome.status, 1) << outcome.err;
    if (outcome.status != 0) continue;
    ASSERT_EQ(answer.outcome, Outcome::solved) << answer.message;
    ++solved;
    const Json result = Json::parse(outcome.out);
    EXPECT_EQ(result.at("cost").get<double>(), answer.cost);
    EXPECT_EQ(segments_in(result.at("path")), answer.path->segments);
  }
  EXPECT_GE(solved, 4);
}

}  // namespace
}  // namespace vandplan::ros
