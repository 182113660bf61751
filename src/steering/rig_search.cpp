// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "steering/rig_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <tuple>
#include <utility>

#include "base/trigonometry.h"
#include "steering/rig_guesses.h"
#include "steering/rig_shortlists.h"
#include "vandplan/steering.h"

namespace vandplan::steering {
namespace {

constexpr std::size_t guess_count = rig_guesses.size() + 8;

/// One of four tasks whose paths differ only in direction and side.
struct Image {
  RigEnds ends;
  bool is_backwards = false;
  bool is_mirrored = false;

  [[nodiscard]] std::tuple<double, double, double, double, double> key() const {
    return {ends.frame.x, ends.frame.y, ends.frame.half_turn, ends.start_u, ends.goal_u};
  }
};

Image backwards(const Image& image) {
  const auto& [frame, start, goal] = image.ends;
  return {{{-frame.x, -frame.y, -frame.half_turn}, goal, start},
          !image.is_backwards,
          image.is_mirrored};
}

Image mirrored(const Image& image) {
  const auto& [frame, start, goal] = image.ends;
  return {{{frame.x, -frame.y, -frame.half_turn}, -start, -goal},
          image.is_backwards,
          !image.is_mirrored};
}

/// The image that stands for all four: the goal is ahead and to the left.
Image folded(const RigEnds& ends) {
  const Image given{ends};
  const std::array<Image, 4> images = {given, backwards(given), mirrored(given),
                                       mirrored(backwards(given))};
  return *std::max_element(images.begin(), images.end(),
                           [](const Image& a, const Image& b) { return a.key() < b.key(); });
}

/// A path of the image, mapped back to the task.
Piece unfolded(const Image& image, std::span<const Segment> segments) {
  Piece piece;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    Segment s = segments[image.is_backwards ? segments.size() - 1 - i : i];
    if (image.is_mirrored) s.curvature = -s.curvature;
    if (image.is_backwards) s.length = -s.length;
    piece.length += std::abs(s.length);
    piece.segments[piece.count++] = s;
  }
  return piece;
}

RigWordSolver::Task task_of(const Image& image, const RigPrices& prices) {
  const MeanFrame& f = image.ends.frame;
  RigWordSolver::Task task;
  task.start = rig_place(-f.x / 2, -f.y / 2, -f.half_turn, image.ends.start_u);
  task.goal = rig_place(f.x / 2, f.y / 2, f.half_turn, image.ends.goal_u);
  task.tolerance = 1e-12 * (1 + std::abs(f.x) + std::abs(f.y));
  task.prices = {1, prices.reverse_weight, prices.gear_change_cost};
  task.is_backwards = image.is_backwards;
  if (image.is_backwards) std::swap(task.prices.forward, task.prices.reverse);
  task.cutoff = prices.cutoff;
  return task;
}

double price_of(const RigSegments& segments, const WordPrices& prices) {
  double sum = 0.0;
  for (std::size_t i = 0; i < segments.count; ++i) {
    const double way = segments.list[i].length;
    sum += way < 0 ? -way * prices.reverse : way * prices.forward;
    if (i > 0 && way * segments.list[i - 1].length < 0) sum += prices.gear_change;
  }
  return sum;
}

/// Estimated length of turns between the states [turning radii]: less than 1 where they are near.
double size_of(const RigWordSolver::Task& task) {
  const double apart = std::abs(task.goal.x - task.start.x) + std::abs(task.goal.y - task.start.y) +
                       std::abs(task.goal.heading - task.start.heading) +
                       2 * std::abs(task.goal.u - task.start.u);
  return std::cbrt(std::min(1.0, apart));
}

/// A guess with its lengths scaled to a task.
RigWord sized(const RigWord& guess, const RigWordSolver::Task& task) {
  const double dx = task.goal.x - task.start.x, dy = task.goal.y - task.start.y;
  const double distance = std::sqrt(dx * dx + dy * dy);
  const double size = size_of(task);
  RigWord word = guess;
  for (std::size_t i = 0; i < RigWord::letters; ++i) {
    word.lengths[i] *= word.turns[i] == 0 ? size / 2 + distance : size;
  }
  return word;
}

/// Index of a task in `rig_shortlists`: by distance and direction of the goal, change of heading,
/// and how bent the rig is at both ends.
std::size_t shortlist_of(const RigWordSolver::Task& task, double most) {
  const double x = task.goal.x - task.start.x, y = task.goal.y - task.start.y;
  const double turn = task.goal.heading;  // half of the change of heading
  const double distance = std::sqrt(x * x + y * y);
  const double apart = distance + 2 * std::abs(turn);
  const std::size_t reach = apart < 0.3 ? 0 : distance < 1 ? 1 : distance < 3.5 ? 2 : 3;
  const std::size_t sector = y < 0.577 * x ? 0 : y < 1.73 * x ? 1 : 2;
  constexpr double eighth = 0.785;
  const std::size_t turned = turn < -eighth ? 0 : turn < 0 ? 1 : turn < eighth ? 2 : 3;
  const auto bent = [&](double u) {
    return u < -0.3 * most ? std::size_t{0} : u < 0.3 * most ? std::size_t{1} : std::size_t{2};
  };
  return (((reach * 3 + sector) * 4 + turned) * 3 + bent(task.start.u)) * 3 + bent(task.goal.u);
}

/// The angle plus whole turns, in [0, 2 pi).
double in_one_turn(double angle) {
  constexpr double full_turn = 2 * std::numbers::pi;
  return angle - full_turn * std::floor(angle / full_turn);
}

/// A turn, a line and a turn forward, on circles of the sharpest `radius` that the rig can hold
/// (step 3). A swing to the other side at the end bends the rig as the goal wants. Nothing if the
/// circles overlap.
std::optional<RigWord> forward_guess(const RigWordSolver::Task& task, double radius, int first,
                                     int last) {
  constexpr double swing = 0.5;
  const RigPlace& a = task.start;
  const RigPlace& b = task.goal;
  const double x = (b.x - last * radius * b.sin) - (a.x - first * radius * a.sin);
  const double y = (b.y + last * radius * b.cos) - (a.y + first * radius * a.cos);
  const double across = radius * (last - first);  // offset of the centres across the line
  const double squared = x * x + y * y - across * across;
  if (!(squared > 0)) return std::nullopt;
  const double line = std::sqrt(squared);
  const double heading = base::atan_2(y * line - x * across, x * line + y * across);
  return RigWord{{first, 0, last, -last},
                 {radius * in_one_turn(first * (heading - a.heading)), line,
                  radius * in_one_turn(last * (b.heading - heading)) + swing, swing}};
}

/// Calls `take` with each single arc or line that leads to the goal (step 2).
template <typename Take>
void for_each_single(const RigWordSolver& solver, const RigWordSolver::Task& task, Take take) {
  const double turn = task.goal.heading - task.start.heading;
  const auto look_at = [&](double curvature, double way) {
    RigSegments one;
    one.list[0] = {curvature, way};
    one.count = way != 0.0 ? 1 : 0;
    if (price_of(one, task.prices) <= task.cutoff && solver.leads(task, one.view())) take(one);
  };
  look_at(0, task.goal.x - task.start.x);
  if (turn == 0.0) return;
  look_at(1, turn);
  look_at(-1, -turn);
  const double hold = solver.hitch().hold_curvature(task.start.u);
  if (hold != 0.0 && std::abs(hold) < 1) look_at(hold, turn / hold);
}

/// The word that drives another one backwards.
RigWord backwards(const RigWord& word) {
  RigWord result;
  for (std::size_t i = 0; i < RigWord::letters; ++i) {
    result.turns[i] = word.turns[RigWord::letters - 1 - i];
    result.lengths[i] = -word.lengths[RigWord::letters - 1 - i];
  }
  return result;
}

/// The guess with a number of `rig_shortlists.h`; nothing if the task has no such guess.
std::optional<RigWord> numbered_guess(const RigWordSolver& solver, const RigWordSolver::Task& task,
                                      std::size_t number) {
  if (number < rig_guesses.size()) return sized(rig_guesses[number], task);
  const std::size_t lined = number - rig_guesses.size();
  const int first = (lined & 2) != 0 ? -1 : 1;
  const int last = (lined & 1) != 0 ? -1 : 1;
  if (lined < 4) return forward_guess(task, solver.hold_radius(), first, last);
  RigWordSolver::Task other = task;
  std::swap(other.start, other.goal);
  const auto guess = forward_guess(other, solver.hold_radius(), first, last);
  if (!guess) return std::nullopt;
  return backwards(*guess);
}

/// The cheapest word found so far. Its price is the cutoff of later ones.
class LeastWord {
 public:
  LeastWord(const RigWordSolver& solver, const RigWordSolver::Task& task)
      : solver_(solver),
        task_(task),
        bound_(std::min(task.prices.forward, task.prices.reverse) *
               reeds_shepp_length({task.start.x, task.start.y, task.start.heading},
                                  {task.goal.x, task.goal.y, task.goal.heading}, 1.0)) {
    for_each_single(solver, task, [&](const RigSegments& one) { take(one); });
  }

