// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "moving/occupied.h"

#include <algorithm>
#include <utility>

namespace vandplan::moving {
/// Box of the path-time diagram of one obstacle: places from `begin` to `end` [m], times `span`.
/// The places lie in rows `first` to `last` - 1.
struct Occupied::Box {
  std::size_t obstacle;
  std::size_t first, last;
  double begin, end;
  TimeSpan span;
  bool is_for_ever = false;  // the obstacle has come to rest: the box has no end in time
};

Occupied::Occupied(const Encounters& encounters, std::vector<double> stations,
                   std::vector<TimeSpan> when, const BoxLimits& limits)
    : encounters_(encounters),
      stations_(std::move(stations)),
      when_(std::move(when)),
      rows_(stations_.size() - 1),
      limits_(limits) {
  for (std::size_t i = 0; i < encounters_.size(); ++i) {
    const double rest = encounters_.rests(i);
    Box box{i, 0, rows_.size(), stations_.front(), stations_.back(), {0.0, rest}};
    if (rest >= 0.0) add(box);
    if (encounters_.leaves(i)) continue;
    box.span = {std::max(rest, 0.0), std::max(rest, 0.0)};
    box.is_for_ever = true;
    add(box);
  }
  sort_rows();
}

void Occupied::add(const Box& box) {
  if (is_out_of_time(box) || is_known(box)) return;
  const auto& [obstacle, first, last, begin, end, span, is_for_ever] = box;
  if (boxes_ >= limits_.most_boxes) {
    mark(first, last, {span.begin, is_for_ever ? forever : span.end});
    return;
  }
  ++boxes_;
  // 1. Largest motion of vehicle and obstacle from the middle of the box to its sides.
  const double place = begin + (end - begin) / 2;
  const double time = span.begin + (span.end - span.begin) / 2;
  const double there = encounters_.driven(place);
  const double driven =
      std::max(there - encounters_.driven(begin), encounters_.driven(end) - there);
  const double then = encounters_.moved(obstacle, time);
  const double moved = std::max(then - encounters_.moved(obstacle, span.begin),
                                encounters_.moved(obstacle, span.end) - then);
  // 2. The box is free, or surely occupied, or too small to halve.
  const State state = encounters_.state_at(place);
  const double most = driven + moved;
  if (encounters_.gap(obstacle, state, time, most * (1.0 + 1e-9) + 1e-9) > most) return;
  const bool is_fine = most <= 2 * limits_.finest && last - first == 1;
  if (is_fine || encounters_.depth(obstacle, state, time) >= most) {
    mark(first, last, {span.begin, is_for_ever ? forever : span.end});
    return;
  }
  // 3. Otherwise the box is halved, in time or place, where the motion is larger.
  Box low = box;
  Box high = box;
  const bool is_one_place = last - first <= 1 && driven <= limits_.finest;
  // An instant cannot be halved, but `moved` may jump there.
  const bool is_instant = !(span.begin < time && time < span.end);
  if (is_instant && is_one_place) {
    mark(first, last, {span.begin, is_for_ever ? forever : span.end});
    return;
  }
  if (!is_instant && (is_one_place || (moved > driven && moved > limits_.finest))) {
    low.span.end = high.span.begin = time;
  } else if (last - first > 1) {
    low.last = high.first = first + (last - first) / 2;
    low.end = high.begin = stations_[low.last];
  } else {
    low.end = high.begin = place;
  }
  add(low);
  add(high);
}

void Occupied::mark(std::size_t first, std::size_t last, const TimeSpan& span) {
  for (std::size_t i = first; i < last; ++i) {
    std::vector<TimeSpan>& row = rows_[i];
    if (!row.empty() && row.back().end == span.begin && row.back().begin <= span.begin) {
      row.back().end = span.end;
    } else {
      row.push_back(span);
    }
  }
}

/// Whether the vehicle cannot be in the rows of the box during its span.
bool Occupied::is_out_of_time(const Box& box) const noexcept {
  const double end = box.is_for_ever ? forever : box.span.end;
  return end < when_[box.first].begin || box.span.begin > when_[box.last - 1].end;
}

/// Whether the row of a box within one row is already occupied for the whole span. Only the latest
/// spans are compared.
bool Occupied::is_known(const Box& box) const noexcept {
  constexpr std::ptrdiff_t looks = 16;
  if (box.last - box.first > 1) return false;
  const std::vector<TimeSpan>& row = rows_[box.first];
  const auto begin = row.end() - std::min<std::ptrdiff_t>(looks, std::ssize(row));
  const double end = box.is_for_ever ? forever : box.span.end;
  return std::any_of(begin, row.end(), [&](const TimeSpan& span) {
    return span.begin <= box.span.begin && end <= span.end;
  });
}

void Occupied::sort_rows() {
  for (std::vector<TimeSpan>& row : rows_) {
    std::ranges::sort(row, {}, &TimeSpan::begin);
    std::vector<TimeSpan> joined;
    for (const TimeSpan& span : row) {
      if (!joined.empty() && span.begin <= joined.back().end) {
        joined.back().end = std::max(joined.back().end, span.end);
      } else {
        joined.push_back(span);
      }
    }
    row = std::move(joined);
  }
}

bool Occupied::is_free(std::size_t i, double begin, double end) const noexcept {
  const std::vector<TimeSpan>& row = rows_[i];
  const auto next = std::ranges::lower_bound(row, begin, {}, &TimeSpan::end);
  return next == row.end() || next->begin > end;
}

double Occupied::next_free(std::size_t i, double begin, double length) const noexcept {
  const std::vector<TimeSpan>& row = rows_[i];
  auto next = std::ranges::lower_bound(row, begin, {}, &TimeSpan::end);
  for (; next != row.end() && next->begin <= begin + length; ++next) begin = next->end;
  return begin;
}

double Occupied::last_change() const noexcept {
  double last = 0.0;
  for (const std::vector<TimeSpan>& row : rows_) {
    for (const auto& [begin, end] : row) last = std::max(last, end == forever ? begin : end);
  }
  return last;
}

}  // namespace vandplan::moving
