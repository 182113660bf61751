// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/table_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>

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

TEST(TableFile, HeaderNeedsAnIdentifierForAName) {
  EXPECT_THROW((void)tables::table_to_header(small_table(), ""), InputError);
  EXPECT_THROW((void)tables::table_to_header(small_table(), "4hlut"), InputError);
  EXPECT_THROW((void)tables::table_to_header(small_table(), "hlut-4"), InputError);
}

}  // namespace
}  // namespace vandplan
