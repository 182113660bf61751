// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a small network learn of a function?

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vandplan::studies {

/// A network with two hidden layers of rectified units, and one output.
class Network {
 public:
  /// Units of a hidden layer.
  static constexpr std::size_t width = 32;

  /// A network with random weights. `inputs` in [1, 32].
  Network(std::size_t inputs, std::uint64_t seed);

  /// The output for as many numbers as the network has inputs.
  [[nodiscard]] float value(std::span<const float> input) const noexcept;

  /// A step of training, by Adam (Kingma and Ba, 2015). `inputs` holds the inputs of one sample
  /// after the other. Errors count squared up to 1, and linearly beyond it. `rate`: size of the
  /// step, > 0.
  void learn(std::span<const float> inputs, std::span<const float> targets, float rate);

  /// Weights of the layers, one layer after the other. A layer has a row of weights to its outputs
  /// for each of its inputs, and a last row that is added.
  [[nodiscard]] const std::vector<float>& weights() const noexcept { return weights_; }

 private:
  std::size_t inputs_;
  std::vector<float> weights_, gradient_, mean_, square_;  // of equal size; last two: Adam's
  float mean_left_ = 1.0F, square_left_ = 1.0F;            // shares of Adam's means that are zero
};

}  // namespace vandplan::studies
