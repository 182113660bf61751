// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// A table of a site is looked into where its file lies.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "support/problems.h"
#include "support/temporary_folder.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "vandplan/planner.h"
#include "vandplan/site_table.h"

namespace vandplan {
namespace {

SiteTable coarse_table() {
  return make_site_table(problem_of({20, 0, 0}, {0, 0, 0}, {}, {-25, 25, -25, 25}),
                         std::vector<Pose>{{0, 0, 0}}, complete(default_planner()),
                         {.headings = 8, .cell = 0.5})
      .value();
}

/// Whether some memory of this process is the file itself; true where nobody says so.
bool is_mapped(const std::string& file) {
  if (!std::filesystem::exists("/proc/self/maps")) return true;
  return read_file("/proc/self/maps", std::size_t{1} << 26).find(file) != std::string::npos;
}

TEST(SiteTableFile, IsLookedIntoAsLongAsTheTableLives) {
  const TemporaryFolder folder;
  const std::string file = folder / "yard.vst";
  const SiteTable made = coarse_table();
  write_file(file, site_table_to_bytes(made));
  {
    const SiteTable table = read_site_table(file);
    EXPECT_TRUE(is_mapped(file));
    EXPECT_EQ(table.cost({9, 4, 1}, 0), made.cost({9, 4, 1}, 0));
    // Whoever writes another file in its place changes nothing for those who use this one.
    write_file(file, "vp-site what comes next");
    EXPECT_EQ(site_table_to_bytes(table), site_table_to_bytes(made));
  }
  EXPECT_FALSE(std::filesystem::exists("/proc/self/maps") && is_mapped(file));
}

TEST(SiteTableFile, ErrorsNameIt) {
  const TemporaryFolder folder;
  const std::string file = folder / "yard.vst";
  for (const std::string& content : {std::string(), std::string("vp-site "), std::string("PDF")}) {
    write_file(file, content);
    try {
      (void)read_site_table(file);
      ADD_FAILURE() << content;
    } catch (const InputError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with(file + ": ")) << error.what();
    }
  }
  EXPECT_THROW((void)read_site_table(folder / "nothing.vst"), InputError);
  EXPECT_THROW((void)read_site_table(folder / "."), InputError);
}

}  // namespace
}  // namespace vandplan
