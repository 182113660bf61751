// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "studies/symmetry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "vandplan/random.h"
#include "vandplan/steering.h"

namespace vandplan::studies {
namespace {

constexpr double pi = std::numbers::pi;
constexpr std::array colours{study_colour::blue, study_colour::orange, study_colour::green,
                             study_colour::purple};
constexpr std::array quadrants{"I", "II", "III", "IV"};

SeenPair mirrored_in_x(const SeenPair& pair) {
  return {{pair.node.x, -pair.node.y, wrap_angle(-pair.node.heading)},
          wrap_angle(-pair.sample_heading)};
}

SeenPair mirrored_in_y(const SeenPair& pair) {
  return {{-pair.node.x, pair.node.y, wrap_angle(pi - pair.node.heading)},
          wrap_angle(pi - pair.sample_heading)};
}

Pose sample_of(const SeenPair& pair) { return {0.0, 0.0, pair.sample_heading}; }

double length_of(const SeenPair& pair, double radius) {
  return reeds_shepp_length(pair.node, sample_of(pair), radius);
}

SymmetryExample example_of(const SeenPair& first, double radius) {
  SymmetryExample example{
      {first, mirrored_in_y(first), mirrored_in_x(mirrored_in_y(first)), mirrored_in_x(first)}, {}};
  for (std::size_t i = 0; i < example.images.size(); ++i) {
    example.lengths[i] = length_of(example.images[i], radius);
  }
  return example;
}

std::string paths_csv(const SymmetryStudy& study) {
  std::string csv = "example,quadrant,x,y,heading,direction\n";
  for (std::size_t i = 0; i < study.examples.size(); ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      const SeenPair& pair = study.examples[i].images[k];
      const Piece piece = reeds_shepp(pair.node, sample_of(pair), study.options.turning_radius);
      append_path(csv, fmt::format("{},{}", i + 1, k + 1),
                  {pair.node, {piece.view().begin(), piece.view().end()}});
    }
  }
  return csv;
}

std::string degrees(double heading) {
  const int whole = static_cast<int>(std::lround(heading * 180 / pi));
  return fmt::format("{}°", whole == -180 ? 180 : whole);
}

// Label beside the node, away from its arrow.
std::string label_of(const SeenPair& pair, std::size_t quadrant) {
  const bool right = pair.node.x > 0.0;
  return fmt::format(
      "set label \"{}: from ({:g}, {:g}, {})\\nto (0, 0, {})\" at {:.3f},{:.3f} {} "
      "textcolor rgb '{}' front\n",
      quadrants[quadrant], pair.node.x, pair.node.y, degrees(pair.node.heading),
      degrees(pair.sample_heading), pair.node.x + (right ? 1.0 : -1.0),
      pair.node.y + (pair.node.y > 0.0 ? 4.5 : -3.0), right ? "left" : "right", colours[quadrant]);
}

std::string panel_of(const SymmetryExample& example, int number) {
  std::string text = fmt::format("set title 'every path is {:.3f} m long'\n", example.lengths[0]);
  std::string curves;
  for (std::size_t k = 0; k < 4; ++k) {
    const SeenPair& pair = example.images[k];
    text += arrow_at(pair.node, 2.5, colours[k]) + arrow_at(sample_of(pair), 2.5, colours[k]) +
            label_of(pair, k);
    if (k > 0) curves += ", \\\n  ";
    curves += plot_of_path("symmetry.csv", number, static_cast<int>(k) + 1, colours[k]);
  }
  return text + "plot " + curves + "\nunset arrow\nunset label\n";
}

// Half the height of a picture that shows every path, with room for the labels [m].
double half_height_of(const SymmetryStudy& study) {
  double furthest = 15.0;
  for (const SymmetryExample& example : study.examples) {
    const Piece piece = reeds_shepp(example.images[0].node, sample_of(example.images[0]),
                                    study.options.turning_radius);
    const Path path{example.images[0].node, {piece.view().begin(), piece.view().end()}};
    for (const PathPoint& point : sampled(path, piece.length / 64)) {
      furthest = std::max({furthest, std::abs(point.pose.y), std::abs(point.pose.x) / 1.6});
    }
  }
  return 1.5 * furthest;
}

}  // namespace

SeenPair folded(const SeenPair& pair) {
  SeenPair result = pair;
  if (result.node.y < 0.0) result = mirrored_in_x(result);
  if (result.node.x < 0.0) result = mirrored_in_y(result);
  return result;
}

SymmetryStudy study_symmetry(const SymmetryOptions& options) {
  const double radius = options.turning_radius;
  SymmetryStudy study{options, {}, 0.0};
  study.examples.push_back(example_of({{8.0, 10.0, pi / 5}, 0.0}, radius));
  study.examples.push_back(example_of({{14.0, 6.0, 2 * pi / 3}, pi / 4}, radius));
  Rng rng(options.seed);
  for (std::int64_t i = 0; i < options.pairs; ++i) {
    const double reach = options.reach;
    const SeenPair pair{uniform_pose({-reach, reach, -reach, reach}, rng), uniform(-pi, pi, rng)};
    const double difference = std::abs(length_of(pair, radius) - length_of(folded(pair), radius));
    study.worst_difference = std::max(study.worst_difference, difference);
  }
  return study;
}

StudyFiles files_of(const SymmetryStudy& study) {
  const double half = half_height_of(study);
  std::string body = fmt::format(
      "set multiplot layout 1,2 title 'Mirrored pairs of poses have paths of the same length "
      "(turning radius {} m; reverse is dashed)' font ',13'\n"
      "set size ratio -1\n"
      "set xlabel 'x [m]'\n"
      "set ylabel 'y [m]'\n"
      "set xrange [-{}:{}]\n"
      "set yrange [-{}:{}]\n",
      study.options.turning_radius, 1.6 * half, 1.6 * half, half, half);
  for (std::size_t i = 0; i < study.examples.size(); ++i) {
    body += panel_of(study.examples[i], static_cast<int>(i) + 1);
  }
  return study_files({"symmetry", 1500, 560}, {{"symmetry.csv", paths_csv(study)}},
                     body + "unset multiplot\n");
}

}  // namespace vandplan::studies
