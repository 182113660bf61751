// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/draw.h"
#include "support/radius.h"

#include <cairo.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "draw/canvas.h"
#include "draw/frame.h"
#include "draw/scene.h"
#include "support/grids.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

using drawing::Colour;

using std::numbers::pi;

// A truck drives 20 m ahead, backs off over a quarter turn and passes a 4 m x 4 m block.
Scenario yard() {
  Scenario scenario;
  scenario.name = "yard";
  scenario.bounds = {-200, 200, -200, 200};
  scenario.start = {0, 0, 0};
  scenario.goal = {13, -7, pi / 2};
  scenario.obstacles = {{{8, 8}, {12, 8}, {12, 12}, {8, 12}}};
  return scenario;
}

Path yard_path() { return {{0, 0, 0}, {{0, 20}, {-1 / default_radius, -default_radius * pi / 2}}}; }

Scenario moved(Scenario scenario, double x, double y) {
  scenario.bounds = {scenario.bounds.x_min + x, scenario.bounds.x_max + x,
                     scenario.bounds.y_min + y, scenario.bounds.y_max + y};
  for (Pose* pose : {&scenario.start, &scenario.goal}) {
    pose->x += x;
    pose->y += y;
  }
  for (Polygon& polygon : scenario.obstacles) {
    for (Point& corner : polygon) corner = {corner.x + x, corner.y + y};
  }
  return scenario;
}

// A PNG read back, 8 bits for each of red, green and blue.
class Image {
 public:
  explicit Image(const std::string& png) {
    Source source{&png, 0};
    surface_.reset(cairo_image_surface_create_from_png_stream(read, &source));
    EXPECT_EQ(cairo_surface_status(surface_.get()), CAIRO_STATUS_SUCCESS);
  }
  int width() const { return cairo_image_surface_get_width(surface_.get()); }
  int height() const { return cairo_image_surface_get_height(surface_.get()); }
  std::array<int, 3> at(int x, int y) const {
    const unsigned char* row = cairo_image_surface_get_data(surface_.get()) +
                               y * cairo_image_surface_get_stride(surface_.get());
    std::uint32_t pixel = 0;
    std::memcpy(&pixel, row + 4 * x, sizeof pixel);
    const auto channel = [&](int shift) { return static_cast<int>(pixel >> shift & 0xff); };
    return {channel(16), channel(8), channel(0)};
  }
  std::array<int, 3> at(const Point& place) const {
    return at(static_cast<int>(place.x), static_cast<int>(place.y));
  }

 private:
  struct Source {
    const std::string* bytes;
    std::size_t position;
  };
  static cairo_status_t read(void* source, unsigned char* data, unsigned int size) {
    auto& [bytes, position] = *static_cast<Source*>(source);
    if (position + size > bytes->size()) return CAIRO_STATUS_READ_ERROR;
    std::memcpy(data, bytes->data() + position, size);
    position += size;
    return CAIRO_STATUS_SUCCESS;
  }
  std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface_{
      nullptr, cairo_surface_destroy};
};

// Equal but for a trace of what is drawn over it, such as grid lines.
bool matches(const std::array<int, 3>& pixel, const Colour& colour) {
  const std::array<double, 3> wanted{colour.red, colour.green, colour.blue};
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::abs(pixel[i] - 255 * wanted[i]) > 20) return false;
  }
  return true;
}

testing::AssertionResult looks(const std::array<int, 3>& pixel, const Colour& colour) {
  if (matches(pixel, colour)) return testing::AssertionSuccess();
  return testing::AssertionFailure() << testing::PrintToString(pixel);
}

constexpr int page_width = 900;  // one pixel is one page unit

// A drawing with the page it comes out on.
struct Page {
  explicit Page(const Drawing& drawing)
      : image(draw(drawing, PictureFormat::png, page_width)),
        view(drawing::layout_of(drawing::scene_of(drawing), !drawing.caption.empty()).view) {}
  std::array<int, 3> at(const Point& local) const { return image.at(view.on_page(local)); }
  Image image;
  drawing::View view;
};

