// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How long is the shortest path, looked up, and which of many nodes is nearest?

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "vandplan/geometry.h"

namespace vandplan {

// ---- How far is it, answered from the thesis' look-up table (HLUT)? ----
//
// Algorithms 5, 6 and 7 of Guo 2020 as settled in docs/algorithms/heuristic_table.md.

/// Range and grid of a table of lengths. Both ends of every range are grid points. Lengths are
/// 1e-6 to 1e6 m.
struct HeuristicTableOptions {
  double extent = 10.0;   ///< entries count for |dx| and |dy| below it [m]; a multiple of `step`
  double step = 1.0;      ///< distance of grid points along x and y [m]; > 0
  int heading_cells = 8;  ///< steps of a full turn; >= 1; one more heading is stored
  double turning_radius = 7.0;  ///< turning radius of the lengths [m]; > 0
  bool operator==(const HeuristicTableOptions&) const = default;
};

/// Options of one of the four tables of the thesis. Throws InputError naming "number" unless it is
/// 1 to 4.
[[nodiscard]] HeuristicTableOptions thesis_table_options(int number);

/// Reeds-Shepp lengths between relative poses on a four-dimensional grid. Immutable; copies share
/// the entries.
class HeuristicTable {
 public:
  /// Computes all entries of a table (Algorithm 6). Throws InputError naming the option that is out
  /// of range; "step" if there would be more than 2^28 entries.
  explicit HeuristicTable(const HeuristicTableOptions& options);

  /// Makes a table of entries that were computed before. Throws InputError naming the option that
  /// is out of range, or "entries" if their number is not what the options ask for.
  HeuristicTable(const HeuristicTableOptions& options, std::vector<float> entries);

  /// Makes a table of constant data: the entries must outlive it and all its copies. Throws
  /// InputError naming the option that is out of range, or "entries" if their number is not what
  /// the options ask for.
  HeuristicTable(const HeuristicTableOptions& options, std::span<const float> entries);

  /// Position of an entry in the grid of the table.
  struct GridPoint {
    int x, y, heading_node, heading_sample;
    bool operator==(const GridPoint&) const = default;
  };

  /// Place of a grid point in `entries()`: row-major [x][y][heading_node][heading_sample].
  [[nodiscard]] std::size_t index_of(const GridPoint& point) const noexcept;

  /// Pose of the node of a grid point [m, rad], in the frame with the sample's position as origin.
  [[nodiscard]] Pose node_of(const GridPoint& point) const noexcept;
  /// Pose of the sample of a grid point: at the origin, heading in [-pi, pi] [rad].
  [[nodiscard]] Pose sample_of(const GridPoint& point) const noexcept;

  /// Estimated length between a node and a sample [m] for a vehicle of turning radius `radius` [m]
  /// (Algorithm 7). It is an entry where |dx| and |dy| are below the extent, and the Euclidean
  /// distance elsewhere. |dx| and |dy| are rounded down to the grid, headings to the nearest grid
  /// point, so the estimate is no bound: it may be too small or too large. The table scales with
  /// the radius: extent and step hold for the table's own radius. Throws InputError naming "radius"
  /// unless it is finite and > 0.
  [[nodiscard]] double distance(const Pose& node, const Pose& sample, double radius) const;

  /// Estimated lengths between every node and one sample, in float [m]: out[i] belongs to node i.
  /// They are those of `distance` for the sample as rounded to float, which differs far from the
  /// origin. Headings of nodes are in [-pi, pi]. Throws InputError naming "radius" unless it is
  /// finite and > 0, or "nodes" unless all columns have as many numbers as `out`.
  void distances(const PoseColumns& nodes, const Pose& sample, double radius,
                 std::span<float> out) const;

  /// Range and grid of the table.
  [[nodiscard]] const HeuristicTableOptions& options() const noexcept { return options_; }
  /// All lengths [m], in the order of `index_of`.
  [[nodiscard]] std::span<const float> entries() const noexcept { return entries_; }

  /// Number of grid points along x; along y there are as many.
  [[nodiscard]] int positions() const noexcept { return positions_; }
  /// Number of grid points of a heading, both ends of the turn counted.
  [[nodiscard]] int headings() const noexcept { return options_.heading_cells + 1; }

