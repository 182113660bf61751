// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What do samples say, and how surely?
//
// Nothing is assumed of distributions: quantiles and intervals come from ranks. A value may be
// infinite (an unsolved run has infinite cost). Method and reasons: docs/evaluation.md.

#include <span>
#include <vector>

namespace vandplan::evaluation {

/// Where the true value lies, with the confidence that was asked for.
struct Interval {
  double low = 0.0;
  double high = 0.0;
};

/// The `share`-quantile of values in ascending order, between two of them by linear interpolation;
/// infinite as soon as an infinite value has weight. At least one value; `share` in [0, 1].
[[nodiscard]] double quantile(std::span<const double> sorted, double share) noexcept;

/// A median and the interval for the median of what the values were drawn from.
struct MedianEstimate {
  double median = 0.0;
  Interval interval;  ///< unbounded (-inf, inf) when there are too few values to say
};

/// By the ranks of the binomial distribution (the sign test turned round): exact for every
/// continuous distribution, on the safe side with ties. At least one value.
[[nodiscard]] MedianEstimate median_of(std::vector<double> values, double confidence);

/// Wilson's score interval for a share. `trials` >= 1.
[[nodiscard]] Interval share_interval(int successes, int trials, double confidence) noexcept;

/// Pairs of the same problem and seed: by which factor is the first of a pair larger?
struct PairedComparison {
  int pairs = 0;
  double ratio = 1.0;      ///< median over the pairs
  Interval interval = {};  ///< of the median ratio
  double p_value = 1.0;    ///< of the sign test, two-sided; equal pairs speak for no difference
  enum class Verdict {
    smaller,
    no_difference,
    larger,
    nothing_searched,  ///< all of what is compared was found without a search
  } verdict = Verdict::no_difference;
};

/// Compares `first[i]` with `second[i]`, both > 0; two infinite ones are equal. Interval and
/// verdict hold for this comparison alone.
[[nodiscard]] PairedComparison compare_pairs(std::span<const double> first,
                                             std::span<const double> second, double confidence);

/// Takes back verdicts until all of them hold together with the confidence (Holm 1979). Comparisons
/// of nothing searched, and those of so few pairs that they could not have a verdict even alone, do
/// not count.
void judge_together(std::span<PairedComparison* const> comparisons, double confidence);

}  // namespace vandplan::evaluation