// Every element that is opened is closed, in order.
bool is_well_formed(const std::string& xml) {
  std::vector<std::string> open;
  for (std::size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', at + 1)) {
    const std::size_t end = xml.find('>', at);
    if (end == std::string::npos) return false;
    const std::string tag = xml.substr(at + 1, end - at - 1);
    const std::string name = tag.substr(0, tag.find_first_of(" \n/", 1));
    if (tag[0] == '?' || tag[0] == '!' || tag.back() == '/') continue;
    if (tag[0] != '/') {
      open.push_back(name);
    } else if (open.empty() || "/" + open.back() != tag) {
      return false;
    } else {
      open.pop_back();
    }
  }
  return open.empty() && !xml.empty();
}

TEST(PictureFormat, FollowsTheEndingOfTheFile) {
  EXPECT_EQ(picture_format("a.png"), PictureFormat::png);
  EXPECT_EQ(picture_format("out/b.svg"), PictureFormat::svg);
  EXPECT_EQ(picture_format("c.d.pdf"), PictureFormat::pdf);
  EXPECT_THROW((void)picture_format("picture.jpg"), InputError);
  EXPECT_THROW((void)picture_format("png"), InputError);
}

TEST(Draw, BytesBeginAsTheFormatDoes) {
  const Scenario scenario = yard();
  const Drawing drawing{.scenario = &scenario};
  EXPECT_TRUE(draw(drawing, PictureFormat::png, 300).starts_with("\x89PNG\r\n"));
  EXPECT_TRUE(draw(drawing, PictureFormat::svg, 300).starts_with("<?xml"));
  EXPECT_TRUE(draw(drawing, PictureFormat::pdf, 300).starts_with("%PDF-"));
}

TEST(Draw, PngHasTheWidthAskedForAndTheShapeOfThePage) {
  const Scenario scenario = yard();
  const Drawing drawing{.scenario = &scenario, .caption = "yard"};
  const drawing::Size page = drawing::layout_of(drawing::scene_of(drawing), true).page;
  const Image image(draw(drawing, PictureFormat::png, 450));
  EXPECT_EQ(image.width(), 450);
  EXPECT_EQ(image.height(), std::lround(page.height / 2));
}

TEST(Draw, SvgIsWellFormedWhateverTheCaption) {
  const Scenario scenario = yard();
  const Path path = yard_path();
  const Drawing drawing{.scenario = &scenario, .path = &path, .caption = "<&\"'> V\u00e4ndplan"};
  EXPECT_TRUE(is_well_formed(draw(drawing, PictureFormat::svg, 900)));
  EXPECT_FALSE(is_well_formed("<svg><g></svg>"));
}

TEST(Draw, EverythingHasItsColourAtItsPlace) {
  const Scenario scenario = yard();
  const Path path = yard_path();
  const Page page({.scenario = &scenario, .path = &path});
  EXPECT_TRUE(looks(page.at({10.3, 10.4}), drawing::colour::obstacle));
  EXPECT_TRUE(looks(page.at({-0.75, 1.275}), drawing::colour::start)) << "the outline";
  EXPECT_TRUE(looks(page.at({13 + 1.275, -7.75}), drawing::colour::goal)) << "the outline";
  EXPECT_TRUE(looks(page.at({9, 0}), drawing::colour::forward));
  const Pose backing = pose_at(path, 20 + default_radius * pi / 4);
  EXPECT_TRUE(looks(page.at({backing.x, backing.y}), drawing::colour::reverse));
  EXPECT_TRUE(looks(page.at({20, 0}), drawing::colour::paper)) << "inside the gear change's ring";
  const auto swept = page.at({11, 0.7});
  EXPECT_LT(swept[0], swept[2]) << "a bluish veil";
  EXPECT_TRUE(looks(page.at({3.3, 10.4}), drawing::colour::paper));
}

