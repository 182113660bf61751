// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "planners/anytime/lattice.h"
#include "planners/anytime/shorten.h"
#include "planners/anytime/sources.h"
#include "search/grid_distance.h"
#include "search/wheels.h"
#include "vandplan/random.h"

namespace vandplan::anytime {
namespace {

constexpr double least_stretch = 2.0;  // least length of a stretch [turning radii]
/// Searches, one of which is chosen at random.
constexpr std::array<LatticeOptions, 4> detour_searches = {
    LatticeOptions{24, 0.25, 1.5}, LatticeOptions{24, 0.25, 1.2}, LatticeOptions{36, 0.17, 1.2},
    LatticeOptions{48, 0.125, 1.5}};
constexpr std::int64_t expansions = 512;  // expansions of one search
constexpr double max_stretch = 60.0;      // largest length of a stretch [turning radii]

// Box around the ellipse with foci `a` and `b` that paths of at most `length` between them do not
// leave.
Bounds ellipse_box(const LocalPose& a, const LocalPose& b, double length, const Bounds& scene) {
  const double dx = std::abs(a.x - b.x), dy = std::abs(a.y - b.y);
  const double apart = std::hypot(dx, dy);
  const double minor = std::sqrt(std::max(length * length - apart * apart, 0.0)) / 2;
  const double share = apart > 0 ? dx / apart : 0.0;
  const double along = apart > 0 ? dy / apart : 0.0;
  const double x = std::hypot(share * length / 2, along * minor);
  const double y = std::hypot(along * length / 2, share * minor);
  const Point m{(a.x + b.x) / 2, (a.y + b.y) / 2};
  // The foci are inside although a route may leave the scene.
  return {std::min({std::max(scene.x_min, m.x - x), a.x, b.x}),
          std::max({std::min(scene.x_max, m.x + x), a.x, b.x}),
          std::min({std::max(scene.y_min, m.y - y), a.y, b.y}),
          std::max({std::min(scene.y_max, m.y + y), a.y, b.y})};
}

class Detours final : public Source {
 public:
  Detours(const Task& task, const CostRule& rule, std::uint64_t seed)
      : task_(task), rule_(rule), scene_(sampling_region(task, Region::scene)), rng_(seed) {}

  void set_route(const Route& route) override;
  [[nodiscard]] bool step() override;
  [[nodiscard]] Route route() const override { return found_; }
  [[nodiscard]] Counts counts() const override;

 private:
  void choose();
  void begin();
  void end();
  void make_guide(const LocalPose& root, const LocalPose& target);
  [[nodiscard]] bool is_hopeless() const;
  bool search();
  void put_in_place(const Route& way);
  bool patch();

