// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "support/numbers.h"
#include "vandplan/tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "tables/table_bytes.h"
#include "tables/table_export.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

const HeuristicTable& small_table() {
  static const HeuristicTable table(
      {.extent = 2.0, .step = 0.5, .heading_cells = 4, .turning_radius = 5.5});
  return table;
}

// What reading says after `damage`.
std::string refusal(const std::function<void(std::string&)>& damage) {
  std::string bytes = table_to_bytes(small_table());
  damage(bytes);
  try {
    (void)table_from_bytes(bytes, "t.table");
  } catch (const InputError& error) {
    return error.what();
  }
  return "read without complaint";
}

TEST(TableFile, ReadsBackWhatWasWritten) {
  const HeuristicTable table = table_from_bytes(table_to_bytes(small_table()), "t.table");
  EXPECT_EQ(table.options(), small_table().options());
  EXPECT_TRUE(std::ranges::equal(table.entries(), small_table().entries()));
}

TEST(TableFile, RefusesAForeignFile) {
  EXPECT_EQ(refusal([](std::string& bytes) { bytes = "%PDF-1.4 and so on"; }),
            "t.table: not a table file: does not start with 'vp-table'");
  EXPECT_EQ(refusal([](std::string& bytes) { bytes.clear(); }),
            "t.table: is empty, expected a table file");
}

TEST(TableFile, RefusesATruncatedFile) {
  EXPECT_EQ(refusal([](std::string& bytes) { bytes.resize(50); }),
            "t.table: truncated: 50 bytes, the header alone has 96");
  EXPECT_EQ(refusal([](std::string& bytes) { bytes.pop_back(); }),
            "t.table: truncated: 2595 bytes, expected 96 + 4 * 625");
}

TEST(TableFile, RefusesAFileThatGoesOn) {
  EXPECT_EQ(refusal([](std::string& bytes) { bytes += "more"; }),
            "t.table: longer than it says: 2600 bytes, expected 96 + 4 * 625");
}

TEST(TableFile, RefusesAnotherByteOrderVersionContentOrUnit) {
  EXPECT_EQ(refusal([](std::string& bytes) { std::reverse(&bytes[8], &bytes[12]); }),
            "t.table: big-endian, only little-endian files are read");
  EXPECT_EQ(refusal([](std::string& bytes) { bytes[12] = 2; }),
            "t.table: version 2 of the format, this program reads version 1");
  EXPECT_EQ(refusal([](std::string& bytes) { bytes.replace(16, 16, "dubins-4d       "); }),
            "t.table: holds 'dubins-4d       ', expected 'reeds-shepp-4d  ' or "
            "'reeds-shepp-bnds'");
  EXPECT_EQ(refusal([](std::string& bytes) { bytes.replace(32, 5, "foot "); }),
            "t.table: units are 'foot  radian    ', expected 'metre radian    '");
}

TEST(TableFile, NoticesEveryAlteredByte) {
  const std::string bytes = table_to_bytes(small_table());
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string altered = bytes;
    altered[i] = static_cast<char>(altered[i] ^ 0x10);
    EXPECT_THROW((void)table_from_bytes(altered, "t.table"), InputError) << "byte " << i;
  }
}

// ---- files whose checksum fits, and whose numbers do not ----

// What reading a table of lengths says with a number of the head exchanged; of the head alone, too.
std::string refusal_with(std::size_t parameter, std::uint64_t value) {
  std::string head_alone;
  const std::string whole = refusal([&](std::string& bytes) {
    std::string word;
    tables::table_bytes::append(word, value);
    bytes.replace(48 + 8 * parameter, 8, word);
    tables::table_bytes::seal(bytes);
    try {
      (void)table_file_head(bytes, "t.table");
    } catch (const InputError& error) {
      head_alone = error.what();
    }
  });
  EXPECT_EQ(whole, head_alone);
  return whole;
}

std::string refusal_with(std::size_t parameter, double value) {
  return refusal_with(parameter, std::bit_cast<std::uint64_t>(value));
}

TEST(TableFile, LengthsOfTheHeadHaveRanges) {
  const char* const names[] = {"turning_radius", "extent", "step"};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string start = std::string("t.table: ") + names[i] + ": is ";
    const std::string range = ", expected 0.000001 to 1000000 m";
    EXPECT_EQ(refusal_with(i, 1e200), start + "1e+200" + range);
    EXPECT_EQ(refusal_with(i, infinity), start + "inf" + range);
    EXPECT_EQ(refusal_with(i, 1e-300), start + "1e-300" + range);
    EXPECT_EQ(refusal_with(i, nan), start + "nan, expected more than 0 m");
    EXPECT_EQ(refusal_with(i, -1.0), start + "-1, expected more than 0 m");
  }
}

TEST(TableFile, TheHeadHasToFitTheEntries) {
  EXPECT_EQ(refusal_with(3, std::uint64_t{5}),
            "t.table: entries: 625 are there, the options ask for 900");
  EXPECT_EQ(refusal_with(3, std::uint64_t{0}), "t.table: heading_cells: is 0, expected at least 1");
  EXPECT_EQ(refusal_with(3, ~std::uint64_t{0}).substr(0, 36),
            "t.table: step: the table would hold ");
}

TEST(TableFile, EntriesAreLengths) {
  for (const float entry : {-1.0F, std::nanf(""), std::numeric_limits<float>::infinity()}) {
    const std::string problem = refusal([&](std::string& bytes) {
      std::string word;
      tables::table_bytes::append(word, std::bit_cast<std::uint32_t>(entry));
      bytes.replace(96 + 4 * 7, 4, word);
      tables::table_bytes::seal(bytes);
    });
    EXPECT_EQ(problem.substr(0, 24), "t.table: entries[7]: is ");
  }
}

TEST(TableFile, NumbersOfATableOfBoundsHaveRanges) {
  const auto refusal_of_bounds = [](std::size_t at, const std::string& word) {
    std::string bytes = bound_table_to_bytes();
    bytes.replace(at, word.size(), word);
    tables::table_bytes::seal(bytes);
    try {
      (void)table_file_head(bytes, "b.table");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("read without complaint");
  };
  const auto with = [&](std::size_t parameter, double value) {
    std::string word;
    tables::table_bytes::append(word, std::bit_cast<std::uint64_t>(value));
    return refusal_of_bounds(48 + 8 * parameter, word);
  };
  EXPECT_EQ(with(0, 1e200), "b.table: turning_radius: is 1e+200, expected 1");
  EXPECT_EQ(with(1, nan), "b.table: reach: is nan, expected 0.000001 to 1000000");
  EXPECT_EQ(with(2, 1e200), "b.table: unit: is 1e+200, expected more than 0, at most 1");
  const std::string none(2, '\0');
  for (const std::size_t at : {72U, 74U, 76U}) {
    EXPECT_EQ(refusal_of_bounds(at, none),
              "b.table: entries: is 131072, expected one for each cell");
  }
  EXPECT_EQ(refusal_of_bounds(78, none), "b.table: slope_step: is 0, expected at least 1");
  EXPECT_EQ(refusal_of_bounds(78, ""), "read without complaint");
}

TEST(TableFile, HeaderNeedsAnIdentifierForAName) {
  EXPECT_THROW((void)tables::table_to_header(small_table(), ""), InputError);
  EXPECT_THROW((void)tables::table_to_header(small_table(), "4hlut"), InputError);
  EXPECT_THROW((void)tables::table_to_header(small_table(), "hlut-4"), InputError);
}

}  // namespace
}  // namespace vandplan
