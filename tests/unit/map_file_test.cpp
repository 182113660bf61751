// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <gtest/gtest.h>
#include <png.h>

#include <string>
#include <vector>

#include "support/temporary_folder.h"
#include "vandplan/input_error.h"
#include "vandplan/io.h"

namespace vandplan {
namespace {

constexpr Cell free_cell = Cell::free;
constexpr Cell occupied = Cell::occupied;
constexpr Cell unknown = Cell::unknown;
using Cells = std::vector<Cell>;

const std::string keys =
    "image: m.pgm\nresolution: 0.05\norigin: [1.5, -2, 0.25]\nnegate: 0\n"
    "occupied_thresh: 0.65\nfree_thresh: 0.196\n";

class MapFile : public testing::Test {
 protected:
  OccupancyGrid read(const std::string& yaml, const std::string& image) {
    folder_.put("m.pgm", image);
    return read_map(folder_.put("m.yaml", yaml));
  }

  Cells cells(const std::string& yaml, const std::string& image) {
    return *read(yaml, image).cells;
  }

  /// What is wrong, without the name of the folder.
  std::string message(const std::string& yaml, const std::string& image) {
    try {
      (void)read(yaml, image);
    } catch (const InputError& error) {
      std::string text = error.what();
      for (std::size_t at; (at = text.find(folder_.path() + "/")) != std::string::npos;) {
        text.erase(at, folder_.path().size() + 1);
      }
      return text;
    }
    return "no error";
  }

