// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Lengths of shortest paths between many poses, and the nearest of many nodes.

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "bindings/python/core/arrays.h"
#include "bindings/python/core/bind.h"
#include "bindings/python/core/path.h"
#include "vandplan/input_error.h"
#include "vandplan/steering.h"
#include "vandplan/tables.h"

namespace vandplan::python {
namespace {

/// Array with a number for each pair, or one number for a pair of single poses.
template <typename Loop>
py::object numbers_of_pairs(const Poses& from, const Poses& to, Loop loop) {
  if (from.shape().empty() && to.shape().empty()) {
    double value = 0.0;
    loop(from.view(), to.view(), std::span(&value, 1));
    return py::float_(value);
  }
  const std::vector<py::ssize_t> shape = shape_of_pairs(from, to);
  py::array_t<double> out = empty_array(shape);
  double* const values = out.mutable_data();
  for_pairs(from, to, shape,
            [&](std::span<const Pose> a, std::span<const Pose> b, std::size_t first) {
              loop(a, b, std::span(values + first, std::max(a.size(), b.size())));
            });
  return out;
}

/// Loop that calls `length(from, to)` for each pair.
template <typename Length>
auto one_by_one(Length length) {
  return [length](std::span<const Pose> from, std::span<const Pose> to, std::span<double> out) {
    const std::size_t from_step = from.size() == 1 ? 0 : 1;
    const std::size_t to_step = to.size() == 1 ? 0 : 1;
    for (std::size_t i = 0; i < out.size(); ++i) {
      out[i] = length(from[i * from_step], to[i * to_step]);
    }
  };
}

py::object python_reeds_shepp_length(const py::object& starts, const py::object& goals,
                                     double radius, bool exact) {
  expect_positive(radius, "radius");
  const Poses from(starts, "starts");
  const Poses to(goals, "goals");
  if (exact) {
    return numbers_of_pairs(from, to, one_by_one([=](const Pose& a, const Pose& b) {
                              return reeds_shepp_length(a, b, radius);
                            }));
  }
  return numbers_of_pairs(
      from, to, [=](std::span<const Pose> a, std::span<const Pose> b, std::span<double> out) {
        reeds_shepp_lengths(a, b, radius, out);
      });
}

py::object python_dubins_length(const py::object& starts, const py::object& goals, double radius) {
  expect_positive(radius, "radius");
  return numbers_of_pairs(
      Poses(starts, "starts"), Poses(goals, "goals"),
      one_by_one([=](const Pose& a, const Pose& b) { return dubins_length(a, b, radius); }));
}

py::tuple python_length_bounds(const py::object& starts, const py::object& goals, double radius) {
  expect_positive(radius, "radius");
  const Poses from(starts, "starts");
  const Poses to(goals, "goals");
  if (from.shape().empty() && to.shape().empty()) {
    const LengthBounds bounds = length_bounds(from.view().front(), to.view().front(), radius);
    return py::make_tuple(bounds.low, bounds.high);
  }
  const std::vector<py::ssize_t> shape = shape_of_pairs(from, to);
  py::array_t<double> low = empty_array(shape);
  py::array_t<double> high = empty_array(shape);
  double* const lows = low.mutable_data();
  double* const highs = high.mutable_data();
  for_pairs(from, to, shape,
            [&](std::span<const Pose> a, std::span<const Pose> b, std::size_t first) {
              for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
                const LengthBounds bounds =
                    length_bounds(a[a.size() == 1 ? 0 : i], b[b.size() == 1 ? 0 : i], radius);
                lows[first + i] = bounds.low;
                highs[first + i] = bounds.high;
              }
            });
  return py::make_tuple(low, high);
}

py::object python_continuous_length(const py::object& starts, const py::object& goals,
                                    double radius, double curvature_rate,
                                    const std::string& continuity) {
  const ContinuousSteering steering(radius, curvature_rate, continuity_named(continuity));
  return numbers_of_pairs(
      Poses(starts, "starts"), Poses(goals, "goals"),
      one_by_one([&](const Pose& a, const Pose& b) { return steering.length(a, b); }));
}

/// Index of nodes, with their poses for pickle.
struct NodeSet {
  double radius = 1.0;
  NearestNodes index;
  std::vector<Pose> poses = {};
  std::vector<std::int32_t> removed = {};  ///< Numbers of removed nodes.

