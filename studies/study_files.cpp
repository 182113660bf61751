// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "studies/study_files.h"

#include <fmt/format.h>

#include <cmath>

namespace vandplan::studies {
namespace {

std::string gnuplot_script(const Canvas& canvas, const std::string& body) {
  const auto& [name, width, height] = canvas;
  return fmt::format(
      "# `gnuplot {0}.gp` makes {0}.png and {0}.svg of the numbers in {0}*.csv.\n"
      "set encoding utf8\n"
      "set datafile separator ','\n"
      "set border linecolor rgb '{3}'\n"
      "set tics nomirror textcolor rgb '{3}'\n"
      "set grid linecolor rgb '#dfe3e8' linewidth 1\n"
      "do for [ending in 'png svg'] {{\n"
      "if (ending eq 'png') {{ set terminal pngcairo noenhanced size {1},{2} font 'DejaVu Sans,11' "
      "}}\n"
      "if (ending eq 'svg') {{ set terminal svg noenhanced size {1},{2} font 'DejaVu Sans,11' "
      "background "
      "'#ffffff' }}\n"
      "set output '{0}.'.ending\n"
      "{4}"
      "set output\n"
      "}}\n",
      name, width, height, study_colour::ink, body);
}

}  // namespace

StudyFiles study_files(const Canvas& canvas, std::vector<TextFile> data, const std::string& body) {
  return {std::move(data),
          {canvas.name + ".gp", gnuplot_script(canvas, body)},
          {canvas.name + ".png", canvas.name + ".svg"}};
}

void append_path(std::string& csv, const std::string& labels, const Path& path) {
  Pose pose = path.start;
  for (const Segment& segment : path.segments) {
    const int direction = segment.length < 0.0 ? -1 : 1;
    const double step = std::abs(segment.length) / 64;
    for (const PathPoint& point : sampled({pose, {segment}}, step)) {
      csv += fmt::format("{},{:.4f},{:.4f},{:.5f},{}\n", labels, point.pose.x, point.pose.y,
                         point.pose.heading, direction);
    }
    pose = advance(pose, segment);
  }
}

std::string plot_of_path(const std::string& file, int first, int second,
                         const std::string& colour) {
  std::string text;
  for (const int direction : {1, -1}) {
    if (!text.empty()) text += ", \\\n  ";
    text += fmt::format(
        "'{}' skip 1 using ($1=={} && $2=={} && $6=={} ? $3 : NaN):4 with lines linewidth 2 "
        "dashtype {} linecolor rgb '{}' notitle",
        file, first, second, direction, direction > 0 ? "solid" : "(8,5)", colour);
  }
  return text;
}

std::string arrow_at(const Pose& pose, double length, const std::string& colour) {
  return fmt::format(
      "set arrow from {:.4f},{:.4f} to {:.4f},{:.4f} filled size {:.3f},20 front linewidth 2.5 "
      "linecolor rgb '{}'\n",
      pose.x, pose.y, pose.x + length * std::cos(pose.heading),
      pose.y + length * std::sin(pose.heading), 0.4 * length, colour);
}

std::string word_of(std::span<const Segment> segments) {
  std::string word;
  for (const Segment& segment : segments) {
    if (!word.empty()) word += ' ';
    word += segment.curvature > 0.0 ? 'L' : segment.curvature < 0.0 ? 'R' : 'S';
    word += segment.length < 0.0 ? '-' : '+';
  }
  return word;
}

}  // namespace vandplan::studies
