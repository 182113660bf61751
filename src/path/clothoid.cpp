// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "path/clothoid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "base/trigonometry.h"
#include "base/trigonometry_series.h"
#include "simd/turn_kernels.h"

namespace vandplan::path {
namespace {

/// Integral of the unit vector along the heading.
struct HeadingIntegral {
  double x = 0.0;
  double y = 0.0;

  HeadingIntegral& operator+=(const HeadingIntegral& other) {
    x += other.x;
    y += other.y;
    return *this;
  }
};

/// A clothoid driven forward from heading 0. A clothoid in reverse is mirrored into such a one.
struct Clothoid {
  double curvature;
  double rate;

  [[nodiscard]] double curvature_at(double t) const { return curvature + rate * t; }
  [[nodiscard]] double turn(double t) const { return t * (curvature + rate * t / 2); }
};

constexpr double most_panels = 256;   // more are wanted only where doubles resolve no heading
constexpr double enough_panels = 32;  // up to this number, the whole clothoid goes through panels
constexpr double panel_extent = 3;  // see `panels_of`; errors stay below 7e-16 of a panel's length
constexpr int terms = 16;           // terms of the series
constexpr double steepness = 128;   // curvature^2 / rate where the series begins

/// Number of panels for a stretch. Each panel is so short that its length times
/// (|curvature| + 4 sqrt(|rate|)) is at most `panel_extent`.
double panels_of(const Clothoid& clothoid, double begin, double end) {
  const double steepest =
      std::max(std::abs(clothoid.curvature_at(begin)), std::abs(clothoid.curvature_at(end)));
  const double extent = (end - begin) * (steepest + 4 * std::sqrt(std::abs(clothoid.rate)));
  const double count = std::ceil(extent / panel_extent);
  return count >= 1 ? count : 1;
}

/// Gauss-Legendre integration with eight nodes over each panel. Sines and cosines of some panels
/// are computed at once.
class Panels {
 public:
  explicit Panels(const Clothoid& clothoid) : clothoid_(clothoid) {}

  void add(double begin, double end) {
    const double middle = (begin + end) / 2;
    const double half = (end - begin) / 2;
    halves_[count_] = half;
    double* const turns = turns_.data() + count_ * simd::turns_of_batch;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      turns[2 * i] = clothoid_.turn(middle - half * nodes[i]);
      turns[2 * i + 1] = clothoid_.turn(middle + half * nodes[i]);
    }
    if (++count_ == most_at_once) flush();
  }

  [[nodiscard]] HeadingIntegral sum() {
    flush();
    return sum_;
  }

 private:
  static constexpr std::array<double, 4> nodes = {0x1.77ac94f3c7345p-3, 0x1.0d129583284b4p-1,
                                                  0x1.97e4ab249f41ep-1, 0x1.ebab1cb0acc67p-1};
  static constexpr std::array<double, 4> weights = {0x1.736360b199343p-2, 0x1.413c50a255615p-2,
                                                    0x1.c76fb531d2b96p-3, 0x1.9ea1d04ca0374p-4};
  static constexpr std::size_t most_at_once = 4;
  using Numbers = std::array<double, most_at_once * simd::turns_of_batch>;

  void flush() {
    if (count_ == 0) return;
    const std::span turns(turns_.data(), count_ * simd::turns_of_batch);
    Numbers sines, cosines;
    if (std::ranges::all_of(turns,
                            [](double t) { return std::abs(t) <= base::series::moderate; })) {
      simd::sines_and_cosines(turns, sines, cosines);
    } else {
      for (std::size_t i = 0; i < turns.size(); ++i) {
        const auto [sin, cos] = base::sin_cos(turns[i]);
        sines[i] = sin;
        cosines[i] = cos;
      }
    }
    for (std::size_t panel = 0; panel < count_; ++panel) {
      HeadingIntegral way;
      for (std::size_t i = 0; i < weights.size(); ++i) {
        const std::size_t at = panel * simd::turns_of_batch + 2 * i;
        way.x += weights[i] * (cosines[at] + cosines[at + 1]);
        way.y += weights[i] * (sines[at] + sines[at + 1]);
      }
      sum_ += {halves_[panel] * way.x, halves_[panel] * way.y};
    }
    count_ = 0;
  }

  const Clothoid& clothoid_;
  std::size_t count_ = 0;  // panels that wait for `flush`
  std::array<double, most_at_once> halves_;
  Numbers turns_;
  HeadingIntegral sum_;
};

HeadingIntegral over_panels(const Clothoid& clothoid, double begin, double end) {
  const double wanted = panels_of(clothoid, begin, end);
  const double count = wanted < most_panels ? wanted : most_panels;
  const double length = (end - begin) / count;
  Panels panels(clothoid);
  for (double i = 0; i < count; ++i) {
    panels.add(begin + i * length, i + 1 < count ? begin + (i + 1) * length : end);
  }
  return panels.sum();
}

/// Antiderivative by repeated integration by parts, where curvature^2 is large beside the rate.
HeadingIntegral antiderivative(const Clothoid& clothoid, double t) {
  const double curvature = clothoid.curvature_at(t);
  const double y = clothoid.rate / curvature / curvature;
  // The sum of (2n - 1)!! (-i y)^n.
  double re = 1, im = 0, sum_re = 1, sum_im = 0;
  for (int n = 1; n < terms; ++n) {
    const double factor = (2 * n - 1) * y;
    const double last = re;
    re = factor * im;
    im = -factor * last;
    sum_re += re;
    sum_im += im;
  }
  const auto [sin, cos] = base::sin_cos(clothoid.turn(t));
  return {(cos * sum_im + sin * sum_re) / curvature, (sin * sum_im - cos * sum_re) / curvature};
}

HeadingIntegral by_series(const Clothoid& clothoid, double begin, double end) {
  if (!(begin < end)) return {};
  const HeadingIntegral first = antiderivative(clothoid, begin);
  const HeadingIntegral last = antiderivative(clothoid, end);
  return {last.x - first.x, last.y - first.y};
}

HeadingIntegral along(const Clothoid& clothoid, double length) {
  if (panels_of(clothoid, 0, length) <= enough_panels) return over_panels(clothoid, 0, length);
  // Around the place of curvature 0 the vehicle turns little; elsewhere the series is good.
  const double rate = std::abs(clothoid.rate);
  const double inflection = -clothoid.curvature / clothoid.rate;
  const double reach = std::sqrt(steepness * rate) / rate;
  const double begin = std::clamp(inflection - reach, 0.0, length);
  const double end = std::clamp(inflection + reach, 0.0, length);
  HeadingIntegral sum = by_series(clothoid, 0, begin);
  if (begin < end) sum += over_panels(clothoid, begin, end);
  return sum += by_series(clothoid, end, length);
}

}  // namespace

Displacement along_clothoid(const Segment& segment) noexcept {
  const double gear = segment.length < 0.0 ? -1.0 : 1.0;
  const double length = std::abs(segment.length);
  const Clothoid clothoid{gear * segment.curvature, gear * segment.curvature_rate};
  const HeadingIntegral way = along(clothoid, length);
  return {gear * way.x, gear * way.y, clothoid.turn(length)};
}

}  // namespace vandplan::path
