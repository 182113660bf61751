// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "io/result_bytes.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "base/bytes.h"
#include "base/hash.h"
#include "vandplan/input_error.h"

namespace vandplan::io {
namespace {

using base::append;

constexpr std::string_view magic = "vp-plans";
constexpr std::uint32_t byte_order = 0x01020304;
constexpr std::uint32_t version = 1;
constexpr std::size_t largest_head = std::size_t{1} << 24;     // Largest text of a header [bytes].
constexpr std::size_t largest_lists = std::size_t{512} << 20;  // Largest lists of a result [bytes].

/// First number of a record or of the end.
enum class Mark : std::uint32_t { end, result };

// Sizes of the parts of a file [bytes].
constexpr std::size_t head_size = 24;
constexpr std::size_t record_size = 140;  // A record after its mark, without its lists.
constexpr std::uint64_t segment_size = 3 * sizeof(double);
constexpr std::uint64_t knot_size = 5 * sizeof(double);
constexpr std::uint64_t stop_size = 5 * sizeof(double);

void append_numbers(std::string& bytes, std::initializer_list<double> values) {
  for (const double value : values) append(bytes, std::bit_cast<std::uint64_t>(value));
}

void append_pose(std::string& bytes, const Pose& pose) {
  append_numbers(bytes, {pose.x, pose.y, pose.heading});
}

void append_size(std::string& bytes, std::size_t size) {
  append(bytes, static_cast<std::uint32_t>(size));
}

std::uint32_t number_of(PlanStatus status) {
  const auto& all = plan_statuses();
  return static_cast<std::uint32_t>(std::ranges::find(all, status) - all.begin());
}

/// Appends the part of a record after the poses and the hitch angle.
void append_result(std::string& bytes, const PlanResult& result) {
  const std::vector<Segment> none;
  const std::vector<Segment>& segments = result.path ? result.path->segments : none;
  const SpeedProfile speeds = result.speeds.value_or(SpeedProfile{});
  append_numbers(
      bytes, {result.path ? result.cost : 0.0, result.lower_bound.value_or(0.0), result.time_total,
              result.anytime.empty() ? 0.0 : result.anytime.front().time, speeds.duration});
  append(bytes, static_cast<std::uint64_t>(result.iterations));
  append(bytes, static_cast<std::uint64_t>(counter(result, "nodes")));
  append_size(bytes, segments.size());
  append_size(bytes, speeds.knots.size());
  append_size(bytes, speeds.stops.size());
  append_size(bytes, result.reason.size());
  for (const Segment& segment : segments) {
    append_numbers(bytes, {segment.curvature, segment.length, segment.curvature_rate});
  }
  for (const SpeedKnot& knot : speeds.knots) {
    append_numbers(bytes, {knot.t, knot.s, knot.v, knot.a, knot.jerk});
  }
  for (const Stop& stop : speeds.stops) {
    append_numbers(bytes,
                   {stop.t, stop.s, stop.pause, stop.curvature_before, stop.curvature_after});
  }
  bytes += result.reason;
}

/// Reads the fields of a record one by one.
class Fields {
 public:
  Fields(const ResultBytesReader& reader, std::string_view bytes)
      : reader_(reader), bytes_(bytes) {}

  template <class Unsigned>
  Unsigned whole() {
    return base::read_at<Unsigned>(bytes_, std::exchange(at_, at_ + sizeof(Unsigned)));
  }

  double number(const char* name) {
    const auto value = std::bit_cast<double>(whole<std::uint64_t>());
    if (!std::isfinite(value)) {
      fail(fmt::format("has a {} of {}, expected a finite number", name, value));
    }
    return value;
  }

  std::int64_t count(const char* name) {
    const auto value = whole<std::uint64_t>();
    if (value > INT64_MAX) {
      fail(fmt::format("has {} {}, expected at most {}", value, name, INT64_MAX));
    }
    return static_cast<std::int64_t>(value);
  }

  Pose pose(const char* name) {
    const double x = number(name);
    const double y = number(name);
    return {x, y, number(name)};
  }

