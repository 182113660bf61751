// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "studies/accuracy.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/escape.h"
#include "studies/percentile.h"
#include "vandplan/random.h"
#include "vandplan/steering.h"

namespace vandplan::studies {
namespace {

constexpr double pi = std::numbers::pi;

/// Two states and the exact length between them [m].
struct Case {
  State node, sample;
  double length;
};

/// Computes exact lengths; without a path of the rig there is none.
class Exact {
 public:
  explicit Exact(const AccuracyOptions& options) : radius_(options.turning_radius) {
    if (options.rig) rig_.emplace(*options.rig);
  }

  [[nodiscard]] std::optional<double> length(const State& node, const State& sample) const {
    if (!rig_) return reeds_shepp_length(node.pose, sample.pose, radius_);
    const std::optional<Piece> piece = rig_->steer(node, sample);
    return piece ? std::optional(piece->length) : std::nullopt;
  }

 private:
  double radius_;
  std::optional<RigSteering> rig_;
};

std::vector<Case> random_cases(const AccuracyOptions& options) {
  const double reach = options.reach;
  const Exact exact(options);
  Rng rng(options.seed);
  const auto hitch_angle = [&] {
    if (!options.rig) return 0.0;
    const double share = uniform(-1.0, 1.0, rng);
    return options.rig->max_hitch_angle * share * share * share;
  };
  std::vector<Case> cases;
  cases.reserve(static_cast<std::size_t>(options.pairs));
  while (cases.size() < static_cast<std::size_t>(options.pairs)) {
    const Pose at{0.0, 0.0, uniform(-pi, pi, rng)};
    const State node{uniform_pose({-reach, reach, -reach, reach}, rng), hitch_angle()};
    const State sample{at, hitch_angle()};
    const std::optional<double> length = exact.length(node, sample);
    if (length && *length > 0.0) cases.push_back({node, sample, *length});
  }
  return cases;
}

/// Replaces characters that would end a field of CSV or a text of gnuplot.
std::string plain(std::string name) {
  for (char& c : name) {
    if (c == ',' || c == '\'' || c == '"' || c == '\\' || static_cast<unsigned char>(c) < ' ')
      c = '_';
  }
  return name;
}

/// Distribution of the values, which it reorders.
Spread spread_of(std::vector<double>& values) {
  Spread spread;
  const auto [least, largest] = std::ranges::minmax(values);
  spread.least = least;
  spread.largest = largest;
  for (const double value : values) spread.mean += value / static_cast<double>(values.size());
  for (std::size_t i = 0; i < percents.size(); ++i) {
    spread.percentiles[i] = percentile(values, percents[i]);
  }
  return spread;
}

std::size_t bin_of(double relative) {
  const double bin = std::floor((relative + 1.0) * bins_of_unity);
  return static_cast<std::size_t>(std::clamp(bin, 0.0, 2.0 * bins_of_unity));
}

Accuracy accuracy_of(const NamedEstimate& estimate, const std::vector<Case>& cases) {
  Accuracy accuracy;
  accuracy.name = plain(estimate.name);
  accuracy.is_drawn = estimate.is_drawn;
  accuracy.histogram.resize(2 * bins_of_unity + 1);
  std::vector<double> metres, relative;
  const double share = 1.0 / static_cast<double>(cases.size());
  std::int64_t within = 0;
  std::int64_t over = 0;
  for (const auto& [node, sample, length] : cases) {
    const double difference = estimate.length(node, sample) - length;
    metres.push_back(difference);
    relative.push_back(difference / length);
    ++accuracy.histogram[bin_of(relative.back())];
    if (std::abs(relative.back()) <= 0.1) ++within;
    if (difference > 0.0) ++over;
  }
  accuracy.within_a_tenth = static_cast<double>(within) * share;
  accuracy.over = static_cast<double>(over) * share;
  accuracy.relative = spread_of(relative);
  accuracy.metres = spread_of(metres);
  return accuracy;
}

std::string histogram_csv(const AccuracyStudy& study) {
  std::string csv = "low,high";
  for (const Accuracy& estimate : study.estimates) csv += "," + base::csv_cell(estimate.name);
  csv += "\n";
  for (int bin = 0; bin <= 2 * bins_of_unity; ++bin) {
    const double low = static_cast<double>(bin - bins_of_unity) / bins_of_unity;
    const bool last = bin == 2 * bins_of_unity;
    csv += fmt::format("{:.3f},{}", low,
                       last ? "inf" : fmt::format("{:.3f}", low + 1.0 / bins_of_unity));
    for (const Accuracy& estimate : study.estimates) {
      csv += fmt::format(",{}", estimate.histogram[static_cast<std::size_t>(bin)]);
    }
    csv += "\n";
  }
  return csv;
}

}  // namespace

AccuracyStudy study_accuracy(const AccuracyOptions& options,
                             const std::vector<NamedEstimate>& estimates) {
  const std::vector<Case> cases = random_cases(options);
  AccuracyStudy study{options, {}};
  for (const NamedEstimate& estimate : estimates) {
    study.estimates.push_back(accuracy_of(estimate, cases));
  }
  return study;
}

StudyFiles files_of(const AccuracyStudy& study) {
  constexpr std::array colours{study_colour::grey, study_colour::orange, study_colour::blue,
                               study_colour::green, study_colour::purple};
  const double pairs = static_cast<double>(study.options.pairs);
  const std::string name = study.options.rig ? "trailer-accuracy" : "accuracy";
  std::string curves;
  std::size_t drawn = 0;
  for (std::size_t i = 0; i < study.estimates.size(); ++i) {
    const Accuracy& estimate = study.estimates[i];
    if (!estimate.is_drawn) continue;
    // The last line of the file is the bin beyond 1, which is not drawn.
    curves += fmt::format(
        "{}  '{}.csv' skip 1 every ::0::{} using 1:(${}/{}*100) with steps linewidth 2 "
        "linecolor rgb '{}' title '{}: {:.0f} % within 10 %, {:.0f} % too long'",
        curves.empty() ? "" : ", \\\n", name, 2 * bins_of_unity - 1, i + 3, pairs,
        colours[drawn++ % colours.size()], estimate.name, 100 * estimate.within_a_tenth,
        100 * estimate.over);
  }
  const std::string body = fmt::format(
      "set title 'Estimates of {} lengths: {} random pairs, |x| and |y| below {} m, "
      "turning radius {:.4g} m' font ',13'\n"
      "set xlabel '(estimate - length) / length'\n"
      "set ylabel 'share of the pairs in a bin of {} [%]'\n"
      "set xrange [-1:0.6]\n"
      "set yrange [0:*]\n"
      "set xtics 0.1\n"
      "set key top {}\n"
      "set object 1 rectangle from first -0.1,graph 0 to first 0.1,graph 1 behind fillcolor rgb "
      "'#e8eff6' fillstyle solid noborder\n"
      "plot \\\n{}\n",
      study.options.rig ? "a rig''s" : "Reeds-Shepp", study.options.pairs, study.options.reach,
      study.options.turning_radius, 1.0 / bins_of_unity, study.options.rig ? "left" : "right",
      curves);
  return study_files({name, 1200, 650}, {{name + ".csv", histogram_csv(study)}}, body);
}

}  // namespace vandplan::studies
