// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "lab/committed_drive.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vandplan::lattice {
namespace {

constexpr double rounding = 1e-9;  // tolerance of lengths [m]

/// An exact piece from the committed part to the end of a leg of a given way.
struct Offer {
  double cost;      // length of the whole way without obstacles [m]
  std::size_t leg;  // leg at whose end the piece ends
};

bool is_same(const Leg& a, const Leg& b) {
  return a.node == b.node && a.end == b.end && a.piece.length == b.piece.length;
}

}  // namespace

CommittedDrive::CommittedDrive(const Task& task)
    : task_(task),
      braking_(task.vehicle.limits.max_braking.value_or(task.vehicle.limits.max_acceleration)) {}

bool CommittedDrive::agrees(const std::vector<Leg>& way) const {
  double s = 0.0;
  for (std::size_t i = 0; i < way_.size() && s < committed_; ++i) {
    if (i >= way.size() || !is_same(way_[i], way[i])) return false;
    s += way_[i].piece.length;
  }
  return true;
}

void CommittedDrive::follow(std::vector<Leg> way) { way_ = std::move(way); }

// Distance at which the vehicle stops next [m]: end of the committed part, or a gear change.
double CommittedDrive::next_stop() const {
  double s = 0.0;
  GearSign gear = 0;
  for (const Leg& leg : way_) {
    for (const Segment& segment : leg.piece.view()) {
      if (s >= committed_) return committed_;
      if (gear_of(segment) == -gear && s > driven_ + rounding) return s;
      gear = gear_of(segment);
      s += std::abs(segment.length);
    }
  }
  return committed_;
}

// Largest speed on full lock, in the gear that is driven next [m/s].
double CommittedDrive::top_speed() const {
  double s = 0.0;
  GearSign gear = 1;
  for (const Leg& leg : way_) {
    for (const Segment& segment : leg.piece.view()) {
      if (s > driven_ + rounding) break;
      gear = gear_of(segment);
      s += std::abs(segment.length);
    }
  }
  const DrivingLimits& limits = task_.vehicle.limits;
  const double in_turn =
      std::sqrt(limits.max_lateral_acceleration * task_.vehicle.min_turning_radius);
  return std::min(in_turn, gear > 0 ? limits.max_speed.forward : limits.max_speed.reverse);
}

void CommittedDrive::commit(double time) {
  const double speed = speed_ + task_.vehicle.limits.max_acceleration * time;
  const double wanted = driven_ + speed * time + speed * speed / (2 * braking_);
  committed_ = std::max(committed_, std::min(length_of(way_), wanted));
}

// The new speed is the largest from which the vehicle can still stop in time.
void CommittedDrive::drive(double time) {
  const double stop = next_stop();
  const double room = stop - driven_ - speed_ * time / 2;
  const double root = time * time / 4 + 2 * room / braking_;
  const double can = root > 0.0 ? braking_ * (std::sqrt(root) - time / 2) : 0.0;
  const double wish = std::min(speed_ + task_.vehicle.limits.max_acceleration * time, top_speed());
  const double speed = std::max({0.0, std::min(can, wish), speed_ - braking_ * time});
  const double before = std::exchange(speed_, speed);
  driven_ = std::min(stop, driven_ + (before + speed) / 2 * time);
  if (stop - driven_ > 1e-6) return;
  driven_ = stop;
  speed_ = 0.0;
  const bool is_end =
      !way_.empty() && committed_ >= length_of(way_) - rounding && way_.back().end == task_.goal;
  if (before > 0.0 && stop == committed_ && !is_end) ++forced_stops_;
}

bool CommittedDrive::can_stop() const {
  return driven_ + speed_ * speed_ / (2 * braking_) <= next_stop() + 1e-6;
}

std::vector<Leg> CommittedDrive::committed_part() const {
  std::vector<Leg> part;
  LocalPose begin = task_.start;
  double left = committed_;
  for (const Leg& leg : way_) {
    if (left <= rounding) break;
    if (leg.piece.length <= left) {
      part.push_back(leg);
    } else {
      const Piece piece = prefix(leg.piece, left);
      part.push_back({piece, end_of(begin, piece), -2});
    }
    left -= leg.piece.length;
    begin = leg.end;
  }
  return part;
}

std::optional<std::vector<Leg>> CommittedDrive::joined(const std::vector<Leg>& way, double cutoff,
                                                       Connector& connector) const {
  if (agrees(way)) return length_of(way) < cutoff ? std::optional(way) : std::nullopt;
  std::vector<Leg> result = committed_part();
  const std::vector<Leg> bound = result;
  std::size_t parting = 0;  // number of equal first legs
  while (parting < bound.size() && parting < way.size() && is_same(bound[parting], way[parting])) {
    ++parting;
  }
  // Back to where both ways part. The way back is free, because the committed part is.
  for (std::size_t i = bound.size(); i-- > parting;) {
    const LocalPose begin = i == 0 ? task_.start : bound[i - 1].end;
    result.push_back({reversed(bound[i].piece), begin, -2});
  }
  result.insert(result.end(), way.begin() + static_cast<std::ptrdiff_t>(parting), way.end());
  double best = length_of(result);
  std::vector<Offer> offers;  // exact pieces to places on `way`
  const LocalPose here = bound.empty() ? task_.start : bound.back().end;
  double rest = 0.0;
  for (std::size_t i = way.size(); i-- > parting;) {
    const double least = connector.least_cost(here, way[i].end);
    offers.push_back({length_of(bound) + least + rest, i});
    rest += way[i].piece.length;
  }
  std::ranges::sort(offers, {}, &Offer::cost);
  for (const Offer& offer : offers) {
    if (offer.cost >= std::min(best, cutoff)) break;
    const std::optional<Connection> piece = connector.connect(here, way[offer.leg].end);
    if (!piece) continue;
    result = bound;
    result.push_back({piece->piece, way[offer.leg].end, -2});
    result.insert(result.end(), way.begin() + static_cast<std::ptrdiff_t>(offer.leg) + 1,
                  way.end());
    best = offer.cost;
    break;
  }
  return best < cutoff ? std::optional(std::move(result)) : std::nullopt;
}

}  // namespace vandplan::lattice
