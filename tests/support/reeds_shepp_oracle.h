// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How long is the shortest Reeds-Shepp path, computed as the paper does?
//
// Right because it is the paper's procedure and nothing else: in the frame of the first pose, every
// formula of section 8 for each of the symmetries of section 8, in extended precision; no mean
// frame, no region, no choice. Shares no code with the library.

#include <algorithm>
#include <cmath>
#include <limits>

#include "vandplan/geometry.h"

namespace vandplan::oracle {

using Real = long double;

constexpr Real pi = 3.14159265358979323846264338327950288L;
constexpr Real none = std::numeric_limits<Real>::infinity();

/// In [-pi, pi], as the paper's M.
inline Real m(Real angle) { return std::remainder(angle, 2 * pi); }

/// What rounding pushed over a border counts as on it; the answer is off by as little.
constexpr Real noise = 1e-15L;
inline bool forward(Real arc) { return arc >= -noise; }
inline bool backward(Real arc) { return arc <= noise; }

struct Goal {
  Real x, y, phi;
};

struct Polar {
  Real r, theta;
};

inline Polar polar(Real x, Real y) { return {std::hypot(x, y), std::atan2(y, x)}; }

inline Real formula_8_1(const Goal& g) {  // L+S+L+
  const auto [u, t] = polar(g.x - std::sin(g.phi), g.y - 1 + std::cos(g.phi));
  const Real v = m(g.phi - t);
  return forward(t) && forward(v) ? std::abs(t) + u + std::abs(v) : none;
}

inline Real formula_8_2(const Goal& g) {  // L+S+R+
  const auto [u1, t1] = polar(g.x + std::sin(g.phi), g.y - 1 - std::cos(g.phi));
  if (u1 < 2) return none;
  const Real u = std::sqrt((u1 - 2) * (u1 + 2));
  const Real t = m(t1 + std::atan2(Real{2}, u));
  const Real v = m(t - g.phi);
  return forward(t) && forward(v) ? std::abs(t) + u + std::abs(v) : none;
}

/// Formulas 8.3 (L+R-L+) and 8.4 (L+R-L-), with the signs that make them true of the path.
inline Real formulas_8_3_and_8_4(const Goal& g) {
  const auto [u1, theta] = polar(g.x - std::sin(g.phi), g.y - 1 + std::cos(g.phi));
  if (u1 > 4) return none;
  const Real u = 2 * std::asin(u1 / 4);
  const Real t = m(theta + u / 2 + pi - u);
  const Real v = m(g.phi - t - u);  // of L, either gear
  return forward(t) ? std::abs(t) + u + std::abs(v) : none;
}

struct Ends {
  Real tau, omega;
};

/// Section 8: the turns at both ends of four arcs whose inner ones are u and v.
inline Ends ends_of_four(Real u, Real v, Real xi, Real eta, Real phi) {
  const Real delta = m(u - v);
  const Real a = std::sin(u) - std::sin(delta);
  const Real b = std::cos(u) - std::cos(delta) - 1;
  const Real t1 = std::atan2(eta * a - xi * b, xi * a + eta * b);
  const Real t2 = 2 * (std::cos(delta) - std::cos(v) - std::cos(u)) + 3;
  const Real tau = t2 < 0 ? m(t1 + pi) : m(t1);
  return {tau, m(tau - u + v - phi)};
}

inline Real formula_8_7(const Goal& g) {  // L+R+L-R-
  const Real xi = g.x + std::sin(g.phi);
  const Real eta = g.y - 1 - std::cos(g.phi);
  const Real rho = (2 + std::hypot(xi, eta)) / 4;
  if (rho > 1) return none;
  const Real u = std::acos(rho);
  const auto [t, v] = ends_of_four(u, -u, xi, eta, g.phi);
  return forward(t) && backward(v) ? std::abs(t) + 2 * u + std::abs(v) : none;
}

inline Real formula_8_8(const Goal& g) {  // L+R-L-R+
  const Real xi = g.x + std::sin(g.phi);
  const Real eta = g.y - 1 - std::cos(g.phi);
  const Real rho = (20 - xi * xi - eta * eta) / 16;
  if (rho < 0 || rho > 1) return none;
  const Real u = -std::acos(rho);
  const auto [t, v] = ends_of_four(u, u, xi, eta, g.phi);
  return forward(t) && forward(v) ? std::abs(t) - 2 * u + std::abs(v) : none;
}

inline Real formula_8_9(const Goal& g) {  // L+R-(pi/2)S-L-
  const auto [rho, theta] = polar(g.x - std::sin(g.phi), g.y - 1 + std::cos(g.phi));
  if (rho < 2) return none;
  const Real r = std::sqrt((rho - 2) * (rho + 2));
  const Real u = 2 - r;
  const Real t = m(theta + std::atan2(r, Real{-2}));
  const Real v = m(g.phi - pi / 2 - t);
  return forward(t) && backward(u) && backward(v) ? std::abs(t) + pi / 2 - u + std::abs(v) : none;
}

inline Real formula_8_10(const Goal& g) {  // L+R-(pi/2)S-R-
  const auto [rho, theta] = polar(-(g.y - 1 - std::cos(g.phi)), g.x + std::sin(g.phi));
  if (rho < 2) return none;
  const Real t = theta;
  const Real u = 2 - rho;
  const Real v = m(t + pi / 2 - g.phi);
  return forward(t) && backward(u) && backward(v) ? std::abs(t) + pi / 2 - u + std::abs(v) : none;
}

inline Real formula_8_11(const Goal& g) {  // L+R-(pi/2)S-L-(pi/2)R+
  const Real xi = g.x + std::sin(g.phi);
  const Real eta = g.y - 1 - std::cos(g.phi);
  const Real rho = std::hypot(xi, eta);
  if (rho < 2) return none;
  const Real r = std::sqrt((rho - 2) * (rho + 2));
  const Real u = 4 - r;
  if (u > 0) return none;
  const Real t = m(std::atan2((4 - u) * xi - 2 * eta, -2 * xi + (u - 4) * eta));
  const Real v = m(t - g.phi);
  return forward(t) && forward(v) ? std::abs(t) + pi - u + std::abs(v) : none;
}

/// The least of all formulas for a goal and its images under time flip and reflection.
inline Real shortest_of_images(const Goal& g, bool backwards) {
  Real best = none;
  for (const int flip : {1, -1}) {
    for (const int mirror : {1, -1}) {
      const Goal image{static_cast<Real>(flip) * g.x, static_cast<Real>(mirror) * g.y,
                       static_cast<Real>(flip * mirror) * g.phi};
      best = std::min({best, formulas_8_3_and_8_4(image), formula_8_9(image), formula_8_10(image)});
      if (backwards) continue;
      best = std::min({best, formula_8_1(image), formula_8_2(image), formula_8_7(image),
                       formula_8_8(image), formula_8_11(image)});
    }
  }
  return best;
}

inline Real reeds_shepp_length(const Pose& from, const Pose& to, double radius) {
  const Real dx = (static_cast<Real>(to.x) - from.x) / radius;
  const Real dy = (static_cast<Real>(to.y) - from.y) / radius;
  const Real heading = from.heading;
  const Real sin = std::sin(heading);
  const Real cos = std::cos(heading);
  const Goal goal{dx * cos + dy * sin, dy * cos - dx * sin,
                  static_cast<Real>(to.heading) - from.heading};
  const Real s = std::sin(goal.phi);
  const Real c = std::cos(goal.phi);
  const Goal backwards{goal.x * c + goal.y * s, goal.x * s - goal.y * c, goal.phi};
  return radius * std::min(shortest_of_images(goal, false), shortest_of_images(backwards, true));
}

}  // namespace vandplan::oracle
