// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How long does the fastest drive take when the acceleration may not jump?
//
// A numerical optimum over the squared speed u at many places of each stretch between two stops.
// The acceleration between two places is half the slope of u, and it changes from one way to the
// next by no more than the jerk times the time between their middles. The duration is least under
// all limits by an interior-point method: Newton's method on the duration less mu times the
// logarithms of what is left to each limit, for smaller and smaller mu. It shares nothing with the
// library but the path, and knows neither humps nor ramps. What it finds is a local optimum of the
// problem on the grid: no bound from below, but a measure of what can be saved. On a line, where
// the optimum has seven phases, it is 0.03 % too fast with 400 places, and twice that with half of
// them.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "support/drive_oracle.h"

namespace vandplan {

/// One stretch from stop to stop on a grid.
class JerkOptimum {
 public:
  /// `s` increases, `cap` is the square of the largest speed at these places.
  JerkOptimum(std::vector<double> s, std::vector<double> cap, const DrivingLimits& limits)
      : s_(std::move(s)),
        cap_(std::move(cap)),
        gain_(limits.max_acceleration),
        loss_(limits.max_braking.value_or(limits.max_acceleration)),
        jerk_(*limits.max_jerk) {
    // From standing with full jerk s = j t^3 / 6 and v = j t^2 / 2.
    const auto from_rest = [&](double way) {
      return jerk_ * jerk_ / 4 * std::pow(6 * way / jerk_, 4.0 / 3);
    };
    const std::size_t last = s_.size() - 1;
    cap_[1] = std::min(cap_[1], from_rest(s_[1] - s_[0]));
    cap_[last - 1] = std::min(cap_[last - 1], from_rest(s_[last] - s_[last - 1]));
  }

  [[nodiscard]] double duration() {
    start();
    const double constraints = 5.0 * static_cast<double>(s_.size());
    double mu = duration_of(u_) / constraints;
    const double least = 1e-5 * mu;
    for (; mu > least; mu *= 0.3) {
      for (int i = 0; i < 60 && improve(mu); ++i) {
      }
    }
    return duration_of(u_);
  }

 private:
  /// What Newton's method needs: gradient, and the three upper diagonals of the curvature.
  struct Model {
    std::vector<double> gradient;
    std::array<std::vector<double>, 3> diagonals;
  };

  [[nodiscard]] std::size_t last() const { return s_.size() - 1; }
  [[nodiscard]] double width(std::size_t i) const { return s_[i + 1] - s_[i]; }

  /// A slow drive: any drive gets within the limits when all of it is slowed down.
  void start() {
    u_.assign(s_.size(), 0.0);
    const double length = s_.back() - s_.front();
    for (std::size_t i = 1; i < last(); ++i) {
      const double share = (s_[i] - s_.front()) / length;
      u_[i] = std::pow(share * (1 - share), 4.0 / 3);
    }
    while (!(value(u_, 1.0) < infinite)) {
      for (double& u : u_) u *= 0.5;
    }
    for (double& u : u_) u *= 0.8;
  }

  /// How long the way from one place to the next takes, and its slope by u at either.
  struct Time {
    double t, first, last;
  };
  [[nodiscard]] Time time(const std::vector<double>& u, std::size_t i) const {
    const double h = width(i);
    const double a = std::sqrt(u[i]), b = std::sqrt(u[i + 1]), both = a + b;
    // From standing s = j t^3 / 6 and v = j t^2 / 2.
    if (i == 0) return {3 * h / b, 0.0, -1.5 * h / (b * b * b)};
    if (i + 1 == last()) return {3 * h / a, -1.5 * h / (a * a * a), 0.0};
    return {2 * h / both, -h / (both * both * a), -h / (both * both * b)};
  }

  [[nodiscard]] double duration_of(const std::vector<double>& u) const {
    double t = 0;
    for (std::size_t i = 0; i < last(); ++i) t += time(u, i).t;
    return t;
  }

  /// The change of the acceleration around a place as a share of the largest one.
  [[nodiscard]] double share_of_jerk(const std::vector<double>& u, std::size_t i) const {
    const double change =
        (u[i + 1] - u[i]) / (2 * width(i)) - (u[i] - u[i - 1]) / (2 * width(i - 1));
    return change / (jerk_ * (time(u, i - 1).t + time(u, i).t) / 2);
  }