 private:
  HeuristicTableOptions options_;
  int positions_ = 0;
  std::shared_ptr<const std::vector<float>> storage_;  // empty when the entries are constant data
  std::span<const float> entries_;
};

/// One of the four tables of the thesis, turning radius 7 m, computed when the library was built.
/// `number` is 1 to 4, otherwise InputError names it. Costs nothing to call.
[[nodiscard]] HeuristicTable thesis_table(int number);

// ---- Between which two numbers does a Reeds-Shepp length lie? ----
//
// One table, made for turning radius 1 when the library is built, serves every vehicle and every
// distance. Why the bounds hold, and how tight they are: docs/algorithms/bound_table.md.

/// Lower and upper bound of a length: low <= length <= high [m].
struct LengthBounds {
  double low = 0.0;
  double high = 0.0;
};

/// Bounds of the length of the shortest path between two poses, `reeds_shepp_length(from, to,
/// radius)` [m]. Headings may be any angle. Throws InputError naming "radius" unless it is finite
/// and > 0 [m].
[[nodiscard]] LengthBounds length_bounds(const Pose& from, const Pose& to, double radius);

/// Bounds of the lengths from every node to one sample, in float [m]: low[i] and high[i] belong to
/// node i. They hold for the sample as rounded to float. Headings of nodes must be in [-pi, pi]:
/// for others the bounds are wrong. The sample's may be any angle. Throws InputError naming
/// "radius" unless it is finite and > 0 [m], or "nodes" unless all columns have as many numbers as
/// `low` and `high`.
void length_bounds(const PoseColumns& nodes, const Pose& sample, double radius,
                   std::span<float> low, std::span<float> high);

/// Shape of the table of bounds: cells along its three coordinates, and its size in bytes.
struct BoundTableInfo {
  int radial_cells, side_cells, turn_cells;
  std::size_t bytes;
};

/// Shape of the library's table of bounds.
[[nodiscard]] BoundTableInfo bound_table_info() noexcept;

// ---- How does a table become a file, and how does a file become a table? ----
//
// The functions convert bytes; vandplan/files.h reads and writes them. Layout: docs/formats.md.

/// The table as the bytes of a file, equal on every machine. Layout: docs/formats.md.
[[nodiscard]] std::string table_to_bytes(const HeuristicTable& table);

/// The table that `table_to_bytes` wrote. Throws InputError naming `file` if the bytes are foreign,
/// truncated, altered, or of another version.
[[nodiscard]] HeuristicTable table_from_bytes(std::string_view bytes, const std::string& file);

/// The library's table of bounds as the bytes of a file.
[[nodiscard]] std::string bound_table_to_bytes();

/// Head of a table file: what it says about itself before its entries.
struct TableFileHead {
  /// Content of a file: written by `table_to_bytes` (lengths), or by `bound_table_to_bytes`
  /// (bounds).
  enum class Content { lengths, bounds };
  Content content = Content::lengths;
  HeuristicTableOptions options{};  ///< options of a table of lengths
  BoundTableInfo bounds{};          ///< shape of a table of bounds
  std::uint64_t entries = 0;        ///< number of entries
  std::uint64_t bytes = 0;          ///< size of the whole file [bytes]
  std::uint64_t checksum = 0;       ///< checksum of the file
};

/// Number of bytes at the start of a table file that hold its head.
inline constexpr std::size_t table_file_head_size = 96;

/// The head of a table file. `start` holds at least its first bytes. Throws InputError naming
/// `file` when the file is not one of ours or promises more than 2^28 entries.
[[nodiscard]] TableFileHead table_file_head(std::string_view start, const std::string& file);

/// Checks a table file. Throws InputError naming `file` unless all of its bytes are there and the
/// checksum fits.
void check_table_file(std::string_view bytes, const std::string& file);

// ---- Which of many nodes is nearest by Reeds-Shepp length? ----
//
// The result is that of comparing all exact lengths, but few of them are computed:
// docs/algorithms/nearest.md.

/// The node that a query for one node found.
struct NearestNode {
  std::int32_t node = 0;          ///< number of the node, from 0 in the order of `add`
  double length = 0.0;            ///< `reeds_shepp_length` between node and sample [m]
  std::int64_t exact_solves = 0;  ///< number of lengths that were computed
};

/// One of the nodes that a query for several nodes found.
struct NearNode {
  std::int32_t node = 0;  ///< number of the node, from 0 in the order of `add`
  double length = 0.0;    ///< `reeds_shepp_length` between node and sample [m]
  bool operator==(const NearNode&) const = default;
};

/// Nodes that a query for several nodes wants.
struct NearWanted {
  /// Largest number of nodes.
  std::size_t count = std::numeric_limits<std::size_t>::max();
  /// Largest length to the sample [m]; >= 0.
  double within = std::numeric_limits<double>::infinity();
};

/// Nodes in a grid over x and y, which is rebuilt whenever their number has doubled. Copies are
/// independent of each other. Queries may run in many threads at once. The query for one node
/// allocates nothing. All poses share one frame.
class NearestNodes {
 public:
  /// An empty set for a vehicle with that turning radius [m]. Throws InputError naming "radius"
  /// unless it is finite and > 0.
  explicit NearestNodes(double radius);
  ~NearestNodes();
  NearestNodes(const NearestNodes& other);
  NearestNodes& operator=(const NearestNodes& other);
  /// Moves the nodes. `other` may only be destroyed or assigned to afterwards.
  NearestNodes(NearestNodes&& other) noexcept;
  NearestNodes& operator=(NearestNodes&& other) noexcept;

  /// Adds a node; its heading may be any angle [rad]. Throws InputError naming "pose" unless its
  /// numbers are finite.
  void add(const Pose& pose);

  /// Removes a node. The numbers of the other nodes stay; its number is not used again. Throws
  /// InputError naming "node" if there is no such node.
  void remove(std::int32_t node);

  /// The node with the least exact length to the sample; ties go to the older node. None if there
  /// are no nodes. Throws InputError naming "sample" if it is not finite.
  [[nodiscard]] std::optional<NearestNode> nearest(const Pose& sample) const;

  /// The wanted nodes with the least exact lengths to the sample, by length; ties go to the older
  /// node. Throws InputError naming "sample" if it is not finite.
  [[nodiscard]] std::vector<NearNode> nearest(const Pose& sample, const NearWanted& wanted) const;

  /// Numbers of the nodes that `nearest(sample, wanted)` finds, in no order. It is faster, because
  /// few lengths have to be computed. Throws InputError naming "sample" if it is not finite.
  [[nodiscard]] std::vector<std::int32_t> nearest_in_any_order(const Pose& sample,
                                                               const NearWanted& wanted) const;

  /// Number of nodes that were added and not removed.
  [[nodiscard]] std::size_t size() const noexcept;

 private:
  struct Grid;
  std::unique_ptr<Grid> grid_;
};

}  // namespace vandplan
