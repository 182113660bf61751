// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "support/numbers.h"
#include "vandplan/random.h"

namespace vandplan::evaluation {
namespace {

using Verdict = PairedComparison::Verdict;

std::vector<double> one_to(int n) {
  std::vector<double> values(static_cast<std::size_t>(n));
  std::iota(values.begin(), values.end(), 1.0);
  return values;
}

TEST(Quantile, LiesBetweenTheTwoValuesAroundIt) {
  const std::vector<double> values = {1.0, 2.0, 4.0};
  EXPECT_EQ(quantile(values, 0.0), 1.0);
  EXPECT_EQ(quantile(values, 0.5), 2.0);
  EXPECT_EQ(quantile(values, 0.75), 3.0);
  EXPECT_EQ(quantile(values, 1.0), 4.0);
}

TEST(Quantile, IsInfiniteWhenHalfOfTheRunsFail) {
  EXPECT_EQ(quantile(std::vector{1.0, infinity}, 0.5), infinity);
  EXPECT_EQ(quantile(std::vector{1.0, infinity, infinity, infinity}, 0.5), infinity);
  EXPECT_EQ(quantile(std::vector{1.0, 2.0, infinity}, 0.5), 2.0);
}

// P(B(25, 1/2) <= 7) = 0.0216 and P(B(25, 1/2) <= 8) = 0.0539: the 8th and the 18th of 25.
TEST(Median, IsEnclosedByTheEighthAndTheEighteenthOfTwentyFive) {
  const MedianEstimate estimate = median_of(one_to(25), 0.95);
  EXPECT_EQ(estimate.median, 13.0);
  EXPECT_EQ(estimate.interval.low, 8.0);
  EXPECT_EQ(estimate.interval.high, 18.0);
}

// Six values enclose the median with 1 - 2/64 = 0.969, five with 0.9375 only.
TEST(Median, OfTooFewValuesHasNoBounds) {
  EXPECT_EQ(median_of(one_to(6), 0.95).interval.high, 6.0);
  EXPECT_EQ(median_of(one_to(5), 0.95).interval.low, -infinity);
  EXPECT_EQ(median_of(one_to(5), 0.95).interval.high, infinity);
  EXPECT_EQ(median_of(one_to(5), 0.9).interval.high, 5.0);
  EXPECT_EQ(median_of({7.0}, 0.95).median, 7.0);
}

TEST(Median, OfManyValuesHasANarrowInterval) {
  const MedianEstimate estimate = median_of(one_to(10001), 0.95);
  EXPECT_NEAR(estimate.interval.low, 5001.0 - 98.0, 1.0);  // 1.96 sqrt(n) / 2
  EXPECT_NEAR(estimate.interval.high, 5001.0 + 98.0, 1.0);
}

TEST(Median, IntervalKeepsItsPromiseOnASkewedDistribution) {
  Rng rng(1);
  for (const int n : {6, 25, 70}) {
    int covered = 0;
    for (int trial = 0; trial < 4000; ++trial) {
      std::vector<double> values;
      for (int i = 0; i < n; ++i) values.push_back(-std::log(1.0 - uniform01(rng)));
      const Interval interval = median_of(values, 0.95).interval;
      covered += interval.low <= std::log(2.0) && std::log(2.0) <= interval.high;
    }
    EXPECT_GT(covered, 4000 * 0.94) << n;  // 3 standard deviations below 0.95
    EXPECT_LT(covered, 4000 * 0.985) << n;
  }
}

TEST(ShareInterval, IsWilsons) {
  const Interval interval = share_interval(8, 10, 0.95);
  EXPECT_NEAR(interval.low, 0.4902, 5e-5);
  EXPECT_NEAR(interval.high, 0.9433, 5e-5);
}

TEST(ShareInterval, OfNoneAndOfAllEndsThere) {
  EXPECT_EQ(share_interval(0, 25, 0.95).low, 0.0);
  EXPECT_NEAR(share_interval(0, 25, 0.95).high, 0.1332, 5e-5);
  EXPECT_NEAR(share_interval(25, 25, 0.95).low, 0.8668, 5e-5);
  EXPECT_EQ(share_interval(25, 25, 0.95).high, 1.0);
}

TEST(PairedComparison, SeesAFactorThatIsSmallBesideTheSpread) {
  Rng rng(2);
  std::vector<double> first, second;
  for (int i = 0; i < 25; ++i) {
    second.push_back(std::exp(uniform(0.0, 5.0, rng)));
    first.push_back(second.back() * uniform(0.8, 0.99, rng));
  }
  const PairedComparison comparison = compare_pairs(first, second, 0.95);
  EXPECT_EQ(comparison.pairs, 25);
  EXPECT_EQ(comparison.verdict, Verdict::smaller);
  EXPECT_NEAR(comparison.ratio, 0.9, 0.05);
  EXPECT_EQ(compare_pairs(second, first, 0.95).verdict, Verdict::larger);
}

TEST(PairedComparison, CountsAnUnsolvedRunAsInfinite) {
  const std::vector<double> solved(10, 5.0);
  const std::vector<double> unsolved(10, infinity);
  EXPECT_EQ(compare_pairs(solved, unsolved, 0.95).verdict, Verdict::smaller);
  EXPECT_EQ(compare_pairs(solved, unsolved, 0.95).ratio, 0.0);
  EXPECT_EQ(compare_pairs(unsolved, solved, 0.95).verdict, Verdict::larger);
  EXPECT_EQ(compare_pairs(unsolved, unsolved, 0.95).ratio, 1.0);
  EXPECT_EQ(compare_pairs(unsolved, unsolved, 0.95).verdict, Verdict::no_difference);
}

TEST(PairedComparison, RarelySeesADifferenceThatIsNotThere) {
  Rng rng(3);
  int seen = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    std::vector<double> first, second;
    for (int i = 0; i < 25; ++i) {
      first.push_back(uniform(1.0, 2.0, rng));
      second.push_back(uniform(1.0, 2.0, rng));
    }
    seen += compare_pairs(first, second, 0.95).verdict != Verdict::no_difference;
  }
  EXPECT_LT(seen, 4000 * 0.06);
}

// Sixteen pairs of 25 one way: 2 P(B(25, 1/2) >= 16) = 0.2295; 20 of them: 0.00408.
TEST(PairedComparison, HasThePValueOfTheSignTest) {
  const auto p_value = [](int smaller) {
    std::vector<double> first(25, 2.0);
    std::fill_n(first.begin(), smaller, 0.5);
    return compare_pairs(first, std::vector<double>(25, 1.0), 0.95).p_value;
  };
  EXPECT_NEAR(p_value(16), 0.22952, 5e-6);
  EXPECT_NEAR(p_value(9), 0.22952, 5e-6);
  EXPECT_NEAR(p_value(20), 0.0040770, 5e-7);
  EXPECT_EQ(p_value(13), 1.0);
}

PairedComparison comparison(double p_value, int pairs = 25) {
  return {.pairs = pairs, .p_value = p_value, .verdict = Verdict::smaller};
}

std::vector<bool> judged(std::vector<PairedComparison> comparisons) {
  std::vector<PairedComparison*> all;
  for (PairedComparison& one : comparisons) all.push_back(&one);
  judge_together(all, 0.95);
  std::vector<bool> holds;
  for (const PairedComparison& one : comparisons) holds.push_back(one.verdict == Verdict::smaller);
  return holds;
}

TEST(JudgeTogether, IsHolms) {
  EXPECT_EQ(judged({comparison(0.024), comparison(0.012), comparison(0.049), comparison(0.013)}),
            (std::vector{true, true, true, true}));  // up to 0.05 / 4, / 3, / 2 and / 1
  EXPECT_EQ(judged({comparison(0.026), comparison(0.012), comparison(0.026), comparison(0.013)}),
            (std::vector{false, true, false, true}));
  // After the first that fails nothing holds.
  EXPECT_EQ(judged({comparison(0.013), comparison(0.014), comparison(0.015), comparison(0.016)}),
            (std::vector{false, false, false, false}));
}

// Five pairs have p >= 2 / 2^5, whatever they show; where nothing was searched nothing can be
// shown.
TEST(JudgeTogether, CountsWhatCouldHaveAVerdict) {
  std::vector<PairedComparison> comparisons = {comparison(0.03)};
  comparisons.resize(20, comparison(0.0625, 5));
  EXPECT_TRUE(judged(comparisons).front());
  PairedComparison at_once = comparison(1.0);
  at_once.verdict = Verdict::nothing_searched;
  comparisons.resize(40, at_once);
  EXPECT_TRUE(judged(comparisons).front());
  comparisons.push_back(comparison(0.9));
  EXPECT_FALSE(judged(comparisons).front());
}

// A comparison of eight tables with nothing but chance between them and Euclid, in nine scenarios;
// four tables share a twin.
bool is_one_confirmed_by_chance(Rng& rng) {
  constexpr int scenarios = 9, tables = 8, pairs = 40;
  std::vector<PairedComparison> comparisons;
  std::vector<double> table(pairs), twin(pairs);
  for (int i = 0; i < scenarios * tables; ++i) {
    for (double& value : table) value = uniform(1.0, 2.0, rng);
    if (i % 4 == 0)
      for (double& value : twin) value = uniform(1.0, 2.0, rng);
    comparisons.push_back(compare_pairs(table, twin, 0.95));
  }
  std::vector<PairedComparison*> all;
  for (PairedComparison& one : comparisons) all.push_back(&one);
  judge_together(all, 0.95);
  return std::ranges::any_of(
      comparisons, [](const PairedComparison& one) { return one.verdict == Verdict::smaller; });
}

TEST(JudgeTogether, ConfirmsByChanceInAtMostOneReportOfTwenty) {
  Rng rng(4);
  constexpr int reports = 1000;
  int confirmed = 0;
  for (int i = 0; i < reports; ++i) confirmed += is_one_confirmed_by_chance(rng);
  EXPECT_LE(confirmed, reports / 20);  // B(1000, 0.025) exceeds it once in a million
}

TEST(PairedComparison, OfNothingSaysNothing) {
  EXPECT_EQ(compare_pairs({}, {}, 0.95).pairs, 0);
  EXPECT_EQ(compare_pairs({}, {}, 0.95).verdict, Verdict::no_difference);
}

}  // namespace
}  // namespace vandplan::evaluation