TEST(Draw, WhatWasDrivenIsALineOverThePath) {
  const Scenario scenario = yard();
  const Path path = yard_path();
  const std::vector<Pose> driven = {{0, 3, 0}, {20, 3, 0}};
  const Page page({.scenario = &scenario, .path = &path, .driven = &driven});
  int dark = 0;
  for (const double y : {2.95, 2.975, 3.0, 3.025, 3.05}) dark += page.at({15, y})[0] < 60;
  EXPECT_GE(dark, 1);
  EXPECT_TRUE(looks(page.at({9, 0}), drawing::colour::forward));
  const std::vector<Pose> nowhere = {{std::nan(""), 0, 0}};
  EXPECT_THROW((void)draw({.scenario = &scenario, .driven = &nowhere}, PictureFormat::png, 300),
               InputError);
}

// Ahead 20 m straight, back a quarter of a circle to the right.
TEST(Draw, TheStripShowsHowFarTheWheelsAreTurned) {
  const Scenario scenario = yard();
  const Path path = yard_path();
  const Drawing drawing{.scenario = &scenario, .path = &path, .curvature_strip = true};
  const drawing::Layout layout = drawing::layout_of(drawing::scene_of(drawing), false);
  ASSERT_TRUE(layout.strip);
  const drawing::Box& strip = *layout.strip;
  const Image image(draw(drawing, PictureFormat::png, page_width));
  const double driven = 20 + default_radius * pi / 2;
  const double middle = strip.y + strip.height / 2;
  const auto at = [&](double s, double y) {
    return image.at({strip.x + s / driven * strip.width, y});
  };
  const double turned = 0.4 * strip.height;  // of 1 / default_radius, on the page
  EXPECT_TRUE(looks(at(10, middle), drawing::colour::forward));
  EXPECT_TRUE(looks(at(25, middle + turned), drawing::colour::reverse));
  EXPECT_TRUE(looks(at(10, middle + turned / 2), drawing::colour::paper));
  EXPECT_TRUE(looks(at(25, middle - turned / 2), drawing::colour::paper));
  // The limits are dashed, the gear change has a tick at each edge.
  int dashes = 0;
  int ticks = 0;
  for (double s = 1; s < 20; s += 0.05) {
    dashes += !looks(at(s, middle - turned), drawing::colour::paper);
  }
  for (const double y : {strip.y + 4, strip.y + strip.height - 4}) {
    EXPECT_TRUE(looks(at(15, y), drawing::colour::paper));
    ticks += image.at({strip.x + 20 / driven * strip.width, y})[0] < 150;
  }
  EXPECT_GT(dashes, 100);
  EXPECT_LT(dashes, 300);
  EXPECT_EQ(ticks, 2);
}

TEST(Draw, TheStripFollowsAClothoid) {
  Scenario scenario = yard();
  const double lock = 1 / default_radius;
  const Path path{{0, 0, 0}, {{0, 10, lock / 10}, {lock, 10, -lock / 10}}};
  scenario.goal = end_pose(path);
  const Drawing drawing{.scenario = &scenario, .path = &path, .curvature_strip = true};
  const drawing::Box strip = *drawing::layout_of(drawing::scene_of(drawing), false).strip;
  const Image image(draw(drawing, PictureFormat::png, page_width));
  for (const double part : {0.25, 0.5, 0.75}) {
    for (const double s : {10 * part, 20 - 10 * part}) {
      const double y = strip.y + strip.height * (0.5 - 0.4 * part);
      EXPECT_TRUE(looks(image.at({strip.x + s / 20 * strip.width, y}), drawing::colour::forward))
          << s;
    }
  }
}

TEST(Draw, ThereIsNoStripUnlessAskedForAndWithoutAPath) {
  const Scenario scenario = yard();
  const Path path = yard_path();
  const Path none{{0, 0, 0}, {}};
  const auto layout = [&](const Path* drawn, bool asked) {
    return drawing::layout_of(
        drawing::scene_of({.scenario = &scenario, .path = drawn, .curvature_strip = asked}), false);
  };
  EXPECT_FALSE(layout(&path, false).strip);
  EXPECT_FALSE(layout(nullptr, true).strip);
  EXPECT_GT(layout(&path, true).page.height, layout(&path, false).page.height + 100);
  EXPECT_EQ(layout(nullptr, true).page.height, layout(nullptr, false).page.height);
  EXPECT_NE(draw({.scenario = &scenario, .path = &none, .curvature_strip = true},
                 PictureFormat::svg, 300),
            "");
}

