// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "studies/steering.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "vandplan/steering.h"

namespace vandplan::studies {
namespace {

constexpr double pi = std::numbers::pi;

struct Wish {
  const char* name;
  Pose goal;  ///< pose of the goal; its position in turning radii
};

constexpr Wish wishes[] = {
    {"to the side", {0.0, 0.6, 0.0}},
    {"straight back", {-1.5, 0.0, 0.0}},
    {"turned round", {0.8, 0.0, pi}},
    {"round the corner", {2.5, 2.2, pi / 2}},
};

Path path_of(const Piece& piece) { return {{}, {piece.view().begin(), piece.view().end()}}; }

std::string paths_csv(const SteeringStudy& study) {
  std::string csv = "example,steering,x,y,heading,direction\n";
  for (std::size_t i = 0; i < study.examples.size(); ++i) {
    append_path(csv, fmt::format("{},1", i + 1), path_of(study.examples[i].dubins));
    append_path(csv, fmt::format("{},2", i + 1), path_of(study.examples[i].reeds_shepp));
  }
  return csv;
}

// Square that contains both paths of an example [m].
Bounds frame_of(const SteeringExample& example) {
  std::vector<Point> points;
  for (const Piece* piece : {&example.dubins, &example.reeds_shepp}) {
    for (const PathPoint& point : sampled(path_of(*piece), piece->length / 256)) {
      points.push_back({point.pose.x, point.pose.y});
    }
  }
  const Bounds box = bounding_box(points);
  const double half = std::max(box.x_max - box.x_min, box.y_max - box.y_min) / 2 * 1.2;
  const double x = (box.x_min + box.x_max) / 2;
  const double y = (box.y_min + box.y_max) / 2;
  return {x - half, x + half, y - half, y + half};
}

std::string panel_of(const SteeringExample& example, int number, int steering) {
  const Piece& piece = steering == 1 ? example.dubins : example.reeds_shepp;
  const Bounds frame = frame_of(example);
  const double arrow = (frame.x_max - frame.x_min) / 12;
  return fmt::format(
             "set title \"{}: {}\\n{:.1f} m, {}\"\nset xrange [{:.3f}:{:.3f}]\nset yrange "
             "[{:.3f}:{:.3f}]\n",
             steering == 1 ? "Dubins" : "Reeds-Shepp", example.name, piece.length,
             word_of(piece.view()), frame.x_min, frame.x_max, frame.y_min, frame.y_max) +
         arrow_at({}, arrow, study_colour::green) +
         arrow_at(example.goal, arrow, study_colour::purple) + "plot " +
         plot_of_path("steering.csv", number, steering,
                      steering == 1 ? study_colour::orange : study_colour::blue) +
         "\nunset arrow\n";
}

}  // namespace

SteeringStudy study_steering(const SteeringOptions& options) {
  const double radius = options.turning_radius;
  SteeringStudy study{options, {}};
  for (const auto& [name, wish] : wishes) {
    const Pose goal{wish.x * radius, wish.y * radius, wish.heading};
    study.examples.push_back({name, goal, dubins({}, goal, radius), reeds_shepp({}, goal, radius)});
  }
  return study;
}

StudyFiles files_of(const SteeringStudy& study) {
  std::string body = fmt::format(
      "set multiplot layout 2,{} title 'Shortest paths, turning radius {} m: start green, goal "
      "purple, reverse dashed' font ',13'\n"
      "set size ratio -1\n"
      "set xlabel 'x [m]'\n"
      "set ylabel 'y [m]'\n",
      study.examples.size(), study.options.turning_radius);
  for (const int steering : {1, 2}) {
    for (std::size_t i = 0; i < study.examples.size(); ++i) {
      body += panel_of(study.examples[i], static_cast<int>(i) + 1, steering);
    }
  }
  return study_files({"steering", 1500, 860}, {{"steering.csv", paths_csv(study)}},
                     body + "unset multiplot\n");
}

}  // namespace vandplan::studies