  const Task& task_;
  CostRule rule_;
  Bounds scene_;
  Rng rng_;
  Route base_;              // best route
  Route before_, after_;    // parts of the route that stay
  Route old_;               // stretch that is to be replaced
  bool backwards_ = false;  // whether the search begins at the end of the stretch
  DrivenBeside beside_;     // gears beside the stretch, in the direction of the search
  std::optional<Connector> connector_;
  std::optional<GridDistance> guide_;
  bool guided_ = false;  // whether the guide is complete
  LatticeOptions options_;
  std::optional<Lattice> lattice_;
  std::int64_t left_ = 0;           // expansions left for this search
  std::optional<Shortener> patch_;  // shortens a result of the search
  int trials_ = 0;                  // trials of shortening it
  Route found_;
  Counts former_;  // counts of earlier searches
};

void Detours::set_route(const Route& route) {
  base_ = route;
  if (guide_) end();
}

Counts Detours::counts() const {
  Counts counts = former_;
  if (connector_) counts += counts_of(*connector_);
  if (lattice_) counts.nodes = lattice_->size();
  return counts;
}

// Chooses a random stretch. Short and long stretches are equally frequent; those at the ends of the
// route are more frequent.
void Detours::choose() {
  const double whole = base_.length();
  const double least = std::min(whole, least_stretch * task_.vehicle.min_turning_radius);
  const double most = std::min(whole, max_stretch * task_.vehicle.min_turning_radius);
  const double length = least * std::pow(most / least, uniform01(rng_));
  const double middle = uniform(0.0, whole, rng_);
  double begin = nearest_cut(task_, base_, std::max(middle - length / 2, 0.0));
  double end = nearest_cut(task_, base_, middle + length / 2 < whole ? middle + length / 2 : whole);
  old_ = part_of(base_, begin, end);
  if (old_.legs.empty()) {  // both cuts are the same but for rounding
    begin = 0.0;
    end = whole;
    old_ = part_of(base_, begin, end);
  }
  before_ = part_of(base_, 0.0, begin);
  after_ = part_of(base_, end, whole);
  backwards_ = uniform01(rng_) < 0.5;
  options_ = detour_searches[rng_() % detour_searches.size()];
  left_ = expansions;
}

void Detours::begin() {
  choose();
  CostRule rule = rule_;
  beside_ = driven_at_ends(task_, rule_.initial_gear);
  if (!before_.legs.empty()) beside_.before = last_driven(before_.legs.back().piece);
  if (!after_.legs.empty()) beside_.after = first_driven(after_.legs.front().piece);
  rule.initial_gear = beside_.before.gear;
  if (!after_.legs.empty()) rule.final_gear = 0;
  price(Connector(task_, rule), old_);
  const LocalPose& first = old_.start;
  const LocalPose& last = old_.legs.back().end;
  if (backwards_) {
    std::swap(beside_.before, beside_.after);
    beside_.before.gear *= -1;
    beside_.after.gear *= -1;
    rule = reversed(rule_, beside_.before.gear);
  }
  beside_ = fitted_driven(task_, beside_);
  connector_.emplace(task_, rule);
  make_guide(backwards_ ? last : first, backwards_ ? first : last);
}

void Detours::make_guide(const LocalPose& root, const LocalPose& target) {
  const Bounds box = ellipse_box(root, target, worth_shortening * old_.cost, scene_);
  guide_.emplace(
      task_, box, target, root,
      GridDistance::Options{.side = fine_guide_side * task_.vehicle.width, .detour = 1.0});
  guided_ = false;
}

void Detours::end() {
  former_ += counts_of(*connector_);
  patch_.reset();
  lattice_.reset();
  guide_.reset();
  connector_.reset();
}

// Puts a way, which has the direction of the search, in the place of the stretch.
void Detours::put_in_place(const Route& way) {
  const Route stretch = backwards_ ? reversed(way) : way;
  found_ = before_;
  found_.append(stretch.legs);
  found_.append(after_.legs);
  price(Connector(task_, rule_), found_);
}

// Whether a shorter path is unlikely: the way on the grid is much longer than the stretch, or there
// is none.
bool Detours::is_hopeless() const {
  const LocalPose& root = backwards_ ? old_.legs.back().end : old_.start;
  return !guide_->is_connected() || guide_->at(root.x, root.y) > worth_shortening * old_.cost;
}

// One trial to shorten the found way. A way that is cheaper than the stretch takes the place of the
// stretch. True if the whole route got cheaper.
bool Detours::patch() {
  patch_->step();
  ++trials_;
  if (patch_->cost() > old_.cost * (1 - progress)) {
    const double excess = patch_->cost() / old_.cost - 1.0;
    if (patch_->is_stalled() || excess * trials_ > hopeless) end();
    return false;
  }
  put_in_place(patch_->route());
  end();
  if (found_.cost >= base_.cost) return false;
  base_ = found_;
  return true;
}

// Expands one pose, settles some cells of a grid, or shortens a result; needs a route.
bool Detours::step() {
  if (!guide_) begin();
  if (!guided_) {
    guided_ = !guide_->step();
    if (guided_ && is_hopeless()) end();
    return false;
  }
  return patch_ ? patch() : search();
}

bool Detours::search() {
  if (!lattice_) {
    const LocalPose& first = old_.start;
    const LocalPose& last = old_.legs.back().end;
    lattice_.emplace(backwards_ ? last : first, backwards_ ? first : last, beside_, options_,
                     *guide_, *connector_);
    lattice_->set_cutoff(worth_shortening * old_.cost);
  }
  if (left_-- == 0 || lattice_->is_exhausted()) {
    end();
    return false;
  }
  if (!lattice_->step()) return false;
  patch_.emplace(*connector_, lattice_->route(), rng_(), std::function<double(const Route&)>(),
                 beside_);
  trials_ = 0;
  return false;
}

}  // namespace

std::unique_ptr<Source> detours(const Task& task, const CostRule& rule, std::uint64_t seed) {
  return std::make_unique<Detours>(task, rule, seed);
}

}  // namespace vandplan::anytime