  /// Duration and barrier; infinite outside the limits.
  [[nodiscard]] double value(const std::vector<double>& u, double mu) const {
    double product = 1, logarithms = 0;
    bool is_inside = true;
    const auto keep = [&](double left) {
      is_inside = is_inside && left > 0;
      product *= left;
      if (product < 1e-100 || product > 1e100) {
        logarithms += std::log(product);
        product = 1;
      }
    };
    for (std::size_t i = 1; i < last() && is_inside; ++i) {
      keep(1 - u[i] / cap_[i]);
      is_inside = is_inside && u[i] > 0;
      const double share = share_of_jerk(u, i);
      keep(1 - share);
      keep(1 + share);
      keep(1 - (u[i + 1] - u[i]) / (2 * width(i) * gain_));
      keep(1 + (u[i + 1] - u[i]) / (2 * width(i) * loss_));
    }
    if (!is_inside) return infinite;
    return duration_of(u) - mu * (logarithms + std::log(product));
  }

  /// One step of Newton's method; false if there is nothing left to gain.
  [[nodiscard]] bool improve(double mu) {
    Model model = modelled(mu);
    const std::vector<double> step = solved(model);
    double gain = 0;
    for (std::size_t i = 1; i < last(); ++i) gain += step[i] * model.gradient[i];
    if (!(-gain > 0.1 * mu)) return false;
    const double before = value(u_, mu);
    std::vector<double> next(u_.size());
    for (double part = 1; part > 1e-9; part /= 2) {
      for (std::size_t i = 0; i < u_.size(); ++i) next[i] = u_[i] + part * step[i];
      if (value(next, mu) <= before + 0.1 * part * gain) {
        u_.swap(next);
        return true;
      }
    }
    return false;
  }

  [[nodiscard]] Model modelled(double mu) const {
    const std::size_t n = s_.size();
    Model m{std::vector<double>(n), {}};
    for (auto& diagonal : m.diagonals) diagonal.assign(n, 0.0);
    const auto& u = u_;
    // A barrier -mu log(left), of which `left` changes with u[at], u[at + 1], ... by `slope`.
    const auto add = [&](double left, std::size_t at, const std::array<double, 3>& slope) {
      for (std::size_t i = 0; i < 3 && at + i < n; ++i) {
        m.gradient[at + i] -= mu * slope[i] / left;
        for (std::size_t j = i; j < 3 && at + j < n; ++j) {
          m.diagonals[j - i][at + i] += mu * slope[i] * slope[j] / (left * left);
        }
      }
    };
    for (std::size_t i = 1; i < last(); ++i) {
      add(1 - u[i] / cap_[i], i, {-1 / cap_[i], 0, 0});
      const double up = 1 / (2 * width(i) * gain_);
      const double down = 1 / (2 * width(i) * loss_);
      add(1 - (u[i + 1] - u[i]) * up, i, {up, -up, 0});
      add(1 + (u[i + 1] - u[i]) * down, i, {-down, down, 0});
      // The jerk; its second derivatives are left out, so that the model stays convex.
      const double most = jerk_ * (time(u, i - 1).t + time(u, i).t) / 2;
      const double share = share_of_jerk(u, i);
      const double before = 1 / (2 * width(i - 1) * most), after = 1 / (2 * width(i) * most);
      const double part = share * jerk_ / (2 * most);
      const std::array<double, 3> slope = {
          before - part * time(u, i - 1).first,
          -before - after - part * (time(u, i - 1).last + time(u, i).first),
          after - part * time(u, i).last};
      add(1 - share, i - 1, {-slope[0], -slope[1], -slope[2]});
      add(1 + share, i - 1, slope);
    }
    add_duration(m);
    return m;
  }

