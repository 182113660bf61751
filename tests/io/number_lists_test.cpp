// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Is a YAML text the same whether its lists of numbers are read by us or by the parser of YAML?
#include "io/number_lists.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "vandplan/input_error.h"

namespace vandplan::io {
namespace {

/// What is read, or what is wrong with it.
struct Outcome {
  Node root;
  std::string error;

  bool operator==(const Outcome&) const = default;
};

Outcome outcome_of(Document (*parse)(const std::string&, const std::string&),
                   const std::string& text) {
  try {
    return {parse(text, "file").root(), ""};
  } catch (const InputError& error) {
    return {{}, error.what()};
  }
}

void expect_same(const std::string& text) {
  const Outcome quick = outcome_of(parse_yaml, text);
  const Outcome slow = outcome_of(parse_yaml_slowly, text);
  EXPECT_TRUE(quick == slow) << text << "\n" << quick.error << "\n" << slow.error;
}

TEST(NumberLists, AreTakenOutOfTheText) {
  const ShortenedText shortened = without_number_lists(
      "name: a\nkerbs:\n  - [[0, 1], [-2.5e3, .5]]\r\n  - []\nbounds: [1,2]\nend: [1, b]");
  EXPECT_EQ(shortened.text,
            "name: a\nkerbs:\n  - \"\1"
            "0\"\n\nbounds: \"\1"
            "1\"\nend: [1, b]");
  ASSERT_EQ(shortened.lists.size(), 2U);
  EXPECT_EQ(shortened.lists[0].lines, "  - [[0, 1], [-2.5e3, .5]]\r\n  - []\n");
  EXPECT_EQ(shortened.lists[0].line, 3);
  EXPECT_EQ(shortened.lists[1].line, 5);
}

TEST(NumberLists, StayWhereALineHoldsAnythingElse) {
  for (const std::string line : {"- [1,]", "- [1 2]", "- [.nan]", "- [a]", "- [1] # why", "- [[1]",
                                 "- [1]]", "-[1]", "a b: [1]", "- - [1]", "a:[1]", "- [-]",
                                 "\t- [1]", "- {x: [1]}", "[1]", "- &a [1]", "- [\"1\"]"}) {
    EXPECT_EQ(without_number_lists(line).text, line);
    expect_same(line);
  }
}

TEST(NumberLists, MeanTheSameWhereALineIsPartOfSomethingElse) {
  for (const std::string text : {"a: |\n  - [1]\n  - [2]\n",
                                 "a: >\n  b: [1]\n",
                                 "a: \"x\n  - [1]\n  y\"\n",
                                 "a: 'x\n  b: [1]'\n",
                                 "a: foo\n  - [1]\n",
                                 "- [1]\n    foo\n",
                                 "- [1]\n  : x\n",
                                 "a: [\n  - [1]\n]\n",
                                 "a: {\n  b: [1]\n}\n",
                                 "a: {\n  b: [1],\n  c: [2]\n}\n",
                                 "a: {\n  b: [1]\n  c: [2]\n}\n",
                                 "a: [\n  b: [1]\n]\n",
                                 "? - [1]\n: 2\n",
                                 "?\n  - [1]\n: 2\n",
                                 "- [1]\n - [2]\n",
                                 "a:\n- [1]\n- [2]\nb: [3]\n",
                                 "a: [1]\na: [2]\n",
                                 "- [1]\n---\n- [2]\n",
                                 "a: \"\\x010\"\n",
                                 "a: \"\\x010\"\nb: [1]\n",
                                 "- d: [1]\n  ...\n- [1]\n",
                                 "a: *b\nc: [1]\n",
                                 "a: !t\n  c: [1]\n",
                                 "a: |+\n  - [1]\n\n\nb: 1",
                                 "a: |\n  - [1]",
                                 "- [[[[[[[[[[1]]]]]]]]]]\n"}) {
    expect_same(text);
  }
}

TEST(NumberLists, MeanTheSameInRandomTexts) {
  constexpr std::array pieces = {"- [1, 2]",   "- [[0, 1], [2, 3]]",
                                 "- [[0, 1],", "a: [1, 2]",
                                 "b: [[1]]",   "c:",
                                 "- - [1]",    "- d: [1]",
                                 "# - [1]",    "]",
                                 "}",          "e: {",
                                 "f: [",       "g: |",
                                 "h: \"x",     "\"",
                                 "i: x",       "y",
                                 "",           "- x",
                                 "-",          "? - [1]",
                                 ": [2]",      "- []",
                                 "j: []",      "- [1] #",
                                 "k: [1e9]",   "- [ 1 , 2 ]",
                                 "l: 'it''s",  "'",
                                 "...",        "---",
                                 "- [1]\r"};
  std::mt19937_64 rng(11);
  const auto below = [&](std::size_t count) { return static_cast<std::size_t>(rng() % count); };
  for (int i = 0; i < 20000; ++i) {
    std::string text;
    const std::size_t lines = 1 + below(8);
    for (std::size_t k = 0; k < lines; ++k) {
      text += std::string(2 * below(3), ' ') + pieces[below(pieces.size())];
      if (k + 1 < lines || below(2) == 0) text += '\n';
    }
    expect_same(text);
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace vandplan::io