  explicit NodeSet(double turning_radius) : radius(turning_radius), index(turning_radius) {}
};

void add_all(NodeSet& nodes, std::span<const Pose> poses) {
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Pose& pose = poses[i];
    if (!std::isfinite(pose.x) || !std::isfinite(pose.y) || !std::isfinite(pose.heading)) {
      throw InputError("nodes[" + std::to_string(i) + "]", "is not finite");
    }
  }
  for (const Pose& pose : poses) nodes.index.add(pose);
  nodes.poses.insert(nodes.poses.end(), poses.begin(), poses.end());
}

void remove_node(NodeSet& nodes, std::int64_t node) {
  const auto count = static_cast<std::int64_t>(nodes.poses.size());
  const bool is_there =
      node >= 0 && node < count &&
      std::find(nodes.removed.begin(), nodes.removed.end(), node) == nodes.removed.end();
  if (!is_there) throw InputError("node", fmt::format("{} is not there", node));
  nodes.index.remove(static_cast<std::int32_t>(node));
  nodes.removed.push_back(static_cast<std::int32_t>(node));
}

/// (index, length) of the nodes near a sample, nearest first.
py::tuple near(const NodeSet& set, const py::object& sample,
               const std::optional<std::size_t>& count, const std::optional<double>& within) {
  NearWanted wanted;
  if (count) wanted.count = *count;
  if (within) wanted.within = *within;
  if (!(wanted.within >= 0.0)) {
    throw InputError("within", fmt::format("is {}, expected a number >= 0 [m]", wanted.within));
  }
  const std::vector<NearNode> found = set.index.nearest(pose_from(sample, "sample"), wanted);
  const auto size = static_cast<py::ssize_t>(found.size());
  py::array_t<std::int64_t> index(size);
  py::array_t<double> length(size);
  for (py::ssize_t i = 0; i < size; ++i) {
    const auto& [node, way] = found[static_cast<std::size_t>(i)];
    index.mutable_at(i) = node;
    length.mutable_at(i) = way;
  }
  return py::make_tuple(index, length);
}

/// (index, length) of the nearest node for each sample.
py::tuple nearest_of(const NodeSet& set, const Poses& samples) {
  const NearestNodes& nodes = set.index;
  if (nodes.size() == 0) throw InputError("nodes", "are none, expected one at least");
  if (samples.shape().empty()) {
    const NearestNode found = *nodes.nearest(samples.view().front());
    return py::make_tuple(found.node, found.length);
  }
  const std::vector<py::ssize_t> shape(samples.shape().begin(), samples.shape().end());
  py::array_t<std::int64_t> index(shape);
  py::array_t<double> length(shape);
  std::int64_t* const indices = index.mutable_data();
  double* const lengths = length.mutable_data();
  unlocked(samples.view().size(), [&] {
    for (std::size_t i = 0; i < samples.view().size(); ++i) {
      const NearestNode found = *nodes.nearest(samples.view()[i]);
      indices[i] = found.node;
      lengths[i] = found.length;
    }
  });
  return py::make_tuple(index, length);
}

NodeSet nodes_of(const py::object& nodes, double radius) {
  expect_positive(radius, "radius");
  NodeSet all(radius);
  if (!nodes.is_none()) {
    const Poses poses(nodes, "nodes");
    unlocked(poses.view().size(), [&] { add_all(all, poses.view()); });
  }
  return all;
}