TEST(Draw, GroundOutOfBoundsIsShaded) {
  Scenario scenario = yard();
  scenario.bounds.x_max = 15;
  const Page page({.scenario = &scenario});
  EXPECT_TRUE(looks(page.at({14.2, 2.3}), drawing::colour::paper));
  EXPECT_TRUE(looks(page.at({15.5, 2.3}), drawing::colour::outside));
}

TEST(Draw, TreeIsDrawnWhenThereIsOne) {
  const Scenario scenario = yard();
  // One straight edge along y = 5 m, and a root without any.
  const TreeSnapshot tree{{{2, 5, 0}, {6, 5, 0}, {4, 8, 0}}, {-1, 0, -1}};
  const Drawing without{.scenario = &scenario};
  const Drawing with{.scenario = &scenario, .tree = &tree};
  const Page a(without);
  const Page b(with);
  // The line is half a pixel wide and may lie across two rows.
  const Point begin = a.view.on_page({2, 5});
  const Point end = a.view.on_page({6, 5});
  int darker = 0;
  for (int x = static_cast<int>(begin.x) + 1; x < static_cast<int>(end.x); ++x) {
    int change = 0;
    for (int y = static_cast<int>(begin.y) - 1; y <= static_cast<int>(begin.y) + 1; ++y) {
      change += a.image.at(x, y)[0] - b.image.at(x, y)[0];
    }
    darker += change > 20;
  }
  EXPECT_GE(darker, static_cast<int>(end.x - begin.x) - 2) << "all along";
}

TEST(Draw, FarFromTheOriginOnlyTheLabelsDiffer) {
  const double x = 4'517'230'000;  // [m]
  const double y = -8'651'230'000;
  const Scenario near = yard();
  const Scenario far = moved(near, x, y);
  const Path near_path = yard_path();
  Path far_path = near_path;
  far_path.start = {x, y, 0};
  const Page a({.scenario = &near, .path = &near_path});
  const Page b({.scenario = &far, .path = &far_path});
  const drawing::Box& plot = a.view.plot;
  int different = 0;
  for (int row = 0; row < static_cast<int>(plot.y + plot.height); ++row) {
    for (int column = static_cast<int>(plot.x); column < page_width; ++column) {
      different += a.image.at(column, row) != b.image.at(column, row);
    }
  }
  EXPECT_EQ(different, 0);
}

drawing::Framing framing_of(const Scenario& scenario) {
  return drawing::framed(drawing::scene_of({.scenario = &scenario}));
}

TEST(Draw, FarObstaclesDoNotShrinkTheScene) {
  Scenario scenario = yard();
  const drawing::Framing before = framing_of(scenario);
  EXPECT_FALSE(before.is_cropped);
  scenario.obstacles.push_back({{9e5, 9e5}, {9e5 + 5, 9e5}, {9e5, 9e5 + 5}});
  EXPECT_EQ(framing_of(scenario).seen, before.seen);
  EXPECT_TRUE(framing_of(scenario).is_cropped);
}

TEST(Draw, AllThatStandsAroundThePathIsShown) {
  Scenario scenario = yard();
  scenario.obstacles.push_back({{-18, -24}, {-16, -24}, {-16, -22}, {-18, -22}});
  scenario.kerbs.push_back({{25, 8}, {27, 8}, {27, 16}, {25, 16}});
  const drawing::Framing framing = framing_of(scenario);
  EXPECT_FALSE(framing.is_cropped);
  EXPECT_TRUE(contains(framing.seen, {-18, -24}));
  EXPECT_TRUE(contains(framing.seen, {27, 16}));
}

