// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/statistics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace vandplan::evaluation {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Probability P(B(n, 1/2) = k) of the binomial distribution.
double fair_share(std::size_t n, std::size_t k) {
  const auto [size, chosen] = std::pair(static_cast<double>(n), static_cast<double>(k));
  return std::exp(std::lgamma(size + 1.0) - std::lgamma(chosen + 1.0) -
                  std::lgamma(size - chosen + 1.0) - size * std::log(2.0));
}

// Largest k for which the k-th smallest and the k-th largest of n values enclose the median with
// the confidence; 0 if not even the extremes do. P(median outside) = 2 P(B(n, 1/2) < k).
std::size_t enclosing_rank(std::size_t n, double confidence) {
  double outside = 0.0;
  std::size_t k = 0;
  for (; k < n / 2; ++k) {
    outside += 2.0 * fair_share(n, k);
    if (outside > 1.0 - confidence) break;
  }
  return k;
}

// p-value of the two-sided sign test: probability that at least `on_one_side` of n fair coins fall
// to the same side.
double sign_test(std::size_t n, std::size_t on_one_side) {
  double p = 0.0;
  for (std::size_t k = on_one_side; k <= n; ++k) p += 2.0 * fair_share(n, k);
  return std::min(p, 1.0);
}

// The z with P(|Z| < z) = `confidence` for a standard normal Z, by bisection of erf.
double normal_quantile(double confidence) {
  double low = 0.0;
  double high = 40.0;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2.0;
    (std::erf(middle / std::sqrt(2.0)) < confidence ? low : high) = middle;
  }
  return low;
}

}  // namespace

double quantile(std::span<const double> sorted, double share) noexcept {
  assert(!sorted.empty());
  const double position = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(position);
  const double weight = position - static_cast<double>(below);
  if (weight == 0.0) return sorted[below];
  if (std::isinf(sorted[below + 1])) return sorted[below + 1];
  return sorted[below] + weight * (sorted[below + 1] - sorted[below]);
}

MedianEstimate median_of(std::vector<double> values, double confidence) {
  std::ranges::sort(values);
  const std::size_t rank = enclosing_rank(values.size(), confidence);
  if (rank == 0) return {quantile(values, 0.5), {-infinity, infinity}};
  return {quantile(values, 0.5), {values[rank - 1], values[values.size() - rank]}};
}

// Wilson 1927: the interval holds the shares p that are within z standard deviations of the
// observed share.
Interval share_interval(int successes, int trials, double confidence) noexcept {
  const double z = normal_quantile(confidence);
  const double n = trials;
  const double p = successes / n;
  const double centre = (p + z * z / (2.0 * n)) / (1.0 + z * z / n);
  const double half = z / (1.0 + z * z / n) * std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n));
  return {successes == 0 ? 0.0 : centre - half, successes == trials ? 1.0 : centre + half};
}

PairedComparison compare_pairs(std::span<const double> first, std::span<const double> second,
                               double confidence) {
  assert(first.size() == second.size());
  PairedComparison comparison{.pairs = static_cast<int>(first.size())};
  if (first.empty()) return comparison;
  std::vector<double> ratios;
  for (std::size_t i = 0; i < first.size(); ++i)
    ratios.push_back(first[i] == second[i] ? 1.0 : first[i] / second[i]);
  const auto smaller = std::ranges::count_if(ratios, [](double ratio) { return ratio < 1.0; });
  const auto larger = std::ranges::count_if(ratios, [](double ratio) { return ratio > 1.0; });
  comparison.p_value = sign_test(first.size(), static_cast<std::size_t>(std::max(smaller, larger)));
  const MedianEstimate estimate = median_of(std::move(ratios), confidence);
  comparison.ratio = estimate.median;
  comparison.interval = {std::max(0.0, estimate.interval.low), estimate.interval.high};
  if (comparison.p_value > 1.0 - confidence) return comparison;
  comparison.verdict =
      smaller > larger ? PairedComparison::Verdict::smaller : PairedComparison::Verdict::larger;
  return comparison;
}

// Holm 1979: sorted by p, the k-th of m comparisons (k from 0) must have p <= alpha / (m - k). The
// first that has not, and all after it, lose their verdict.
void judge_together(std::span<PairedComparison* const> comparisons, double confidence) {
  const double alpha = 1.0 - confidence;
  std::vector<PairedComparison*> able;
  for (PairedComparison* const comparison : comparisons) {
    const auto pairs = static_cast<std::size_t>(comparison->pairs);
    const bool is_able = comparison->verdict != PairedComparison::Verdict::nothing_searched &&
                         pairs > 0 && sign_test(pairs, pairs) <= alpha;
    if (is_able) able.push_back(comparison);
  }
  std::ranges::stable_sort(able, {}, &PairedComparison::p_value);
  bool holds = true;
  for (std::size_t k = 0; k < able.size(); ++k) {
    holds = holds && able[k]->p_value <= alpha / static_cast<double>(able.size() - k);
    if (!holds) able[k]->verdict = PairedComparison::Verdict::no_difference;
  }
}

}  // namespace vandplan::evaluation
