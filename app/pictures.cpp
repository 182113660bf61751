// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "pictures.h"

#include <fmt/format.h>

#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "vandplan/draw.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "wording.h"

namespace vandplan::app {
namespace {

constexpr int picture_width = 1200;  // pixels or points
constexpr const char* strip_flag = "--curvature-strip";
constexpr const char* play_flag = "--play";
constexpr std::size_t max_pictures = 48;  // pictures on a sheet of pairs

std::string captioned_outcome(const PlanResult& result) {
  if (!result.path) return std::string(name_of(result.status));
  const std::vector<Segment>& segments = result.path->segments;
  return fmt::format("{:.2f} m, gear changes {}", length(segments), gear_changes(segments));
}

std::string caption_of(const Scenario& scenario, const ResultRecord& record) {
  std::string caption = scenario.name;
  if (record.distance) caption += fmt::format(" {:.6g} m", *record.distance);
  if (!record.planner.empty()) {
    caption += fmt::format(", {}, seed {}", record.planner, record.options.budget.seed);
  }
  return printable(caption + ": " + captioned_outcome(record.result));
}

Drawing drawing_of(const Scenario& scenario, const ResultRecord* record) {
  Drawing drawing{.scenario = &scenario, .caption = printable(scenario.name)};
  if (record == nullptr) return drawing;
  const PlanResult& result = record->result;
  if (result.path) drawing.path = &*result.path;
  if (result.tree) drawing.tree = &*result.tree;
  drawing.margin = record->options.clearance.margin;
  drawing.hit = result.hit;
  drawing.caption = caption_of(scenario, *record);
  return drawing;
}

/// Speeds of a result; if it has none, those of the fastest drive along its path.
SpeedProfile speeds_of(const Scenario& scenario, const PlanResult& result) {
  if (result.speeds) return *result.speeds;
  return speed_profile(*result.path, scenario.vehicle, speed_options(scenario, *result.path));
}

/// A pair, and the scenario with the pair's start and goal.
struct PairPicture {
  Scenario scenario;
  PairRecord pair;
};

PairPicture picture_of(const ScenarioFile& file, PairRecord pair) {
  PairPicture picture{scenario_at(file, 0), std::move(pair)};
  picture.scenario.start = picture.pair.poses.start;
  picture.scenario.goal = picture.pair.poses.goal;
  return picture;
}

}  // namespace

void add_picture(CLI::App& command, PictureWish& wish) {
  const auto is_named = [](const std::string& file) {
    return file.empty() ? std::string("the name of a file is empty") : std::string();
  };
  command.add_option("--draw", wish.file, "Picture (.svg, .png or .pdf)")
      ->check(CLI::Validator(is_named, ""))
      ->type_name("FILE");
  command.add_flag(strip_flag, wish.curvature_strip, "Plot the curvature below the picture")
      ->needs("--draw");
}

void expect_picture(const std::string& file) {
  (void)picture_format(file);
  expect_writable(file);
}

void expect_one_path(const PictureWish& wish, const ScenarioFile& scenario) {
  if (wish.plays && scenario.is_row()) {
    throw InputError(play_flag, "is for one path, the scenario has a row of goals");
  }
  if (wish.plays && picture_format(wish.file) != PictureFormat::svg) {
    throw InputError(play_flag, "is for pictures that end in .svg");
  }
  if (wish.curvature_strip && scenario.is_row()) {
    throw InputError(strip_flag, "is for one path, the scenario has a row of goals");
  }
}

void write_picture(const PictureWish& wish, const ScenarioFile& scenario,
                   const std::vector<ResultRecord>& records) {
  expect_one_path(wish, scenario);
  const auto& [file, has_strip, plays] = wish;
  const PictureFormat format = picture_format(file);
  std::optional<SpeedProfile> speeds;
  std::deque<Scenario> scenarios;
  ContactSheet sheet;
  for (std::size_t i = 0; i < scenario.size(); ++i) {
    scenarios.push_back(scenario_at(scenario, i));
    sheet.drawings.push_back(drawing_of(scenarios.back(), records.empty() ? nullptr : &records[i]));
    sheet.drawings.back().curvature_strip = has_strip;
  }
  const bool one = sheet.drawings.size() == 1;
  if (plays && !records.empty() && records.front().result.path) {
    speeds = speeds_of(scenario.scenario, records.front().result);
    sheet.drawings.front().speeds = &*speeds;
  }
  write_file(file, one ? draw(sheet.drawings.front(), format, picture_width)
                       : draw(sheet, format, picture_width));
}

void write_picture(const std::string& file, const Scenario& scenario, const ResultRecord& planned,
                   const DrivenLine& driven) {
  Drawing drawing = drawing_of(scenario, &planned);
  drawing.driven = &driven.poses;
  drawing.caption = printable(driven.caption);
  write_file(file, draw(drawing, picture_format(file), picture_width));
}

DrawnPairs write_picture(const PictureWish& wish, const ScenarioFile& scenario,
                         ResultReader& results, std::optional<std::size_t> pair) {
  const auto& [file, has_strip, plays] = wish;
  if (plays) throw InputError(play_flag, "is for one path, the result has many");
  if (has_strip && !pair) throw InputError(strip_flag, "is for one path, expected --pair N");
  const PictureFormat format = picture_format(file);
  std::deque<PairPicture> pictures;
  ContactSheet sheet;
  DrawnPairs drawn;
  while (std::optional<PairRecord> next = results.next()) {
    if (pair && next->pair != *pair) continue;
    drawn.is_all = sheet.drawings.size() < max_pictures;
    if (!drawn.is_all) break;
    const PairPicture& picture = pictures.emplace_back(picture_of(scenario, *std::move(next)));
    Drawing drawing = drawing_of(picture.scenario, &picture.pair.record);
    if (pair) {
      drawing.curvature_strip = has_strip;
      write_file(file, draw(drawing, format, picture_width));
      return {1, true};
    }
    drawing.caption =
        fmt::format("{}: {}", picture.pair.pair, captioned_outcome(picture.pair.record.result));
    sheet.drawings.push_back(std::move(drawing));
  }
  if (pair) throw InputError("--pair", fmt::format("there is no pair {}", *pair));
  drawn.drawn = sheet.drawings.size();
  sheet.caption = printable(scenario.scenario.name);
  if (!drawn.is_all) sheet.caption += fmt::format(": the first {} pairs", drawn.drawn);
  write_file(file, draw(sheet, format, picture_width));
  return drawn;
}

}  // namespace vandplan::app
