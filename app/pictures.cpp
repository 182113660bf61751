// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "pictures.h"

#include <fmt/format.h>

#include "vandplan/draw.h"

namespace vandplan {
namespace {

constexpr int width = 1200;  // pixels or points

std::string caption_of(const Scenario& scenario, const ResultRecord& record) {
  std::string caption = scenario.name;
  if (record.distance) caption += fmt::format(" {:.6g} m", *record.distance);
  caption += fmt::format(", {}, seed {}: ", record.planner, record.options.seed);
  if (!record.result.path) return caption + std::string(name_of(record.result.status));
  const std::vector<Segment>& segments = record.result.path->segments;
  return caption +
         fmt::format("{:.2f} m, gear changes {}", length(segments), gear_changes(segments));
}

Drawing drawing_of(const Scenario& scenario, std::size_t goal, const ResultRecord* record) {
  Drawing drawing{.scenario = &scenario, .goal = goal, .caption = scenario.name};
  if (record == nullptr) return drawing;
  const PlanResult& result = record->result;
  if (result.path) drawing.path = &*result.path;
  if (result.tree) drawing.tree = &*result.tree;
  drawing.caption = caption_of(scenario, *record);
  return drawing;
}

}  // namespace

void expect_picture(const std::string& file) {
  (void)picture_format(file);
  expect_writable(file);
}

void write_picture(const std::string& file, const Scenario& scenario,
                   const std::vector<ResultRecord>& records) {
  const PictureFormat format = picture_format(file);
  ContactSheet sheet;
  for (std::size_t i = 0; i < scenario.goals.size(); ++i) {
    sheet.drawings.push_back(drawing_of(scenario, i, records.empty() ? nullptr : &records[i]));
  }
  const bool one = sheet.drawings.size() == 1;
  write_file(file, one ? draw(sheet.drawings.front(), format, width) : draw(sheet, format, width));
}

}  // namespace vandplan
