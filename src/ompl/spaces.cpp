// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/ompl_spaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "ompl/curves.h"
#include "vandplan/steering.h"

namespace vandplan::ompl {
namespace {

namespace ob = ::ompl::base;
using Se2 = ob::SE2StateSpace::StateType;
using ReedsShepp = ob::ReedsSheppStateSpace;
using Dubins = ob::DubinsStateSpace;

/// State of SE(2) in one allocation. OMPL's state allocates each part.
struct WholeState : Se2 {
  WholeState() {
    position.values = coordinates.data();
    components = parts.data();
  }
  std::array<double, 2> coordinates{};
  ob::RealVectorStateSpace::StateType position;
  ob::SO2StateSpace::StateType heading;
  std::array<ob::State*, 2> parts{&position, &heading};
};

/// Where `distance` of a state from itself stores the space, while `space_behind` asks for it.
thread_local const ReedsSheppStateSpace** asked_space = nullptr;

/// Pose after `driven` metres of the segments.
Pose after(Pose pose, std::span<const Segment> segments, double driven) noexcept {
  for (const Segment& segment : segments) {
    const double part = std::min(driven, std::abs(segment.length));
    if (part <= 0.0) continue;
    pose = advance(pose, {segment.curvature, std::copysign(part, segment.length)});
    driven -= part;
  }
  return pose;
}

/// Direction of a segment: 1 left, 0 straight, -1 right. Segments of type "none" have length 0.
int turn_of(ReedsShepp::ReedsSheppPathSegmentType type) {
  return type == ReedsShepp::RS_LEFT ? 1 : type == ReedsShepp::RS_RIGHT ? -1 : 0;
}
int turn_of(Dubins::DubinsPathSegmentType type) {
  return type == Dubins::DUBINS_LEFT ? 1 : type == Dubins::DUBINS_RIGHT ? -1 : 0;
}
int turn_of(const Segment& segment) {
  return segment.curvature > 0.0 ? 1 : segment.curvature < 0.0 ? -1 : 0;
}

/// Lengths of the segments of OMPL's word in turning radii, if the piece is that word without
/// segments of length 0. Otherwise false.
template <typename Types, std::size_t Count>
bool fill(const Types& word, const Piece& piece, double radius,
          std::array<double, Count>& lengths) {
  lengths.fill(0.0);
  std::size_t taken = 0;
  for (std::size_t i = 0; i < Count && taken < piece.count; ++i) {
    const Segment& segment = piece.segments[taken];
    if (turn_of(word[i]) != turn_of(segment)) continue;
    lengths[i] = segment.length / radius;
    ++taken;
  }
  return taken == piece.count;
}

/// Segments of an OMPL path.
template <typename Path, std::size_t Count>
std::array<Segment, Count> segments_of(const Path& path, double radius) {
  std::array<Segment, Count> segments;
  for (std::size_t i = 0; i < Count; ++i) {
    segments[i] = {turn_of(path.type_[i]) / radius, path.length_[i] * radius};
  }
  return segments;
}

/// Whether `t` is at an end; then copies the state of that end.
bool is_end(const ob::StateSpace& space, const ob::State* from, const ob::State* to, double t,
            ob::State* state) {
  if (t > 0.0 && t < 1.0) return false;
  const ob::State* const end = t >= 1.0 ? to : from;
  if (end != state) space.copyState(state, end);
  return true;
}

}  // namespace

Pose pose_of(const ob::State* state) noexcept {
  const auto* const se2 = state->as<Se2>();
  return {se2->getX(), se2->getY(), se2->getYaw()};
}

void set_pose(ob::State* state, const Pose& pose) noexcept {
  auto* const se2 = state->as<Se2>();
  se2->setXY(pose.x, pose.y);
  se2->setYaw(wrap_angle(pose.heading));
}

const ReedsSheppStateSpace* space_behind(const std::function<void()>& ask) {
  const ReedsSheppStateSpace* found = nullptr;
  asked_space = &found;
  ask();
  asked_space = nullptr;
  return found;
}

// ---- Reeds-Shepp ----

ReedsSheppStateSpace::ReedsSheppStateSpace(double turning_radius) : ReedsShepp(turning_radius) {}

ob::State* ReedsSheppStateSpace::allocState() const { return new WholeState; }

void ReedsSheppStateSpace::freeState(State* state) const { delete static_cast<WholeState*>(state); }

double ReedsSheppStateSpace::distance(const State* from, const State* to) const {
  if (from == to) {
    if (asked_space != nullptr) *asked_space = this;
    return 0.0;
  }
  return reeds_shepp_length(pose_of(from), pose_of(to), rho_);
}

void ReedsSheppStateSpace::interpolate(const State* from, const State* to, double t,
                                       State* state) const {
  if (is_end(*this, from, to, t, state)) return;
  const Pose start = pose_of(from);
  const Piece piece = reeds_shepp(start, pose_of(to), rho_);
  set_pose(state, after(start, piece.view(), t * piece.length));
}

void ReedsSheppStateSpace::interpolate(const State* from, const State* to, double t,
                                       bool& first_time, ReedsSheppPath& path, State* state) const {
  if (first_time) {
    if (is_end(*this, from, to, t, state)) return;
    path = reedsShepp(from, to);
    first_time = false;
  }
  interpolate(from, path, t, state);
}

void ReedsSheppStateSpace::interpolate(const State* from, const ReedsSheppPath& path, double t,
                                       State* state) const {
  const auto segments = segments_of<ReedsSheppPath, 5>(path, rho_);
  set_pose(state, after(pose_of(from), segments, t * path.length() * rho_));
}

ReedsSheppStateSpace::ReedsSheppPath ReedsSheppStateSpace::reedsShepp(const State* from,
                                                                      const State* to) const {
  const Piece piece = reeds_shepp(pose_of(from), pose_of(to), rho_);
  std::array<double, 5> l{};
  const auto* const word = std::ranges::find_if(
      reedsSheppPathType, [&](const auto& types) { return fill(types, piece, rho_, l); });
  return {*word, l[0], l[1], l[2], l[3], l[4]};
}

// ---- Dubins ----

DubinsStateSpace::DubinsStateSpace(double turning_radius, bool is_symmetric)
    : Dubins(turning_radius, is_symmetric) {}

ob::State* DubinsStateSpace::allocState() const { return new WholeState; }

void DubinsStateSpace::freeState(State* state) const { delete static_cast<WholeState*>(state); }

double DubinsStateSpace::distance(const State* from, const State* to) const {
  const Pose start = pose_of(from);
  const Pose end = pose_of(to);
  const double there = dubins_length(start, end, rho_);
  return isSymmetric_ ? std::min(there, dubins_length(end, start, rho_)) : there;
}

void DubinsStateSpace::interpolate(const State* from, const State* to, double t,
                                   State* state) const {
  if (is_end(*this, from, to, t, state)) return;
  const Pose start = pose_of(from);
  const Pose end = pose_of(to);
  const Piece piece =
      isSymmetric_ ? symmetric_dubins(start, end, rho_) : vandplan::dubins(start, end, rho_);
  set_pose(state, after(start, piece.view(), t * piece.length));
}

void DubinsStateSpace::interpolate(const State* from, const State* to, double t, bool& first_time,
                                   DubinsPath& path, State* state) const {
  if (first_time) {
    if (is_end(*this, from, to, t, state)) return;
    const Pose start = pose_of(from);
    const Pose end = pose_of(to);
    const bool is_reversed = isSymmetric_ && is_shorter_back(start, end, rho_);
    path = is_reversed ? dubins(to, from) : dubins(from, to);
    path.reverse_ = is_reversed;
    first_time = false;
  }
  interpolate(from, path, t, state);
}

void DubinsStateSpace::interpolate(const State* from, const DubinsPath& path, double t,
                                   State* state) const {
  auto segments = segments_of<DubinsPath, 3>(path, rho_);
  if (path.reverse_) {
    std::ranges::reverse(segments);
    for (Segment& segment : segments) segment.length = -segment.length;
  }
  set_pose(state, after(pose_of(from), segments, t * path.length() * rho_));
}

DubinsStateSpace::DubinsPath DubinsStateSpace::dubins(const State* from, const State* to) const {
  const Piece piece = vandplan::dubins(pose_of(from), pose_of(to), rho_);
  std::array<double, 3> l{};
  const auto* const word = std::ranges::find_if(
      dubinsPathType, [&](const auto& types) { return fill(types, piece, rho_, l); });
  return {*word, l[0], l[1], l[2]};
}

}  // namespace vandplan::ompl