  /// Whether a word is within a hundredth of the least possible price, or none can be cheap enough.
  [[nodiscard]] bool is_good() const { return task_.cutoff <= 1.01 * bound_; }

  /// Whether the word is far dearer than most words between states as far apart, or there is none.
  [[nodiscard]] bool is_dear() const {
    return !least_ || task_.cutoff > 2 * bound_ + 6 * solver_.hold_radius() * size_of(task_);
  }

  void look_at(std::size_t number) {
    auto guess = numbered_guess(solver_, task_, number);
    if (!guess) return;
    const auto found = solver_.solve(task_, *guess);
    if (found) take(*found);
  }

  [[nodiscard]] const std::optional<RigSegments>& least() const { return least_; }

 private:
  void take(const RigSegments& found) {
    least_ = found;
    task_.cutoff = price_of(found, task_.prices);
  }

  const RigWordSolver& solver_;
  RigWordSolver::Task task_;
  double bound_;
  std::optional<RigSegments> least_;
};

using Shortlist = std::array<std::uint8_t, shortlist_size>;

const Shortlist& shortlist(const RigWordSolver& solver, const RigWordSolver::Task& task) {
  return rig_shortlists[shortlist_of(task, solver.hitch().most())];
}

/// Tries the guesses of a task's list (steps 3 and 4), unless step 2 was enough. Returns whether
/// the word is good.
bool look_at_likely(LeastWord& word, const Shortlist& likely) {
  if (word.is_good()) return true;
  for (const std::size_t number : likely) {
    word.look_at(number);
    if (word.is_good()) return true;
  }
  return false;
}

/// The cheapest word that steps 2 to 4 find.
std::optional<RigSegments> least_word(const RigWordSolver& solver,
                                      const RigWordSolver::Task& task) {
  LeastWord word(solver, task);
  const Shortlist& likely = shortlist(solver, task);
  if (look_at_likely(word, likely)) return word.least();
  const WordPrices& prices = task.prices;
  const bool by_length = prices.forward == 1 && prices.reverse == 1 && prices.gear_change == 0;
  if (by_length && !word.is_dear()) return word.least();
  for (std::size_t number = 0; number < guess_count; ++number) {
    if (std::find(likely.begin(), likely.end(), number) != likely.end()) continue;
    word.look_at(number);
    if (word.is_good()) break;
  }
  return word.least();
}

/// The arc at full lock, driven forward, that straightens the rig.
Segment straightening(const RigWordSolver& solver, const RigPlace& place) {
  const int turn = place.u > 0 ? -1 : 1;
  return {double(turn), place.u == 0 ? 0.0 : solver.hitch().way_between(turn, place.u, 0)};
}

/// A path that straightens the rig at both ends, goes on straight by `lines` there, and joins both
/// ends by a word.
std::optional<Piece> straightened(const RigWordSolver& solver, const Image& image,
                                  const RigWordSolver::Task& task,
                                  const std::array<double, 2>& lines) {
  const std::array<Segment, 2> ahead = {straightening(solver, task.start), Segment{0, lines[0]}};
  const std::array<Segment, 2> back = {straightening(solver, task.goal), Segment{0, lines[1]}};
  RigWordSolver::Task middle = task;
  middle.start = solver.after(task.start, ahead);
  middle.goal = solver.after(task.goal, back);
  middle.start.u = middle.goal.u = 0;
  middle.is_rounded = true;
  middle.tolerance = 1e-12 * (1 + std::abs(middle.goal.x) + std::abs(middle.goal.y));
  const auto word = least_word(solver, middle);
  if (!word) return std::nullopt;
  std::array<Segment, SegmentRoom::size()> all{};
  std::size_t count = 0;
  const auto add = [&](const Segment& s) {
    if (s.length != 0) all[count++] = s;
  };
  for (const Segment& s : ahead) add(s);
  for (const Segment& s : word->view()) add(s);
  add({back[1].curvature, -back[1].length});
  add({back[0].curvature, -back[0].length});
  if (!solver.leads(task, {all.data(), count})) return std::nullopt;
  return unfolded(image, {all.data(), count});
}

/// A path that goes straight on at both ends, ever farther, until a word joins them (step 5).
std::optional<Piece> detour(const RigWordSolver& solver, const Image& image,
                            const RigWordSolver::Task& task) {
  constexpr double longest = 100;  // [turning radii]
  for (double line = 0; line < longest; line = line * 1.5 + 1) {
    if (line > task.cutoff / std::min(task.prices.forward, task.prices.reverse)) break;
    for (const std::array<double, 2>& lines :
         {std::array{line, 0.0}, std::array{0.0, line}, std::array{line, line / 2}}) {
      std::optional<Piece> piece = straightened(solver, image, task, lines);
      if (piece) return piece;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<Piece> least_rig_path(const RigWordSolver& solver, const RigEnds& ends,
                                    const RigPrices& prices) {
  const Image image = folded(ends);
  const RigWordSolver::Task task = task_of(image, prices);
  const auto word = least_word(solver, task);
  if (word) return unfolded(image, {word->list.data(), word->count});
  std::optional<Piece> piece = detour(solver, image, task);
  if (!piece || price_of(prices, piece->view()) > prices.cutoff) return std::nullopt;
  return piece;
}

std::optional<Piece> likely_rig_path(const RigWordSolver& solver, const RigEnds& ends) {
  const Image image = folded(ends);
  const RigWordSolver::Task task = task_of(image, {});
  LeastWord word(solver, task);
  (void)look_at_likely(word, shortlist(solver, task));
  if (!word.least()) return std::nullopt;
  return unfolded(image, {word.least()->list.data(), word.least()->count});
}

std::vector<Piece> all_rig_paths(const RigWordSolver& solver, const RigEnds& ends,
                                 const RigPrices& prices) {
  const Image image = folded(ends);
  const RigWordSolver::Task task = task_of(image, prices);
  std::vector<Piece> pieces;
  const auto take = [&](const RigSegments& found) {
    const Piece piece = unfolded(image, {found.list.data(), found.count});
    const auto is_same = [&](const Piece& other) {
      constexpr double same = 1e-9;
      return other.count == piece.count && std::abs(other.length - piece.length) < same;
    };
    if (std::none_of(pieces.begin(), pieces.end(), is_same)) pieces.push_back(piece);
  };
  for_each_single(solver, task, take);
  const auto look_at = [&](RigWord guess) {
    if (const auto found = solver.solve(task, guess)) take(*found);
  };
  for (std::size_t number = 0; number < guess_count; ++number) {
    const auto guess = numbered_guess(solver, task, number);
    if (guess) look_at(*guess);
  }
  if (pieces.empty()) {
    const auto piece = least_rig_path(solver, ends, prices);
    if (piece) pieces.push_back(*piece);
  }
  const auto by_price = [&](const Piece& a, const Piece& b) {
    return price_of(prices, a.view()) < price_of(prices, b.view());
  };
  std::stable_sort(pieces.begin(), pieces.end(), by_price);
  return pieces;
}

}  // namespace vandplan::steering
