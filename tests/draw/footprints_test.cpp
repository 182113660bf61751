// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// What is under the mouse shows in an SVG.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "vandplan/draw.h"

namespace vandplan {
namespace {

Scenario yard_to_look_at() {
  Scenario scenario;
  scenario.bounds = {-2000, 2000, -2000, 2000};
  scenario.start = {1000, 0, 0};
  scenario.goal = {1015, 0, 0};
  scenario.obstacles = {{{1008, 8}, {1012, 8}, {1012, 12}, {1008, 12}},
                        {{-900, 0}, {-899, 0}, {-899, 1}}};
  scenario.kerbs = {{{1008, -8}, {1012, -8}, {1012, -7}}};
  return scenario;
}

Path path_to_look_at() { return {{1000, 0, 0}, {{0, 20}, {0, -5}}}; }

std::vector<std::size_t> places_of(const std::string& text, const std::string& part) {
  std::vector<std::size_t> places;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    places.push_back(at);
  }
  return places;
}

TEST(Footprints, EachPlaceOfThePathHasTheFootprintThere) {
  const Scenario scenario = yard_to_look_at();
  const Path path = path_to_look_at();
  const std::string picture =
      draw({.scenario = &scenario, .path = &path, .footprints = true}, PictureFormat::svg, 600);
  // Every 0.2 m, with both ends of each stroke.
  EXPECT_EQ(places_of(picture, "class=\"vandplan-place\"").size(), 127U);
  EXPECT_EQ(places_of(picture, "<use href=\"#vandplan-body\"").size(), 127U);
  EXPECT_EQ(places_of(picture, "m reverse: ").size(), 26U);
  EXPECT_EQ(places_of(picture, "<title>5.0 m forward: x 1005.00 m, y 0.00 m, heading 0.0").size(),
            1U);
  EXPECT_EQ(places_of(picture, "<title>25.0 m reverse: x 1015.00 m, ").size(), 1U);
  EXPECT_EQ(places_of(picture, "translate(1005.000,0.000) rotate(0.00)").size(), 1U);
  EXPECT_EQ(places_of(picture, "</svg>").size(), 1U);
}

TEST(Footprints, OnlyPicturesThatAskHaveThem) {
  const Scenario scenario = yard_to_look_at();
  const Path path = path_to_look_at();
  const Drawing plain{.scenario = &scenario, .path = &path};
  EXPECT_TRUE(places_of(draw(plain, PictureFormat::svg, 600), "vandplan-").empty());
  Drawing asks = plain;
  asks.footprints = true;
  EXPECT_EQ(draw(asks, PictureFormat::png, 100), draw(plain, PictureFormat::png, 100));
}

TEST(Footprints, ObstaclesThatAreSeenHaveTheirNumber) {
  const Scenario scenario = yard_to_look_at();
  const std::string picture =
      draw({.scenario = &scenario, .footprints = true}, PictureFormat::svg, 600);
  EXPECT_EQ(places_of(picture, "<title>obstacles[0]</title>").size(), 1U);
  EXPECT_EQ(places_of(picture, "<title>obstacles[1]</title>").size(), 0U);  // out of the picture
  EXPECT_EQ(places_of(picture, "<title>kerbs[0]</title>").size(), 1U);
  EXPECT_TRUE(places_of(picture, "vandplan-place\">").empty());
}

TEST(Footprints, ATrailerHasItsOwn) {
  Scenario scenario = yard_to_look_at();
  scenario.vehicle.trailer = Trailer{};
  const Path path = path_to_look_at();
  const std::string picture =
      draw({.scenario = &scenario, .path = &path, .footprints = true}, PictureFormat::svg, 600);
  EXPECT_EQ(places_of(picture, "<use href=\"#vandplan-trailer\"").size(), 127U);
}

TEST(Footprints, AnAbsurdlyLongPathHasFewPlaces) {
  const Scenario scenario = yard_to_look_at();
  const Path path{{1000, 0, 0}, {{0.1, 1e9}}};
  const std::string picture =
      draw({.scenario = &scenario, .path = &path, .footprints = true}, PictureFormat::svg, 600);
  EXPECT_LT(places_of(picture, "class=\"vandplan-place\"").size(), 160U);
}

}  // namespace
}  // namespace vandplan
