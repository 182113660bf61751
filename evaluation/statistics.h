// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What do samples show, with which confidence?
//
// Distributions are arbitrary: quantiles and intervals come from ranks. A value may be infinite (an
// unsolved run has infinite cost). Method and reasons: docs/evaluation.md.

#include <span>
#include <vector>

namespace vandplan::evaluation {

/// Interval that contains the true value with the requested confidence.
struct Interval {
  double low = 0.0;
  double high = 0.0;
};

/// The `share`-quantile of ascending values, linearly interpolated between neighbours; infinite as
/// soon as an infinite value has weight. Needs at least one value, and `share` in [0, 1].
[[nodiscard]] double quantile(std::span<const double> sorted, double share) noexcept;

/// A sample's median, and the confidence interval of the distribution's median.
struct MedianEstimate {
  double median = 0.0;
  Interval interval;  ///< confidence interval; (-inf, inf) if there are too few values
};

/// Median with a confidence interval from binomial ranks (inverted sign test). The interval is
/// exact for continuous distributions and conservative with ties. Needs at least one value.
[[nodiscard]] MedianEstimate median_of(std::vector<double> values, double confidence);

/// Wilson's score interval of a share of successes. `trials` >= 1.
[[nodiscard]] Interval share_interval(int successes, int trials, double confidence) noexcept;

/// Comparison of pairs with the same problem and seed: ratio of the first to the second value.
struct PairedComparison {
  int pairs = 0;
  double ratio = 1.0;      ///< median of the ratios
  Interval interval = {};  ///< confidence interval of the median ratio
  /// P-value of the two-sided sign test; equal pairs count against a difference.
  double p_value = 1.0;
  enum class Verdict {
    smaller,
    no_difference,
    larger,
    nothing_searched,  ///< all compared paths were found without a search
  } verdict = Verdict::no_difference;
};

/// Compares `first[i]` with `second[i]`, both > 0; two infinite values are equal. Interval and
/// verdict hold for this comparison alone.
[[nodiscard]] PairedComparison compare_pairs(std::span<const double> first,
                                             std::span<const double> second, double confidence);

/// Removes verdicts until the others hold together with the confidence (Holm 1979). Comparisons
/// without a search do not count, nor those with too few pairs to have a verdict even alone.
void judge_together(std::span<PairedComparison* const> comparisons, double confidence);

}  // namespace vandplan::evaluation
