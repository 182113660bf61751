// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <gtest/gtest.h>
#include <png.h>
#include <unistd.h>
#include <zlib.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "support/reader_test.h"
#include "support/temporary_folder.h"
#include "support/yard.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "vandplan/random.h"

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

/// Every kind of PNG, also those that `png` cannot write.
struct PngWriter {
  int depth = 8;  // bits of a channel
  int colour_type = PNG_COLOR_TYPE_GRAY;
  int interlace = PNG_INTERLACE_NONE;
  std::vector<png_color> palette = {};
  std::vector<png_byte> opacities = {};  // of the palette's colours

  [[nodiscard]] std::string written(std::vector<std::vector<png_byte>> rows, int columns) const {
    std::string bytes;
    png_structp file = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(file);
    const auto put = [](png_structp png, png_bytep from, std::size_t size) {
      static_cast<std::string*>(png_get_io_ptr(png))
          ->append(reinterpret_cast<const char*>(from), size);
    };
    png_set_write_fn(file, &bytes, put, nullptr);
    png_set_IHDR(file, info, static_cast<png_uint_32>(columns),
                 static_cast<png_uint_32>(rows.size()), depth, colour_type, interlace,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (!palette.empty()) {
      png_set_PLTE(file, info, palette.data(), static_cast<int>(palette.size()));
    }
    if (!opacities.empty()) {
      png_set_tRNS(file, info, opacities.data(), static_cast<int>(opacities.size()), nullptr);
    }
    std::vector<png_bytep> places;
    for (std::vector<png_byte>& row : rows) places.push_back(row.data());
    png_set_rows(file, info, places.data());
    png_write_png(file, info, PNG_TRANSFORM_IDENTITY, nullptr);
    png_destroy_write_struct(&file, &info);
    return bytes;
  }
};

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

// The part of 255 is compared with the decimal as written: 51 of 255 is 0.2, 153 is 0.6.
TEST_F(MapFile, AnExactThresholdBelongsToNeitherSide) {
  const std::string tenths = exchanged(exchanged(keys, "0.65", "0.6"), "0.196", "0.2");
  EXPECT_EQ(cells(tenths, "P2 4 1 255 101 102 204 205"),
            (Cells{occupied, unknown, unknown, free_cell}));
  const std::string negated = exchanged(tenths, "negate: 0", "negate: 1");
  EXPECT_EQ(cells(negated, "P2 4 1 255 154 153 51 50"),
            (Cells{occupied, unknown, unknown, free_cell}));
}

// map_server grades what lies between the thresholds; neither free nor occupied is unknown to us.
TEST_F(MapFile, ScaleLeavesUnknownWhatLiesBetweenTheThresholds) {
  const std::string scale =
      exchanged(exchanged(keys, "0.65", "0.8"), "0.196", "0.2") + "mode: scale\n";
  EXPECT_EQ(cells(scale, "P2 6 1 1000 100 199 201 500 799 900"),
            (Cells{occupied, occupied, unknown, unknown, unknown, free_cell}));
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
  EXPECT_EQ(cells(keys, png(PNG_FORMAT_RGBA, 2, 1, {0, 0, 0, 255, 255, 255, 255, 255})),
            (Cells{occupied, free_cell}));
}

TEST_F(MapFile, RedGreenAndBlueAreAveraged) {
  const std::string colours = png(PNG_FORMAT_RGB, 3, 1, {255, 0, 0, 255, 255, 0, 255, 255, 120});
  EXPECT_EQ(cells(keys, colours), (Cells{occupied, unknown, free_cell}));
}

TEST_F(MapFile, WhatIsNotOpaqueIsUnknownUnlessRaw) {
  const std::string partly_clear =
      png(PNG_FORMAT_GA, 5, 1, {0, 255, 0, 0, 255, 0, 255, 254, 255, 255});
  const Cells expected{occupied, unknown, unknown, unknown, free_cell};
  EXPECT_EQ(cells(keys, partly_clear), expected);
  EXPECT_EQ(cells(keys + "mode: scale\n", partly_clear), expected);
  EXPECT_EQ(cells(keys + "mode: raw\n", partly_clear),
            (Cells{free_cell, free_cell, unknown, unknown, unknown}));
  // 205 stays unknown beside an opacity.
  EXPECT_EQ(cells(keys, png(PNG_FORMAT_RGBA, 1, 1, {205, 205, 205, 255})), Cells{unknown});
}

TEST_F(MapFile, PngOfEveryDepthIsRead) {
  const Cells expected{occupied, unknown, free_cell};
  EXPECT_EQ(cells(keys, PngWriter{2, PNG_COLOR_TYPE_GRAY}.written({{0b00'10'11'00}}, 3)), expected);
  EXPECT_EQ(cells(keys, PngWriter{4, PNG_COLOR_TYPE_GRAY}.written({{0x0A, 0xF0}}, 3)), expected);
  EXPECT_EQ(
      cells(keys, PngWriter{16, PNG_COLOR_TYPE_GRAY}.written({{0, 0, 205, 0, 0xFF, 0xFE}}, 3)),
      expected);
  EXPECT_EQ(cells(keys, PngWriter{1, PNG_COLOR_TYPE_GRAY}.written({{0b0110'0000}}, 3)),
            (Cells{occupied, free_cell, free_cell}));
}

TEST_F(MapFile, PalettesAreReadWithTheirTransparency) {
  PngWriter writer{2, PNG_COLOR_TYPE_PALETTE};
  writer.palette = {{0, 0, 0}, {205, 205, 205}, {254, 254, 254}, {255, 255, 255}};
  const std::vector<std::vector<png_byte>> row{{0b00'01'10'11}};
  EXPECT_EQ(cells(keys, writer.written(row, 4)), (Cells{occupied, unknown, free_cell, free_cell}));
  writer.opacities = {255, 255, 255, 0};
  EXPECT_EQ(cells(keys, writer.written(row, 4)), (Cells{occupied, unknown, free_cell, unknown}));
}

TEST_F(MapFile, InterlacedImagesAreRead) {
  PngWriter writer{8, PNG_COLOR_TYPE_GRAY};
  std::vector<std::vector<png_byte>> rows(9, std::vector<png_byte>(9, 255));
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i][i] = 0;
  const Cells plain = cells(keys, writer.written(rows, 9));
  writer.interlace = PNG_INTERLACE_ADAM7;
  EXPECT_EQ(cells(keys, writer.written(rows, 9)), plain);
  EXPECT_EQ(plain[8], occupied);  // the last column of the last row of the image, at the least y
}

// What programs write beside the keys of map_server is passed over, and so is the case of words.
TEST_F(MapFile, MapsOfOtherProgramsAreRead) {
  const std::string image = "P2 2 1 255 0 255";
  const Cells expected{occupied, free_cell};
  EXPECT_EQ(cells(keys + "mode: Trinary\n", image), expected);
  EXPECT_EQ(cells(exchanged(keys, "negate: 0", "negate: False"), image), expected);
  EXPECT_EQ(cells(exchanged(keys, "negate: 0", "negate: yes"), image),
            (Cells{free_cell, occupied}));
  EXPECT_EQ(cells(keys + "cost_translation_table: {}\nmap_type: occupancy\n", image), expected);
  EXPECT_EQ(cells("---\n" + exchanged(keys, "[1.5, -2, 0.25]", "\n- 1.50e0\n- -2.\n- .25"), image),
            expected);
  folder_.put("far.pgm", image);
  EXPECT_EQ(cells(exchanged(keys, "m.pgm", '"' + folder_.file("far.pgm") + '"'), "gone"), expected);
}

TEST_F(MapFile, BadMapsHaveOneLineEach) {
  const std::string good = "P2 1 1 255 0";
  const auto spoilt = [&](const std::string& part, const std::string& by) {
    return message(exchanged(keys, part, by), good);
  };
  EXPECT_EQ(spoilt("image: m.pgm", "image: gone.pgm"),
            "m.yaml:1: image: gone.pgm: cannot open: No such file or directory");
  EXPECT_EQ(spoilt("resolution: 0.05", "resolution: 0"),
            "m.yaml:2: resolution: is 0, expected 1e-06 m to 1e+06 m");
  EXPECT_EQ(spoilt("resolution: 0.05", "resolution: -0.05"),
            "m.yaml:2: resolution: is -0.05, expected 1e-06 m to 1e+06 m");
  EXPECT_EQ(spoilt("resolution: 0.05", "resolution: 1e7"),
            "m.yaml:2: resolution: is 1e+07, expected 1e-06 m to 1e+06 m");
  EXPECT_EQ(spoilt("[1.5,", "[1e13,"),
            "m.yaml:3: origin: is 1e+13, expected a number between -1e+12 and 1e+12");
  EXPECT_EQ(spoilt("0.25]", "1e7]"),
            "m.yaml:3: origin: is 1e+07, expected a number between -1e+06 and 1e+06");
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
  EXPECT_EQ(spoilt("image: m.pgm", "image: \"\""),
            "m.yaml:1: image: is empty, expected the name of a PGM or PNG image");
  EXPECT_EQ(spoilt("image: m.pgm", "image: ."), "m.yaml:1: image: .: cannot read: Is a directory");
  EXPECT_EQ(message("name: a scenario\n", good),
            "m.yaml:1: key \"image\" is missing, expected a map of ROS' map_server");
  EXPECT_EQ(spoilt("negate: 0\n", ""), "m.yaml:1: key \"negate\" is missing, expected it");
}

TEST_F(MapFile, BadImagesHaveOneLineEach) {
  const auto image = [&](const std::string& bytes) {
    const std::string text = message(keys, bytes);
    const std::string begin = "m.yaml:1: image: m.pgm: ";
    EXPECT_EQ(text.substr(0, begin.size()), begin);
    return text.substr(std::min(begin.size(), text.size()));
  };
  const std::string readable = ", expected a PGM (P2 or P5) or PNG image";
  const std::string limit = ", expected at least one and at most 400000000, 100000000 along a side";
  EXPECT_EQ(image("GIF89a"), "is a GIF image" + readable);
  EXPECT_EQ(image("\xFF\xD8\xFF\xE0 JFIF"), "is a JPEG image" + readable);
  EXPECT_EQ(image("BM6"), "is a BMP image" + readable);
  EXPECT_EQ(image("P6 1 1 255\nabc"), "is a PPM image" + readable);
  EXPECT_EQ(image("resolution: 1"), "is no image that can be read" + readable);
  EXPECT_EQ(image(""), "is empty" + readable);
  EXPECT_EQ(image("P5"), "ends before its width, expected a whole PGM image");
  EXPECT_EQ(image("P5 x"), "has no width at byte 3, expected a decimal number");
  EXPECT_EQ(image("P5 100000 200000 255\n"), "is 100000 x 200000 pixels" + limit);
  EXPECT_EQ(image("P5 0 4 255\n"), "is 0 x 4 pixels" + limit);
  EXPECT_EQ(image("P5 1 100000001 255\n"), "is 1 x 100000001 pixels" + limit);
  EXPECT_EQ(image("P5 99999999999999999999 4 255\n"),
            "has a width of 99999999999999999999, expected at most 9223372036854775807");
  EXPECT_EQ(image("P5 5000 5000 255\nabc"),
            "holds 20 bytes for 5000 x 5000 pixels, expected a whole PGM image");
  EXPECT_EQ(image("P5 4 4 255\nabcdefgh"),
            "ends after 8 of 16 bytes of pixels, expected a whole PGM image");
  EXPECT_EQ(image("P5 1 1 70000\n1"), "has a greatest value of 70000, expected at most 65535");
  EXPECT_EQ(image("P5 1 1 0\n1"), "has a greatest value of 0, expected 1 to 65535");
  EXPECT_EQ(image("P2 2 1 9 9 10"), "has a pixel of 10, expected at most 9");
  EXPECT_EQ(image("P2 2 1 9 9 1" + std::string(2000, '0')),
            "has a pixel of 1" + std::string(1023, '0') + ", expected at most 9");
  EXPECT_EQ(image("P2 2 1 9 9      "), "ends before its pixel, expected a whole PGM image");
  const std::string whole = png(PNG_FORMAT_GRAY, 2, 1, {0, 255});
  for (std::size_t size = 4; size + 1 < whole.size(); ++size) {
    EXPECT_EQ(image(whole.substr(0, size)).substr(0, 22), "is a broken PNG image ");
  }
}

/// A PNG file of one chunk of deflated zeros, with any size in its head.
std::string boasting_png(std::uint32_t columns, std::uint32_t rows, unsigned char depth,
                         unsigned char colours, bool is_interlaced = false) {
  const auto word = [](std::uint32_t value) {
    std::string bytes;
    for (int i = 24; i >= 0; i -= 8) bytes += static_cast<char>(value >> i & 0xFFU);
    return bytes;
  };
  const auto chunk = [&](const std::string& name, const std::string& content) {
    const std::string body = name + content;
    const auto sum = ::crc32(0, reinterpret_cast<const unsigned char*>(body.data()),
                             static_cast<unsigned>(body.size()));
    return word(static_cast<std::uint32_t>(content.size())) + body +
           word(static_cast<std::uint32_t>(sum));
  };
  const std::string head = word(columns) + word(rows) + static_cast<char>(depth) +
                           static_cast<char>(colours) + std::string(2, '\0') +
                           static_cast<char>(is_interlaced ? 1 : 0);
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", head) +
         chunk("IDAT", std::string("\x78\x9c\x63\0\0\0\x01\0\x01", 9)) + chunk("IEND", "");
}

// 66 bytes asked for 0.8 and 1.6 GB.
TEST_F(MapFile, AHeaderAloneAsksForNoMemory) {
  const std::string square = boasting_png(10000, 10000, 16, 6);
  EXPECT_EQ(square.size(), 66U);
  EXPECT_EQ(message(keys, square),
            "m.yaml:1: image: m.pgm: holds 66 bytes for 10000 x 10000 pixels, expected a whole PNG "
            "image");
  EXPECT_EQ(message(keys, boasting_png(100000000, 1, 16, 6)),
            "m.yaml:1: image: m.pgm: holds 66 bytes for 100000000 x 1 pixels, expected a whole PNG "
            "image");
  // What 66 bytes may hold is looked at: 8 * 1032 * 66 pixels of one bit.
  EXPECT_EQ(message(keys, boasting_png(544000, 1, 1, 0)).substr(0, 45),
            "m.yaml:1: image: m.pgm: is a broken PNG image");
  EXPECT_EQ(message(keys, boasting_png(545000, 1, 1, 0)).substr(0, 38),
            "m.yaml:1: image: m.pgm: holds 66 bytes");
}

// It has to be held as a whole.
TEST_F(MapFile, ALargeInterlacedImageIsRefused) {
  const std::string room(50'000, '\0');
  EXPECT_EQ(message(keys, boasting_png(20000, 20000, 1, 0, true) + room),
            "m.yaml:1: image: m.pgm: is 20000 x 20000 pixels and interlaced, expected at most "
            "100000000, or one row after the other");
  EXPECT_EQ(message(keys, boasting_png(10000, 10000, 1, 0, true) + room).substr(0, 45),
            "m.yaml:1: image: m.pgm: is a broken PNG image");
}

/// A PGM file of 16 bits, larger than what is read at a time, and what its cells are.
std::pair<std::string, Cells> any_large_pgm() {
  constexpr std::size_t columns = 301;
  constexpr std::size_t rows = 700;
  std::string image = "P5 301 700 65535\n";
  Cells expected(columns * rows);
  Rng rng(1);
  for (std::size_t y = rows; y-- > 0;) {
    for (std::size_t x = 0; x < columns; ++x) {
      const bool is_free = uniform01(rng) < 0.5;
      image += is_free ? "\xFE\x01" : std::string("\x01\0", 2);
      expected[y * columns + x] = is_free ? free_cell : occupied;
    }
  }
  return {image, expected};
}

TEST_F(MapFile, WhatIsReadPieceByPieceIsWhole) {
  const auto [image, expected] = any_large_pgm();
  EXPECT_EQ(cells(keys, image), expected);
}

TEST_F(MapFile, AnImageMayComeThroughAPipe) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  const std::string image = "P5 100 100 255\n" + std::string(9999, '\xFE') + std::string(1, '\0');
  ASSERT_EQ(::write(ends[1], image.data(), image.size()), static_cast<ssize_t>(image.size()));
  ::close(ends[1]);
  Cells expected(10'000, free_cell);
  expected[99] = occupied;
  EXPECT_EQ(cells(exchanged(keys, "m.pgm", "/dev/fd/" + std::to_string(ends[0])), ""), expected);
  ::close(ends[0]);
}

// Deflate packs a blank map best: 1000 to 1.
TEST_F(MapFile, ABlankMapIsRead) {
  const std::vector<std::vector<png_byte>> rows(2000, std::vector<png_byte>(2000, 255));
  const std::string image = PngWriter{8, PNG_COLOR_TYPE_GRAY}.written(rows, 2000);
  EXPECT_LT(image.size(), 10000U);
  EXPECT_EQ(cells(keys, image), Cells(2000 * 2000, free_cell));
}

TEST_F(MapFile, IsToldFromAScenario) {
  EXPECT_TRUE(is_map(folder_.put("m.yaml", keys)));
  EXPECT_FALSE(is_map(folder_.put("s.yaml", yard())));
  EXPECT_FALSE(is_map(folder_.put("list.yaml", "[image]")));
  try {
    (void)read_scenario(folder_ / "m.yaml");
    ADD_FAILURE() << "a map was read as a scenario";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), folder_ / "m.yaml" +
                                ":1: image: belongs into a map, expected a scenario that names "
                                "this file as its map");
  }
}

TEST_F(MapFile, AMapWithoutAFreeCellIsSaid) {
  const auto warnings = [&](const std::string& yaml, const std::string& image) {
    folder_.put("m.pgm", image);
    folder_.put("m.yaml", yaml);
    return read_scenario_file(folder_.put("s.yaml",
                                          "name: s\nvehicle: van\nmap: m.yaml\n"
                                          "start: {x: 0, y: 0, heading: 0}\n"
                                          "goal: {x: 0, y: 0, heading: 0}\n"))
        .warnings;
  };
  const std::string all_thresholds = exchanged(keys, "free_thresh: 0.196", "free_thresh: 0");
  const std::vector<std::string> found = warnings(all_thresholds, "P2 2 1 255 254 255");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found[0].ends_with(
      "s.yaml:3: map: has no free cell; look at mode, negate, free_thresh and occupied_thresh of "
      "the map"))
      << found[0];
  EXPECT_EQ(warnings(keys, "P2 2 1 255 254 255").size(), 0U);
}

TEST_F(MapFile, AThresholdThatFreesUnknownGroundIsSaid) {
  const auto warnings = [&](const std::string& yaml, const std::string& image) {
    folder_.put("m.pgm", image);
    folder_.put("m.yaml", yaml);
    return read_scenario_file(folder_.put("s.yaml",
                                          "name: s\nvehicle: van\nmap: m.yaml\n"
                                          "start: {x: 0, y: 0, heading: 0}\n"
                                          "goal: {x: 0, y: 0, heading: 0}\n"))
        .warnings;
  };
  const std::string loose = exchanged(keys, "free_thresh: 0.196", "free_thresh: 0.25");
  const std::vector<std::string> found = warnings(loose, "P2 2 1 255 254 205");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found[0].ends_with(
      "m.yaml:6: free_thresh: frees pixels of 205, which map_saver writes for unknown ground; "
      "0.196 keeps them unknown"))
      << found[0];
  EXPECT_EQ(warnings(loose, "P2 2 1 255 254 255").size(), 0U);
  EXPECT_EQ(warnings(keys, "P2 2 1 255 254 205").size(), 0U);
}

TEST_F(MapFile, AMapWithoutItsCellsIsNotWritten) {
  EXPECT_THROW((void)map_to_pgm({.columns = 3, .rows = 3}), InputError);
}

}  // namespace
}  // namespace vandplan