TEST(Draw, TheFenceOfAYardIsShownAndGenerousBoundsAreNot) {
  Scenario scenario = yard();
  EXPECT_FALSE(contains(framing_of(scenario).seen, {-199, -199}));
  scenario.bounds = {-6, 24, -14, 16};
  EXPECT_TRUE(contains(framing_of(scenario).seen, {-6, -14}));
  EXPECT_TRUE(contains(framing_of(scenario).seen, {24, 16}));
}

TEST(Draw, ACroppedPictureSaysSo) {
  Scenario scenario = yard();
  const auto ink_below = [&] {  // dark pixels left of the middle, where the axis has its title
    const Page page({.scenario = &scenario});
    const drawing::Box& plot = page.view.plot;
    int found = 0;
    for (int row = static_cast<int>(plot.y + plot.height) + 22; row < page.image.height(); ++row) {
      if (row > plot.y + plot.height + 36) break;
      for (int column = static_cast<int>(plot.x); column < plot.x + 200; ++column) {
        found += page.image.at(column, row)[0] < 180;
      }
    }
    return found;
  };
  EXPECT_EQ(ink_below(), 0);
  scenario.obstacles.push_back({{9e5, 9e5}, {9e5 + 5, 9e5}, {9e5, 9e5 + 5}});
  EXPECT_GT(ink_below(), 100);
}

TEST(Draw, AnObstacleThatReachesFarOutCoversTheViewWhereItShould) {
  Scenario scenario = yard();
  scenario.obstacles = {{{-9e5, 4}, {9e5, 4}, {9e5, 9e5}, {-9e5, 9e5}}};
  const Page page({.scenario = &scenario});
  EXPECT_TRUE(looks(page.at({3.3, 4.5}), drawing::colour::obstacle));
  EXPECT_TRUE(looks(page.at({3.3, 3.5}), drawing::colour::paper));
}

TEST(Draw, EveryCellOfASheetShowsItsDrawing) {
  const Scenario scenario = yard();
  const Drawing drawing{.scenario = &scenario, .caption = "yard"};
  const ContactSheet sheet{.drawings = {5, drawing}, .columns = 2, .caption = "five yards"};
  const Image image(draw(sheet, PictureFormat::png, 480));
  EXPECT_EQ(image.width(), 480);
  // Dark pixels of the block, 3 rows of cells, the sixth one empty.
  const int cell_height = 208;
  for (int cell = 0; cell < 6; ++cell) {
    int found = 0;
    for (int row = 0; row < cell_height; ++row) {
      for (int column = 0; column < 240; ++column) {
        const auto pixel = image.at(240 * (cell % 2) + column, 40 + cell_height * (cell / 2) + row);
        found += matches(pixel, drawing::colour::obstacle);
      }
    }
    EXPECT_EQ(found > 200, cell < 5) << "cell " << cell;
  }
}

TEST(MapImage, HasItsFirstRowFirstAndLeavesWhatIsFreeOpen) {
  const MapImage image = map_image(grid_of({"#..", "..?"}, 0.5), 3);
  const Image pixels(image.png);
  EXPECT_EQ(pixels.width(), 3);
  EXPECT_EQ(pixels.height(), 2);
  EXPECT_EQ(image.width, 1.5);
  EXPECT_EQ(image.height, 1.0);
  EXPECT_TRUE(matches(pixels.at(2, 0), drawing::colour::unknown));
  EXPECT_TRUE(matches(pixels.at(0, 1), drawing::colour::obstacle));
  EXPECT_EQ(pixels.at(0, 0), (std::array{0, 0, 0}));  // transparent: nothing of any colour
}

TEST(MapImage, ShowsTheWorstCellOfABlock) {
  const MapImage image = map_image(grid_of({"....?", ".....", ".#..."}, 0.5), 3);
  const Image pixels(image.png);
  EXPECT_EQ(pixels.width(), 3);  // of 2 x 2 cells
  EXPECT_EQ(pixels.height(), 2);
  EXPECT_EQ(image.width, 3.0);
  EXPECT_EQ(image.height, 2.0);
  EXPECT_TRUE(matches(pixels.at(0, 0), drawing::colour::obstacle));
  EXPECT_TRUE(matches(pixels.at(2, 1), drawing::colour::unknown));
}

