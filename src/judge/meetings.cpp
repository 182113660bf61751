// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "judge/meetings.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "judge/polygon_tree.h"

namespace vandplan::judge {
namespace {

constexpr double look_at_most = 1e-3;  // distance that may be missed between two looks [m]
constexpr double look_share = 0.05;    // share of the distance that may be missed between two looks
constexpr double infinity_of_distance = std::numeric_limits<double>::infinity();

/// State of a moving obstacle, with bounds that hold for some time.
struct Whereabouts {
  bool is_there = true;
  Position position;
  Real speed = 0;   // largest speed of any point of the outline, growth included [m/s]
  Real growth = 0;  // growth of the outline so far [m]
  Real until = 0;   // end of the span in which `speed` holds [s]
};

Position position_of(const Pose& pose) { return {pose.x, pose.y, pose.heading}; }

class Neighbour {
 public:
  explicit Neighbour(const MovingObstacle& obstacle)
      : obstacle_(obstacle), tree_({&obstacle.outline, 1}) {
    for (const Point& corner : obstacle.outline) {
      reach_ = std::max<Real>(reach_, std::hypot(corner.x, corner.y));
    }
  }

  /// State of the obstacle at time `t` [s]. After the last row of its trajectory it does not
  /// change.
  [[nodiscard]] Whereabouts at(Real t) const {
    const auto& rows = obstacle_.trajectory;
    const Real last = rows.back().t;
    const Real grows = t < last ? obstacle_.inflate : 0;
    const Real growth = obstacle_.inflate * std::clamp<Real>(t, 0, std::max<Real>(last, 0));
    if (t >= last) {
      const bool is_there = obstacle_.after == Afterwards::stays || t == last;
      return {is_there, position_of(rows.back().pose), 0, growth, infinity_of_distance};
    }
    if (t < rows[0].t) return {true, position_of(rows[0].pose), grows, growth, rows[0].t};
    std::size_t i = 0;
    while (rows[i + 1].t <= t) ++i;
    const Position from = position_of(rows[i].pose);
    const Position to = position_of(rows[i + 1].pose);
    const Real lasts = static_cast<Real>(rows[i + 1].t) - rows[i].t;
    const Real share = (t - rows[i].t) / lasts;
    const Real turn = std::remainder(to.heading - from.heading, full_turn);
    const Real way = std::hypot(to.x - from.x, to.y - from.y);
    return {true,
            {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y),
             from.heading + share * turn},
            (way + std::abs(turn) * reach_) / lasts + grows,
            growth,
            rows[i + 1].t};
  }

  /// Distance of a vehicle's body from the outline [m], computed in the outline's frame.
  [[nodiscard]] double distance(const Position& vehicle, const Position& own,
                                const Outline& body) const {
    const Real cos = std::cos(own.heading);
    const Real sin = std::sin(own.heading);
    const Real dx = vehicle.x - own.x;
    const Real dy = vehicle.y - own.y;
    const Position seen{cos * dx + sin * dy, cos * dy - sin * dx, vehicle.heading - own.heading};
    Effort effort;
    return tree_.clearance(view_of({seen}), body, infinity_of_distance, effort);
  }

 private:
  const MovingObstacle& obstacle_;
  PolygonTree tree_;
  Real reach_ = 0;
};

}  // namespace

Company company_on(const Driver& driver, std::span<const MovingObstacle> moving, Real end,
                   double kept) {
  Company company{infinity_of_distance, {}};
  for (std::size_t i = 0; i < moving.size(); ++i) {
    const Neighbour neighbour(moving[i]);
    const Real rest = std::max<Real>(end, moving[i].trajectory.back().t);
    Real t = 0;
    while (true) {
      const Moment moment = driver.where(t);
      const Whereabouts other = neighbour.at(t);
      if (!other.is_there) break;
      const auto distance = static_cast<double>(std::max<Real>(
          neighbour.distance(moment.position, other.position, driver.body) - other.growth, 0));
      company.clearance = std::min(company.clearance, distance);
      const bool is_near = distance < kept || distance == 0;
      if (is_near && (!company.too_near || t < company.too_near->t)) {
        company.too_near = Encounter{i, t, distance};
      }
      if (is_near || t >= rest) break;
      // The next look is due before the distance can fall by `safe`, or a bound of speed ends.
      const Real speed = moment.speed * driver.swing + other.speed;
      const double beyond = std::max(distance - company.clearance, 0.0) + look_share * distance;
      const Real safe = std::min(beyond, distance - kept) + look_at_most;
      const Real next = speed > 0 ? t + safe / speed : rest;
      t = std::min({std::max(next, std::nextafter(t, 2 * t + 1)), moment.until, other.until, rest});
    }
  }
  return company;
}

}  // namespace vandplan::judge