  TemporaryFolder folder_;
};

std::string exchanged(std::string text, const std::string& part, const std::string& by) {
  const std::size_t at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  return text.replace(at, part.size(), by);
}

std::string png(int format, int columns, int rows, const std::vector<png_byte>& bytes) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(columns);
  image.height = static_cast<png_uint_32>(rows);
  image.format = static_cast<png_uint_32>(format);
  png_alloc_size_t size = 0;
  png_image_write_get_memory_size(image, size, 0, bytes.data(), 0, nullptr);
  std::string result(size, '\0');
  EXPECT_TRUE(png_image_write_to_memory(&image, result.data(), &size, 0, bytes.data(), 0, nullptr));
  result.resize(size);
  return result;
}

TEST_F(MapFile, TheFirstRowOfTheImageIsTheOneOfTheLargestY) {
  const OccupancyGrid grid = read(keys, "P2 3 2 255\n0 255 255\n255 255 205\n");
  EXPECT_EQ(grid.columns, 3);
  EXPECT_EQ(grid.rows, 2);
  EXPECT_EQ(grid.resolution, 0.05);
  EXPECT_EQ(grid.origin, (Pose{1.5, -2, 0.25}));
  EXPECT_FALSE(grid.unknown_is_free);
  EXPECT_EQ(*grid.cells, (Cells{free_cell, free_cell, unknown, occupied, free_cell, free_cell}));
}

TEST_F(MapFile, EveryKindOfPgmIsRead) {
  const Cells expected{occupied, free_cell};
  EXPECT_EQ(cells(keys, "P2 # plain\n2 # wide\n1\n9\n0\n9"), expected);
  EXPECT_EQ(cells(keys, "P5 2 1 255\n" + std::string("\0\xFF", 2)), expected);
  EXPECT_EQ(cells(keys, "P5\n# by hand\n2 1\n1000\n" + std::string("\0\0\x03\xE8", 4)), expected);
}

// Darkness is occupancy: 89 of 255 is 0.651, 90 is 0.647; 204 is 0.2, 205 is 0.19608, 206 0.192.
TEST_F(MapFile, ThresholdsAreNoPartOfTheKindsTheyBound) {
  EXPECT_EQ(cells(keys, "P2 5 1 255 89 90 204 205 206"),
            (Cells{occupied, unknown, unknown, unknown, free_cell}));
  // 0.25 and 0.75 are exact.
  const std::string exact = exchanged(exchanged(keys, "0.65", "0.75"), "0.196", "0.25");
  EXPECT_EQ(cells(exact, "P2 4 1 8 1 2 6 7"), (Cells{occupied, unknown, unknown, free_cell}));
}

TEST_F(MapFile, NegateTurnsBlackAndWhiteRound) {
  const std::string negated = exchanged(keys, "negate: 0", "negate: 1");
  EXPECT_EQ(cells(negated, "P2 3 1 255 0 128 255"), (Cells{free_cell, unknown, occupied}));
}

// Between the thresholds map_server counts 0 to 100, rounded: only what becomes 0 is free.
TEST_F(MapFile, ScaleRoundsBetweenTheThresholds) {
  const std::string scale =
      exchanged(exchanged(keys, "0.65", "0.8"), "0.196", "0.2") + "mode: scale\n";
  EXPECT_EQ(cells(scale, "P2 6 1 1000 100 201 500 790 798 900"),
            (Cells{occupied, occupied, unknown, unknown, free_cell, free_cell}));
}

// A raw value up to 100 is the occupancy in percent, whatever `negate` says; others are unknown.
TEST_F(MapFile, RawValuesArePercent) {
  const std::string raw = exchanged(keys, "negate: 0", "negate: 1") + "mode: raw\n";
  EXPECT_EQ(cells(raw, "P2 6 1 255 0 19 20 65 66 101"),
            (Cells{free_cell, free_cell, unknown, unknown, occupied, unknown}));
}

TEST_F(MapFile, EveryKindOfPngIsRead) {
  const Cells expected{occupied, free_cell};
  EXPECT_EQ(cells(keys, png(PNG_FORMAT_GRAY, 2, 1, {0, 255})), expected);
  EXPECT_EQ(cells(keys, png(PNG_FORMAT_RGB, 2, 1, {0, 0, 90, 255, 255, 255})), expected);
  EXPECT_EQ(cells(keys, png(PNG_FORMAT_RGBA, 2, 1, {0, 0, 0, 255, 255, 255, 255, 254})),
            (Cells{occupied, free_cell}));
}

// Red, green and blue are averaged, with opacity as one more channel: 255 / 4 is darker than 89.25.
TEST_F(MapFile, OpacityIsAChannelUnlessScaling) {
  const std::string clear_black = png(PNG_FORMAT_GA, 3, 1, {0, 255, 0, 0, 255, 0});
  EXPECT_EQ(cells(keys, clear_black), (Cells{occupied, occupied, unknown}));
  EXPECT_EQ(cells(keys + "mode: scale\n", clear_black), (Cells{occupied, unknown, unknown}));
  EXPECT_EQ(cells(keys + "mode: raw\n", clear_black), (Cells{free_cell, free_cell, unknown}));
}

TEST_F(MapFile, BadMapsHaveOneLineEach) {
  const std::string good = "P2 1 1 255 0";
  const auto spoilt = [&](const std::string& part, const std::string& by) {
    return message(exchanged(keys, part, by), good);
  };
  EXPECT_EQ(spoilt("image: m.pgm", "image: gone.pgm"),
            "m.yaml:1: image: gone.pgm: cannot open: No such file or directory");
  EXPECT_EQ(spoilt("resolution: 0.05", "resolution: 0"),
            "m.yaml:2: resolution: is 0, expected more than 0 m");
  EXPECT_EQ(spoilt("resolution: 0.05", "resolution: .nan"),
            "m.yaml:2: resolution: is \".nan\", expected a finite number");
  EXPECT_EQ(spoilt("[1.5, -2, 0.25]", "[1.5, -2]"),
            "m.yaml:3: origin: has 2 elements, expected [x, y, yaw]");
  EXPECT_EQ(spoilt("negate: 0", "negate: 2"), "m.yaml:4: negate: is \"2\", expected 0 or 1");
  EXPECT_EQ(spoilt("0.65", "1.65"), "m.yaml:5: occupied_thresh: is 1.65, expected 0 to 1");
  EXPECT_EQ(spoilt("0.65", "0.1"),
            "m.yaml:6: free_thresh: is 0.196, expected no more than occupied_thresh");
  EXPECT_EQ(message(keys + "mode: grey\n", good),
            "m.yaml:7: mode: is \"grey\", expected trinary, scale or raw");
  EXPECT_EQ(message(keys + "size: 3\n", good),
            "m.yaml:7: unknown key \"size\", expected one of image, resolution, origin, negate, "
            "occupied_thresh, free_thresh, mode");
  EXPECT_EQ(spoilt("negate: 0\n", ""), "m.yaml:1: key \"negate\" is missing, expected it");
}

TEST_F(MapFile, BadImagesHaveOneLineEach) {
  const auto image = [&](const std::string& bytes) {
    const std::string text = message(keys, bytes);
    const std::string begin = "m.yaml:1: image: m.pgm: ";
    EXPECT_EQ(text.substr(0, begin.size()), begin);
    return text.substr(std::min(begin.size(), text.size()));
  };
  EXPECT_EQ(image("GIF89a"), "is no image that can be read, expected PGM (P2 or P5) or PNG");
  EXPECT_EQ(image(""), "is no image that can be read, expected PGM (P2 or P5) or PNG");
  EXPECT_EQ(image("P5"), "ends before its width, expected a whole PGM image");
  EXPECT_EQ(image("P5 x"), "has no width at byte 3, expected a decimal number");
  EXPECT_EQ(image("P5 100000 200000 255\n"),
            "is 100000 x 200000 pixels, expected at least one and at most 100000000");
  EXPECT_EQ(image("P5 0 4 255\n"), "is 0 x 4 pixels, expected at least one and at most 100000000");
  EXPECT_EQ(image("P5 99999999999999999999 4 255\n"),
            "has a width of 99999999999999999999, expected at most 9223372036854775807");
  EXPECT_EQ(image("P5 5000 5000 255\nabc"),
            "holds 20 bytes for 5000 x 5000 pixels, expected a whole PGM image");
  EXPECT_EQ(image("P5 4 4 255\nabcdefgh"),
            "ends after 8 of 16 bytes of pixels, expected a whole PGM image");
  EXPECT_EQ(image("P5 1 1 70000\n1"), "has a greatest value of 70000, expected at most 65535");
  EXPECT_EQ(image("P5 1 1 0\n1"), "has a greatest value of 0, expected 1 to 65535");
  EXPECT_EQ(image("P2 2 1 9 9 10"), "has a pixel of 10, expected at most 9");
  EXPECT_EQ(image("P2 2 1 9 9      "), "ends before its pixel, expected a whole PGM image");
  const std::string whole = png(PNG_FORMAT_GRAY, 2, 1, {0, 255});
  for (std::size_t size = 4; size + 1 < whole.size(); ++size) {
    EXPECT_EQ(image(whole.substr(0, size)).substr(0, 22), "is a broken PNG image ");
  }
}

}  // namespace
}  // namespace vandplan