TEST(Draw, WhatMovesIsShownFainterWhereItIsLater) {
  Scenario scenario = yard();
  const Polygon car{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  scenario.moving = {{.outline = car, .trajectory = {{0, {-6, 12, 0}}, {8, {2, 12, 0}}}}};
  const drawing::Scene scene = drawing::scene_of({.scenario = &scenario});
  ASSERT_EQ(scene.shadows.size(), 9U);
  EXPECT_EQ(scene.shadows.back().strength, 1.0);
  EXPECT_EQ(scene.shadows.back().outline[0], (Point{-7, 11}));
  EXPECT_LT(scene.shadows.front().strength, 0.2);
  EXPECT_NEAR(scene.shadows.front().outline[0].x, 1, 1e-12);
  const std::string still = draw({.scenario = &scenario}, PictureFormat::svg, 600);
  EXPECT_NE(still, [&] {
    scenario.moving.clear();
    return draw({.scenario = &scenario}, PictureFormat::svg, 600);
  }());
}

TEST(Draw, APathWithTimesPlays) {
  Scenario scenario = yard();
  const Polygon car{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  scenario.moving = {{.outline = car,
                      .trajectory = {{0, {-6, 12, 0}}, {8, {2, 12, 0}}},
                      .after = Afterwards::leaves}};
  const Path path = yard_path();
  const SpeedProfile speeds = speed_profile(path, scenario.vehicle);
  const Drawing drawing{.scenario = &scenario, .path = &path, .speeds = &speeds};
  const std::string film = draw(drawing, PictureFormat::svg, 600);
  const auto count = [&](const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = film.find(part); at != std::string::npos; at = film.find(part, at + 1)) {
      ++found;
    }
    return found;
  };
  EXPECT_EQ(count("type=\"translate\""), 2U);
  EXPECT_EQ(count("type=\"rotate\""), 2U);
  EXPECT_EQ(count("attributeName=\"opacity\""), 1U);
  EXPECT_EQ(count("values=\"0.000,0.000;"), 1U);  // the truck begins at its start
  EXPECT_EQ(count("</svg>"), 1U);
  EXPECT_EQ(draw(drawing, PictureFormat::png, 600).substr(1, 3), "PNG");
}

TEST(Draw, ATrailerPlaysBehindItsTractor) {
  Scenario scenario = yard();
  scenario.vehicle.trailer = Trailer{};
  scenario.hitch_angles.start = 0.5;
  const Path path{scenario.start, {{0, 10}}};
  const SpeedProfile speeds = speed_profile(path, scenario.vehicle);
  const std::string film =
      draw({.scenario = &scenario, .path = &path, .speeds = &speeds}, PictureFormat::svg, 600);
  // 8.1 m behind the hitch, which is at the start, turned by half a radian to the right.
  EXPECT_NE(film.find("values=\"-7.108,3.883;"), std::string::npos);
  EXPECT_NE(film.find("values=\"-28.65;"), std::string::npos);
}

TEST(Draw, TheSameDrawingGivesTheSameBytes) {
  const Scenario scenario = yard();
  const Path path = yard_path();
  const Drawing drawing{.scenario = &scenario, .path = &path, .caption = "yard"};
  EXPECT_EQ(draw(drawing, PictureFormat::png, 300), draw(drawing, PictureFormat::png, 300));
}

TEST(Draw, APathOfAbsurdLengthIsDrawnAllTheSame) {
  const Scenario scenario = yard();
  const Path path{{0, 0, 0}, {{0, 1e9}, {1 / default_radius, 1e9}}};
  EXPECT_FALSE(draw({.scenario = &scenario, .path = &path}, PictureFormat::png, 300).empty());
  const Drawing with_strip{.scenario = &scenario, .path = &path, .curvature_strip = true};
  EXPECT_FALSE(draw(with_strip, PictureFormat::png, 300).empty());
}

TEST(Draw, BadInputIsNamed) {
  const Scenario scenario = yard();
  const Path broken{{0, 0, 0}, {{0, std::numeric_limits<double>::quiet_NaN()}}};
  const auto draw_png = [](const Drawing& drawing, int width) {
    return draw(drawing, PictureFormat::png, width);
  };
  EXPECT_THROW((void)draw_png({}, 300), InputError);
  EXPECT_THROW((void)draw_png({.scenario = &scenario}, 49), InputError);
  EXPECT_THROW((void)draw_png({.scenario = &scenario}, 10001), InputError);
  EXPECT_THROW((void)draw_png({.scenario = &scenario, .path = &broken}, 300), InputError);
  const Path winding{{0, 0, 0}, {{0, 1, std::numeric_limits<double>::infinity()}}};
  EXPECT_THROW((void)draw_png({.scenario = &scenario, .path = &winding}, 300), InputError);
  EXPECT_THROW((void)draw_png({.scenario = &scenario, .caption = "\xff\xfe"}, 300), InputError);
  EXPECT_THROW((void)draw(ContactSheet{.columns = 0}, PictureFormat::png, 300), InputError);
}

TEST(Draw, ZonesAreTintedAndNamedWhereThereIsRoom) {
  Scenario scenario = yard();
  const auto area = [](double x, double size) {
    return Polygon{{x, -20}, {x + size, -20}, {x + size, -12}, {x, -12}};
  };
  scenario.zones = {{.area = area(-20, 8), .closed = true}, {.area = area(-8, 8), .cost = 2}};
  const auto tinted = [](const Colour& ink) {
    const auto mixed = [](double shade) { return 0.75 + 0.25 * shade; };
    return Colour{mixed(ink.red), mixed(ink.green), mixed(ink.blue)};
  };
  const Page page({.scenario = &scenario});
  EXPECT_TRUE(looks(page.at({-15.5, -15.5}), tinted(drawing::colour::obstacle)));
  EXPECT_TRUE(looks(page.at({-3.5, -15.5}), tinted(drawing::colour::kerb)));

  const auto drawn = [&] { return draw({.scenario = &scenario}, PictureFormat::png, page_width); };
  const std::string nameless = drawn();
  scenario.zones[1].name = std::string(100, 'm');
  EXPECT_EQ(drawn(), nameless);
  scenario.zones[1].name = "ramp";
  EXPECT_NE(drawn(), nameless);
}

TEST(Draw, StraightLastStretchesRunThroughTheGoal) {
  Scenario scenario = yard();
  scenario.goal_set = {{.x = {13, 13}, .y = {-7, -7}, .heading = {pi / 2, pi / 2}}};
  scenario.obstacles.push_back(
      {{12, -22}, {14, -22}, {14, -20}, {12, -20}});  // seen, so the line is
  const auto darkest = [&](double from, double to) {
    const Page page({.scenario = &scenario});
    int least = 255;
    for (double y = from; y < to; y += 0.02) least = std::min(least, page.at({13, y})[1]);
    return least;
  };
  EXPECT_GT(darkest(-14.8, -10.2), 200);
  scenario.goal_set[0].straight = 8;
  EXPECT_LT(darkest(-14.8, -10.2), 180);  // behind, for a path that ends forward
  EXPECT_LT(darkest(-0.5, 0.9), 180);     // ahead, for one that ends in reverse
}

TEST(TickStep, IsOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_DOUBLE_EQ(drawing::tick_step(10.0, 85.0), 5.0);  // 8.5 m
  EXPECT_DOUBLE_EQ(drawing::tick_step(10.0, 45.0), 2.0);
  EXPECT_DOUBLE_EQ(drawing::tick_step(1.0, 100.0), 100.0);
  EXPECT_DOUBLE_EQ(drawing::tick_step(400.0, 85.0), 0.2);
}

}  // namespace
}  // namespace vandplan