void bind_nearest(py::module_& module) {
  using namespace py::literals;
  module.def(
      "nearest",
      [](const py::object& nodes, const py::object& samples, double radius) {
        return nearest_of(nodes_of(nodes, radius), Poses(samples, "samples"));
      },
      "nodes"_a, "samples"_a, "radius"_a,
      R"(nearest(nodes, samples, radius) -> (index, length)

Nearest node of each sample by exact Reeds-Shepp length, and its length [m].

`nodes` are poses of shape (N, 3), `radius` is the turning radius [m]. The length is that from the
node to the sample. The results have the samples' leading shape; they are an int and a float for one
sample. Ties go to the first node. For many calls with the same nodes use `NearestNodes`.)");

  py::class_<NodeSet>(module, "NearestNodes", R"(NearestNodes(radius, nodes=None)

Index that finds the nearest nodes by Reeds-Shepp length quickly.

`radius` is the turning radius [m]. `nodes` are the first nodes, poses of shape (N, 3).)")
      .def(py::init([](double radius, const py::object& nodes) { return nodes_of(nodes, radius); }),
           "radius"_a, "nodes"_a = py::none())
      .def(
          "add",
          [](NodeSet& self, const py::object& nodes) {
            add_all(self, Poses(nodes, "nodes").view());
          },
          "nodes"_a, "add(nodes)\n\nAdds poses as nodes. Their numbers continue the existing ones.")
      .def(
          "nearest",
          [](const NodeSet& self, const py::object& samples) {
            return nearest_of(self, Poses(samples, "samples"));
          },
          "samples"_a,
          "nearest(samples) -> (index, length)\n\nNearest node of each sample, and the length from "
          "the "
          "node to the sample [m].")
      .def("near", &near, "sample"_a, py::kw_only(), "count"_a = py::none(),
           "within"_a = py::none(),
           R"(near(sample, *, count=None, within=None) -> (index, length)

Nodes near one sample, nearest first, and the lengths from them to the sample [m].

Returns at most `count` nodes, none of them further than `within` [m].)")
      .def("remove", &remove_node, "node"_a,
           "remove(node)\n\nRemoves a node. All other nodes keep their numbers.")
      .def("__len__", [](const NodeSet& self) { return self.index.size(); })
      .def(py::pickle(
          [](const NodeSet& self) {
            return py::make_tuple(self.radius, array_of(std::span<const Pose>(self.poses)),
                                  self.removed);
          },
          [](const py::tuple& state) {
            NodeSet nodes = nodes_of(state[1], state[0].cast<double>());
            for (const auto node : state[2].cast<std::vector<std::int64_t>>()) {
              remove_node(nodes, node);
            }
            return nodes;
          }));
}

}  // namespace

void bind_lengths(py::module_& module) {
  using namespace py::literals;
  module.def("reeds_shepp_length", &python_reeds_shepp_length, "starts"_a, "goals"_a, "radius"_a,
             "exact"_a = false, R"(reeds_shepp_length(starts, goals, radius, exact=False) -> length

Length of the shortest path in either gear from each start to its goal on open ground [m].

`radius` is the turning radius [m]. Poses are [x, y, heading], of shape (3,) or (..., 3). They
follow numpy's broadcasting rules: starts[:, None] and goals[None] give a table. The result is a
float for one pair of single poses.

Vector units compute many pairs at once, in double precision. With `exact` the C++ function for one
pair runs for each pair; the results are equal bit for bit.)");
  module.def("dubins_length", &python_dubins_length, "starts"_a, "goals"_a, "radius"_a,
             R"(dubins_length(starts, goals, radius) -> length

Length of the shortest path in forward gear only, from each start to its goal on open ground [m].

Poses and shapes are as in `reeds_shepp_length`.)");
  module.def("length_bounds", &python_length_bounds, "starts"_a, "goals"_a, "radius"_a,
             R"(length_bounds(starts, goals, radius) -> (low, high)

Lower and upper bound on `reeds_shepp_length` [m], from a table.

Poses and shapes are as in `reeds_shepp_length`.)");
  module.def("continuous_length", &python_continuous_length, "starts"_a, "goals"_a, "radius"_a,
             "curvature_rate"_a, "continuity"_a = "between-stops",
             R"(continuous_length(starts, goals, radius, curvature_rate, continuity="between-stops")

Length of a short path in either gear whose curvature changes gradually [m].

The curvature changes by at most `curvature_rate` per metre [1/m^2]. With "between-stops" it may
jump at gear changes, and the path may begin and end with any curvature. With "throughout" it never
jumps, and the wheels are straight at both ends. Poses and shapes are as in `reeds_shepp_length`.)");
  bind_nearest(module);
}

}  // namespace vandplan::python
