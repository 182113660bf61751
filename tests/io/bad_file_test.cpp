// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Whatever a file holds, it is read or refused in one line.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "support/cases.h"
#include "support/shared_files.h"
#include "support/temporary_folder.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "vandplan/random.h"
#include "vandplan/result_file.h"

namespace vandplan {
namespace {

std::size_t below(std::size_t count, Rng& rng) { return rng() % count; }

/// One of many ways to hurt a text.
std::string hurt(std::string text, Rng& rng) {
  static const std::string scraps[] = {"[",
                                       "]",
                                       "{",
                                       "}",
                                       "&a ",
                                       "*a",
                                       "!!str ",
                                       "!x ",
                                       "\n---\n",
                                       "\n...\n",
                                       "\t",
                                       "\r",
                                       "%YAML 1.2\n",
                                       "|\n",
                                       ">\n",
                                       "? ",
                                       "- ",
                                       ": ",
                                       "#",
                                       "'",
                                       "\"",
                                       "\\",
                                       "1e999",
                                       "nan",
                                       "-.inf",
                                       "null",
                                       "~",
                                       "\x04",
                                       "\x7f",
                                       "\xC3",
                                       "\xEF\xBB\xBF",
                                       ",",
                                       "<<: ",
                                       "-",
                                       "0x1",
                                       "1_000",
                                       "goals:",
                                       "\n",
                                       "  ",
                                       std::string(1, '\0'),
                                       "1e13",
                                       "e",
                                       "true",
                                       "@",
                                       "`"};
  const std::size_t at = below(text.size() + 1, rng);
  const std::size_t size = below(20, rng);
  switch (below(5, rng)) {
    case 0:
      return text.insert(at, scraps[below(std::size(scraps), rng)]);
    case 1:
      return text.erase(at, size);
    case 2:
      return text.insert(at, text.substr(below(text.size() + 1, rng), 5 * size));
    case 3:
      return at < text.size() ? text.replace(at, 1, 1, static_cast<char>(rng() % 256)) : text;
    default:
      return text.substr(0, at);
  }
}

std::string hurt_often(std::string text, Rng& rng) {
  for (std::size_t i = 1 + below(4, rng); i > 0; --i) text = hurt(std::move(text), rng);
  return text;
}

/// Whether `read` returns or throws an InputError of one line that begins with the file's name.
template <typename Read>
void expect_read_or_refused(const Read& read, const std::string& file, const std::string& text) {
  try {
    read();
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_TRUE(message.starts_with(file + ":")) << message << '\n' << text;
    EXPECT_TRUE(
        std::none_of(message.begin(), message.end(), [](unsigned char c) { return c < ' '; }))
        << message << '\n'
        << text;
  } catch (const std::exception& error) {
    ADD_FAILURE() << error.what() << '\n' << text;
  }
}

std::string our_scenario(const std::string& name) {
  return read_file((repository() / "scenarios" / "thesis" / name).string(), 1 << 20);
}

TEST(BadFile, ScenariosAreReadOrRefused) {
  const std::string texts[] = {our_scenario("5-leave-cage.yaml"),
                               our_scenario("9-furthest-walled.yaml").substr(0, 1500),
                               our_scenario("2-flat-obstacle.yaml")};
  for_each_case(1, 6000, [&](Rng& rng) {
    const std::string text = hurt_often(texts[below(std::size(texts), rng)], rng);
    expect_read_or_refused(
        [&] {
          // What is read can be planned on and written.
          const ScenarioFile scenario = scenario_from_yaml(text, "s.yaml");
          (void)make_problems(scenario);
          (void)scenario_from_yaml(to_yaml(scenario), "again.yaml");
        },
        "s.yaml", text);
  });
}

TEST(BadFile, ResultsAreReadOrRefused) {
  const ScenarioFile scenario = scenario_from_yaml(our_scenario("5-leave-cage.yaml"), "s.yaml");
  ResultRecord record{.scenario = "s",
                      .planner = "p",
                      .options = {},
                      .distance = {},
                      .result = {},
                      .claims = {},
                      .furthest = {}};
  record.result.status = PlanStatus::solved;
  record.result.path = Path{scenario.scenario.start, {{0, 1}, {1.0 / 7, -0.2}}};
  record.result.tree = TreeSnapshot{{{0, 0, 0}, {1, 0, 0.5}}, {-1, 0}};
  const std::string valid = results_to_json(scenario, {record});
  const TemporaryFolder folder;
  for_each_case(2, 6000, [&](Rng& rng) {
    const std::string text = hurt_often(valid, rng);
    const std::string file = folder.put("r.json", text);
    expect_read_or_refused([&] { (void)read_results(file, scenario); }, file, text);
  });
}

TEST(BadFile, ResultsOfManyPairsAreReadOrRefused) {
  const ScenarioFile scenario = scenario_from_yaml(our_scenario("5-leave-cage.yaml"), "s.yaml");
  const Problem problem = make_problem(scenario.scenario);
  ResultRecord record;
  record.result.status = PlanStatus::solved;
  record.result.path = Path{scenario.scenario.start, {{0, 1}, {1.0 / 7, -0.2}}};
  const std::string valid =
      result_to_json_line(1, problem, record) + result_to_json_line(2, problem, record);
  const TemporaryFolder folder;
  for_each_case(4, 3000, [&](Rng& rng) {
    const std::string text = hurt_often(valid, rng);
    const std::string file = folder.put("r.jsonl", text);
    const auto read = [&] {
      ResultReader reader(file, scenario);
      if (!reader.has_pairs()) return (void)reader.all();
      while (reader.next()) {
      }
    };
    expect_read_or_refused(read, file, text);
  });
}

TEST(BadFile, CasesOfTheCompetitionAreReadOrRefused) {
  const std::string valid = "1,2,3,4,5,6,2,3,4,0,0,1,0,1,1,5,5,6,5,6,6,5,6\n";
  const TemporaryFolder folder;
  for_each_case(3, 6000, [&](Rng& rng) {
    const std::string text = hurt_often(valid, rng);
    const std::string file = folder.put("c.csv", text);
    expect_read_or_refused([&] { (void)read_tpcap(file); }, file, text);
  });
}

}  // namespace
}  // namespace vandplan
