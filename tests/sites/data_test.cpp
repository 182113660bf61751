// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Files of site tables.
#include "vandplan/site_table.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "support/problems.h"
#include "vandplan/input_error.h"
#include "vandplan/planner.h"

namespace vandplan {
namespace {

const SiteTable& small_table() {
  static const SiteTable table =
      make_site_table(problem_of({20, 0, 0}, {0, 0, 0}, {}, {-25, 25, -25, 25}),
                      std::vector<Pose>{{0, 0, 0}}, complete(default_planner()),
                      {.headings = 8, .cell = 0.5})
          .value();
  return table;
}

std::string damaged(const std::function<void(std::string&)>& damage) {
  auto bytes = std::make_shared<std::string>(site_table_to_bytes(small_table()));
  damage(*bytes);
  try {
    (void)site_table_from_bytes(*bytes, bytes, "s.vst");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no refusal";
}

TEST(SiteTableFile, ReadsBackWhatWasWritten) {
  const auto bytes = std::make_shared<const std::string>(site_table_to_bytes(small_table()));
  const SiteTable table = site_table_from_bytes(*bytes, bytes, "s.vst");
  EXPECT_EQ(table.goals(), small_table().goals());
  EXPECT_EQ(table.rounding(0), small_table().rounding(0));
  EXPECT_EQ(table.cost({9, 4, 1}, 0), small_table().cost({9, 4, 1}, 0));
  EXPECT_EQ(site_table_to_bytes(table), *bytes);
}

TEST(SiteTableFile, RefusesWhatItIsNot) {
  EXPECT_EQ(damaged([](std::string& bytes) { bytes = "%PDF-1.4 and so on"; }),
            "s.vst: not a table of a site: does not start with 'vp-site '");
  EXPECT_EQ(damaged([](std::string& bytes) { bytes.resize(50); }),
            "s.vst: truncated: 50 bytes, the head alone has 96");
  EXPECT_EQ(damaged([](std::string& bytes) { bytes[8] = 9; }),
            "s.vst: version 9 of the format, this program reads version 2");
  EXPECT_TRUE(damaged([](std::string& bytes) { bytes.resize(100); }).starts_with("s.vst: trunc"));
  EXPECT_TRUE(damaged([](std::string& bytes) { bytes.pop_back(); }).starts_with("s.vst: trunc"));
  EXPECT_TRUE(damaged([](std::string& bytes) { bytes += "x"; }).starts_with("s.vst: longer"));
}

TEST(SiteTableFile, NoticesEveryAlteredByte) {
  const std::size_t size = site_table_to_bytes(small_table()).size();
  for (std::size_t i = 0; i < size; i += i < 200 ? 1 : 97) {
    const std::string told = damaged([i](std::string& bytes) { bytes[i] ^= 0x10; });
    EXPECT_TRUE(told.starts_with("s.vst: ")) << i << ": " << told;
  }
}

}  // namespace
}  // namespace vandplan
