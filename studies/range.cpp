// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "studies/range.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "base/trigonometry.h"
#include "vandplan/random.h"
#include "vandplan/steering.h"

namespace vandplan::studies {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int last_ring = 50;

// Algorithm 3 for one random pair at `distance` [m].
RangePair random_pair(double distance, double radius, Rng& rng) {
  const base::SinCos bearing = base::sin_cos(uniform(-pi, pi, rng));
  const Pose from{0.0, 0.0, uniform(-pi, pi, rng)};
  const Pose to{distance * bearing.cos, distance * bearing.sin, uniform(-pi, pi, rng)};
  return {distance, dubins_length(from, to, radius), reeds_shepp_length(from, to, radius)};
}

void add(Detour& detour, double beyond) {
  detour.mean += beyond / static_cast<double>(pairs_of_a_ring);
  detour.largest = std::max(detour.largest, beyond);
}

RangeRing random_ring(double distance, double radius, Rng& rng) {
  RangeRing ring{.distance = distance, .dubins = {}, .reeds_shepp = {}};
  for (std::int64_t i = 0; i < pairs_of_a_ring; ++i) {
    const RangePair pair = random_pair(distance, radius, rng);
    add(ring.dubins, pair.dubins - distance);
    add(ring.reeds_shepp, pair.reeds_shepp - distance);
  }
  return ring;
}

}  // namespace

RangeStudy study_range(const RangeOptions& options) {
  RangeStudy study{options, {}, {}};
  Rng rng(options.seed);
  for (std::int64_t i = 0; i < options.pairs; ++i) {
    const double distance = uniform(0.0, options.reach, rng);
    study.pairs.push_back(random_pair(distance, options.turning_radius, rng));
  }
  rng.seed(stream_seed(options.seed, 1));  // independent of the number of pairs above
  for (int i = 0; i <= last_ring; ++i) {
    study.rings.push_back(random_ring(options.reach * i / last_ring, options.turning_radius, rng));
  }
  return study;
}

StudyFiles files_of(const RangeStudy& study) {
  std::string pairs = "euclid,dubins,reeds_shepp\n";
  for (const auto& [euclid, dubins, reeds_shepp] : study.pairs) {
    pairs += fmt::format("{:.6f},{:.6f},{:.6f}\n", euclid, dubins, reeds_shepp);
  }
  std::string rings = "distance,dubins_mean,dubins_largest,reeds_shepp_mean,reeds_shepp_largest\n";
  for (const auto& [distance, dubins, reeds_shepp] : study.rings) {
    rings += fmt::format("{:.6f},{:.6f},{:.6f},{:.6f},{:.6f}\n", distance, dubins.mean,
                         dubins.largest, reeds_shepp.mean, reeds_shepp.largest);
  }
  const std::string body = fmt::format(
      "set multiplot layout 1,2 title 'Length of shortest paths between random poses, turning "
      "radius {radius} m' font ',13'\n"
      "set xlabel 'Euclidean distance [m]'\n"
      "set xrange [0:{reach}]\n"
      "set yrange [0:*]\n"
      "set key top left reverse Left opaque\n"
      "set ylabel 'length [m]'\n"
      "set title 'Lengths of {count} pairs'\n"
      "plot 'range.csv' skip 1 using 1:2 with dots linecolor rgb '{orange}' notitle, \\\n"
      "  'range.csv' skip 1 using 1:3 with dots linecolor rgb '{blue}' notitle, \\\n"
      "  x with lines linewidth 2 linecolor rgb '{ink}' title 'Euclid', \\\n"
      "  NaN with points pointtype 7 linecolor rgb '{blue}' title 'Reeds-Shepp', \\\n"
      "  NaN with points pointtype 7 linecolor rgb '{orange}' title 'Dubins'\n"
      "set key top right noreverse Right\n"
      "set ylabel 'length - Euclidean distance [m]'\n"
      "set title 'Mean and largest of {ring} pairs at each distance'\n"
      "plot 'range_rings.csv' skip 1 using 1:3 with lines linewidth 1.5 dashtype (8,5) "
      "linecolor rgb '{orange}' title 'Dubins, largest', \\\n"
      "  '' skip 1 using 1:2 with lines linewidth 2 linecolor rgb '{orange}' title 'Dubins, "
      "mean', \\\n"
      "  '' skip 1 using 1:5 with lines linewidth 1.5 dashtype (8,5) linecolor rgb '{blue}' "
      "title 'Reeds-Shepp, largest', \\\n"
      "  '' skip 1 using 1:4 with lines linewidth 2 linecolor rgb '{blue}' title 'Reeds-Shepp, "
      "mean'\n"
      "unset multiplot\n",
      fmt::arg("radius", study.options.turning_radius), fmt::arg("reach", study.options.reach),
      fmt::arg("count", study.pairs.size()), fmt::arg("ring", pairs_of_a_ring),
      fmt::arg("orange", study_colour::orange), fmt::arg("blue", study_colour::blue),
      fmt::arg("ink", study_colour::ink));
  return study_files({"range", 1300, 600},
                     {{"range.csv", std::move(pairs)}, {"range_rings.csv", std::move(rings)}},
                     body);
}

}  // namespace vandplan::studies