  void add_duration(Model& m) const {
    for (std::size_t i = 0; i < last(); ++i) {
      const Time way = time(u_, i);
      m.gradient[i] += way.first;
      m.gradient[i + 1] += way.last;
      const double a = std::sqrt(u_[i]), b = std::sqrt(u_[i + 1]), both = a + b;
      if (i == 0) {
        m.diagonals[0][i + 1] -= 1.5 * way.last / u_[i + 1];
      } else if (i + 1 == last()) {
        m.diagonals[0][i] -= 1.5 * way.first / u_[i];
      } else {
        m.diagonals[0][i] -= way.first * (1 / (both * a) + 1 / (2 * a * a));
        m.diagonals[0][i + 1] -= way.last * (1 / (both * b) + 1 / (2 * b * b));
        m.diagonals[1][i] -= way.first / (both * b);
      }
    }
  }

  /// The step to the least of the model: Cholesky's method for five diagonals.
  [[nodiscard]] std::vector<double> solved(const Model& m) const {
    const std::size_t n = s_.size();
    std::vector<double> d(n), below(n), second(n), step(n);
    for (std::size_t i = 1; i < last(); ++i) {
      // Row i of the factor: second[i], below[i], 1.
      double e = i > 1 ? m.diagonals[1][i - 1] : 0;
      const double f = i > 2 ? m.diagonals[2][i - 2] : 0;
      second[i] = i > 2 ? f / d[i - 2] : 0;
      if (i > 2) e -= second[i] * below[i - 1] * d[i - 2];
      below[i] = i > 1 ? e / d[i - 1] : 0;
      d[i] = m.diagonals[0][i];
      if (i > 1) d[i] -= below[i] * below[i] * d[i - 1];
      if (i > 2) d[i] -= second[i] * second[i] * d[i - 2];
      step[i] = -m.gradient[i];
      if (i > 1) step[i] -= below[i] * step[i - 1];
      if (i > 2) step[i] -= second[i] * step[i - 2];
    }
    for (std::size_t i = last() - 1; i >= 1; --i) {
      step[i] /= d[i];
      if (i + 1 < last()) step[i] -= below[i + 1] * step[i + 1];
      if (i + 2 < last()) step[i] -= second[i + 2] * step[i + 2];
    }
    return step;
  }

  static constexpr double infinite = std::numeric_limits<double>::infinity();

  std::vector<double> s_, cap_, u_;
  double gain_, loss_, jerk_;
};

/// How long the fastest drive with a limit of jerk takes [s], with about `count` places in each
/// stretch between two stops, denser where the vehicle is slow.
inline double dense_jerk_duration(const Path& path, const Vehicle& vehicle, int count) {
  const std::vector<Placed> all = placed(path);
  double t = 0;
  for (std::size_t first = 0, next = 0; first < all.size(); first = next) {
    next = first + 1;
    while (next < all.size() && !must_stand(all[next - 1], all[next], vehicle)) ++next;
    const double before = first == 0 ? 0 : all[first - 1].curvature(all[first - 1].end);
    const double turn = turn_between(before, all[first].segment.curvature, vehicle);
    if (turn > ignored_steering_jump) t += turn / vehicle.limits.max_steering_rate;
    const double begin = all[first].begin;
    const double length = all[next - 1].end - begin;
    // s grows with the cube of the time after a stop.
    const auto place = [&](double share) {
      const double there = share * share * share;
      const double left = (1 - share) * (1 - share) * (1 - share);
      return begin + length * (there / (there + left));
    };
    std::vector<double> s = {begin};
    std::vector<double> cap = {0.0};
    std::size_t at = first;
    for (int i = 1; i <= count; ++i) {
      const double x = i == count ? all[next - 1].end : place(1.0 * i / count);
      const double gap = x - place(1.0 * (i - 1) / count);
      while (at + 1 < next && all[at].end <= x) {  // a joint: both limits hold
        const double v = std::min(largest_speed(all[at], all[at].end, vehicle),
                                  largest_speed(all[at + 1], all[at].end, vehicle));
        ++at;
        if (s.size() > 1 && all[at].begin - s.back() < 0.3 * gap) {
          s.pop_back();
          cap.pop_back();
        }
        s.push_back(all[at].begin);
        cap.push_back(v * v);
      }
      if (x - s.back() < 0.3 * gap && i < count) continue;
      const double v = largest_speed(all[at], x, vehicle);
      s.push_back(x);
      cap.push_back(v * v);
    }
    t += JerkOptimum(std::move(s), std::move(cap), vehicle.limits).duration();
  }
  return t;
}

}  // namespace vandplan