  [[noreturn]] void fail(const std::string& problem) const { reader_.fail(problem); }

  [[nodiscard]] std::string_view rest() const { return bytes_.substr(at_); }

 private:
  const ResultBytesReader& reader_;
  std::string_view bytes_;
  std::size_t at_ = 0;
};

/// Lengths of the lists of a record.
struct Counts {
  std::uint32_t segments, knots, stops, letters;

  [[nodiscard]] std::uint64_t bytes() const {
    return segments * segment_size + knots * knot_size + stops * stop_size + letters;
  }
};

void check(const Counts& counts, PlanStatus status, const ResultBytesReader& reader) {
  if (counts.bytes() > largest_lists) {
    reader.fail(
        fmt::format("has lists of {} bytes, expected at most {}", counts.bytes(), largest_lists));
  }
  if (status != PlanStatus::solved && counts.segments + counts.knots > 0) {
    reader.fail(fmt::format("has a path though its status is {}, expected none", name_of(status)));
  }
  if (counts.knots == 0 && counts.stops > 0) {
    reader.fail(fmt::format("has {} stops without knots, expected none", counts.stops));
  }
}

std::vector<Segment> segments_from(Fields& fields, std::uint32_t count) {
  std::vector<Segment> segments(count);
  for (Segment& segment : segments) {
    segment.curvature = fields.number("curvature");
    segment.length = fields.number("length");
    segment.curvature_rate = fields.number("curvature rate");
  }
  return segments;
}

SpeedProfile speeds_from(Fields& fields, const Counts& counts) {
  SpeedProfile speeds;
  speeds.knots.resize(counts.knots);
  for (SpeedKnot& knot : speeds.knots) {
    for (double* const value : {&knot.t, &knot.s, &knot.v, &knot.a, &knot.jerk}) {
      *value = fields.number("knot");
    }
  }
  if (const double first = speeds.knots.front().t; first != 0.0) {
    fields.fail(fmt::format("has knots that begin at {} s, expected 0 s", first));
  }
  speeds.stops.resize(counts.stops);
  for (Stop& stop : speeds.stops) {
    for (double* const value :
         {&stop.t, &stop.s, &stop.pause, &stop.curvature_before, &stop.curvature_after}) {
      *value = fields.number("stop");
    }
    speeds.standing += stop.pause;
  }
  return speeds;
}

}  // namespace

ResultBytesWriter::ResultBytesWriter(const ResultHead& head, TextSink sink)
    : sink_(std::move(sink)), checksum_(base::empty_hash) {
  std::string bytes(magic);
  append(bytes, byte_order);
  append(bytes, version);
  append(bytes, static_cast<std::uint32_t>(head.kind));
  append_size(bytes, head.text.size());
  hand_out(bytes += head.text);
}

void ResultBytesWriter::add(std::uint64_t number, const PosePair& poses, double hitch_angle,
                            const PlanResult& result) {
  std::string bytes;
  append(bytes, static_cast<std::uint32_t>(Mark::result));
  append(bytes, number_of(result.status));
  append(bytes, number);
  append_pose(bytes, poses.start);
  append_pose(bytes, poses.goal);
  append_numbers(bytes, {hitch_angle});
  append_result(bytes, result);
  hand_out(bytes);
}

void ResultBytesWriter::end() {
  std::string bytes;
  append(bytes, static_cast<std::uint32_t>(Mark::end));
  append(bytes, base::hash_of(bytes, checksum_));
  sink_(bytes);
}

void ResultBytesWriter::hand_out(std::string_view bytes) {
  checksum_ = base::hash_of(bytes, checksum_);
  sink_(bytes);
}

bool ResultBytesReader::begins(FileReader& file) {
  return file.ahead(magic.size()).starts_with(magic);
}

ResultBytesReader::ResultBytesReader(FileReader& file) : file_(file), checksum_(base::empty_hash) {
  read_head();
}

void ResultBytesReader::read_head() {
  const auto refuse = [&](const std::string& problem) { throw InputError(file_.name(), problem); };
  const std::string_view bytes = take(head_size);
  const auto order = base::read_at<std::uint32_t>(bytes, 8);
  if (order != byte_order) {
    refuse(fmt::format("has the byte order mark {:#x}, expected {:#x}", order, byte_order));
  }
  if (const auto found = base::read_at<std::uint32_t>(bytes, 12); found != version) {
    refuse(fmt::format("is of version {} of the format, expected {}", found, version));
  }
  const auto kind = base::read_at<std::uint32_t>(bytes, 16);
  if (kind > static_cast<std::uint32_t>(ResultsOf::pairs)) {
    refuse(fmt::format("holds results of kind {}, expected 0 or 1", kind));
  }
  const auto size = base::read_at<std::uint32_t>(bytes, 20);
  if (size > largest_head) {
    refuse(fmt::format("begins with a text of {} bytes, expected at most {}", size, largest_head));
  }
  head_ = {static_cast<ResultsOf>(kind), std::string(take(size))};
}

std::optional<ResultBytes> ResultBytesReader::next() {
  if (has_ended_) return std::nullopt;
  const auto mark = base::read_at<std::uint32_t>(take(sizeof(Mark)), 0);
  if (mark == static_cast<std::uint32_t>(Mark::end)) {
    read_end();
    return std::nullopt;
  }
  ++read_;
  if (mark != static_cast<std::uint32_t>(Mark::result)) {
    fail(fmt::format("begins with {}, expected 1", mark));
  }
  Fields fields(*this, take(record_size));
  const std::size_t status = fields.whole<std::uint32_t>();
  if (status >= plan_statuses().size()) {
    fail(fmt::format("has a status of {}, expected 0 to {}", status, plan_statuses().size() - 1));
  }
  ResultBytes record;
  PlanResult& result = record.result;
  result.status = plan_statuses()[status];
  record.number = fields.whole<std::uint64_t>();
  record.poses.start = fields.pose("start");
  record.poses.goal = fields.pose("goal");
  record.hitch_angle = fields.number("hitch angle");
  result.cost = fields.number("cost");
  const double bound = fields.number("bound");
  if (bound > 0.0) result.lower_bound = bound;
  result.time_total = fields.number("time");
  (void)fields.number("time of its first path");
  const double duration = fields.number("duration");
  result.iterations = fields.count("iterations");
  result.counters = {{"nodes", fields.count("nodes")}};
  Counts counts{};
  for (std::uint32_t* const count :
       {&counts.segments, &counts.knots, &counts.stops, &counts.letters}) {
    *count = fields.whole<std::uint32_t>();
  }
  check(counts, result.status, *this);
  Fields lists(*this, take(counts.bytes()));
  if (result.status == PlanStatus::solved) {
    result.path = Path{record.poses.start, segments_from(lists, counts.segments)};
  }
  if (counts.knots > 0) {
    result.speeds = speeds_from(lists, counts);
    result.speeds->duration = duration;
  }
  result.reason = lists.rest();
  return record;
}

void ResultBytesReader::read_end() {
  has_ended_ = true;
  const std::uint64_t expected = checksum_;
  if (base::read_at<std::uint64_t>(take(sizeof expected), 0) != expected) {
    throw InputError(file_.name(), "is altered: its check sum is not that of its bytes");
  }
  if (!file_.ahead(1).empty()) {
    throw InputError(file_.name(), "goes on behind its check sum, expected its end");
  }
}

std::string_view ResultBytesReader::take(std::size_t size) {
  const std::string_view bytes = file_.ahead(size).substr(0, size);
  if (bytes.size() < size) {
    throw InputError(
        file_.name(),
        fmt::format("ends too early, in or behind result {}, expected a whole file", read_));
  }
  checksum_ = base::hash_of(bytes, checksum_);
  file_.skip(size);
  return bytes;
}

void ResultBytesReader::fail(const std::string& problem) const {
  throw InputError(file_.name(), fmt::format("result {} {}", read_, problem));
}

}  // namespace vandplan::io
