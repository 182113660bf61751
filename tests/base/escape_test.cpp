// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "base/escape.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <string>

namespace vandplan {
namespace {

TEST(Escape, OrdinaryNamesStayWhatTheyAre) {
  for (const std::string name :
       {"", "thesis-5-leave-cage", "Vändplan", "a b", "50 %", "\U0001F69A"}) {
    EXPECT_EQ(base::printable(name), name);
    EXPECT_EQ(base::markdown(name), name);
    EXPECT_EQ(base::csv_cell(name), name);
  }
}

TEST(Escape, ATerminalGetsNoControlCharacter) {
  EXPECT_EQ(base::printable("\x1b[31mred\x7f\n"), "\\x1b[31mred\\x7f\\x0a");
  EXPECT_EQ(base::printable("a\xC2\x9Bz"), "a\\x9bz");        // U+009B begins a command, too
  EXPECT_EQ(base::printable("a\x9Bz"), "a\\x9bz");            // and so does the bare byte
  EXPECT_EQ(base::printable("a\xE2\x80\xAEz"), "a\\u202ez");  // right to left
  EXPECT_EQ(base::printable("a\xE2\x80\xA8z"), "a\\u2028z");  // a line ends
  EXPECT_EQ(base::printable("\xC3("), "\\xc3(");              // cut off
  EXPECT_EQ(base::printable(std::string("a\0b", 3)), "a\\x00b");
}

TEST(Escape, JsonStaysJson) {
  EXPECT_EQ(base::json_text("{\n\"a\": \"\x7f\xC2\x9B\xE2\x80\xAE\xC3\xA4\"\n}"),
            "{\n\"a\": \"\\u007f\\u009b\\u202e\xC3\xA4\"\n}");
}

TEST(Escape, MarkdownGetsNoCellLinkCodeOrHtml) {
  EXPECT_EQ(base::markdown("a|b"), "a\\|b");
  EXPECT_EQ(base::markdown("a\n| b"), "a\\x0a\\| b");
  EXPECT_EQ(base::markdown("![x](http://y)"), "!\\[x\\](http://y)");
  EXPECT_EQ(base::markdown("<b>`c`"), "\\<b>\\`c\\`");
  EXPECT_EQ(base::markdown("a\\|b"), "a\\\\\\|b");
}

TEST(Escape, ASpreadsheetGetsNoFormula) {
  for (const std::string text : {"=1+1", "+1", "-1", "@SUM(A1)"}) {
    EXPECT_EQ(base::csv_cell(text), "'" + text);
  }
  EXPECT_EQ(base::csv_cell("=a,b"), "\"'=a,b\"");
  EXPECT_EQ(base::csv_cell("\t=1"), "'\t=1");
  EXPECT_EQ(base::csv_cell("a=1"), "a=1");
}

TEST(Escape, CellsOfCsvAreQuotedWhereNeeded) {
  EXPECT_EQ(base::csv_cell("a, \"b\""), "\"a, \"\"b\"\"\"");
  EXPECT_EQ(base::csv_cell("a\nb"), "\"a\nb\"");
  EXPECT_EQ(base::csv_cell("a\rb"), "\"a\rb\"");
}

TEST(Escape, ShellWordsAreQuotedWhereNeeded) {
  EXPECT_EQ(base::shell_word("scenarios/thesis/5-leave-cage.yaml"),
            "scenarios/thesis/5-leave-cage.yaml");
  EXPECT_EQ(base::shell_word(""), "''");
  EXPECT_EQ(base::shell_word("my yard.yaml"), "'my yard.yaml'");
  EXPECT_EQ(base::shell_word("it's; rm -rf ~"), "'it'\\''s; rm -rf ~'");
  EXPECT_EQ(base::shell_word("a\nb'c\\"), "$'a\\x0ab\\'c\\\\'");
  EXPECT_EQ(base::shell_file("-o.yaml"), "./-o.yaml");
  EXPECT_EQ(base::shell_file("-"), "-");
}

TEST(Escape, AShellReadsTheWordBack) {
  for (const std::string word : {"plain", "two words", "it's", "$(id)`id`", "a\"b\\c",
                                 "a\nb\x1b'\\", "\x9B\xC3\xA4", "*?[a]~!#&|;<>(){}"}) {
    const std::string command = "bash -c \"$VANDPLAN_SCRIPT\"";
    ASSERT_EQ(setenv("VANDPLAN_SCRIPT", ("printf %s " + base::shell_word(word)).c_str(), 1), 0);
    FILE* const pipe = popen(command.c_str(), "r");
    ASSERT_NE(pipe, nullptr);
    std::array<char, 200> buffer{};
    const std::size_t size = std::fread(buffer.data(), 1, buffer.size(), pipe);
    pclose(pipe);
    EXPECT_EQ(std::string(buffer.data(), size), word);
  }
}

}  // namespace
}  // namespace vandplan
