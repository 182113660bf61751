// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "studies/network.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "vandplan/random.h"

namespace vandplan::studies {
namespace {

constexpr std::size_t layers = 3;
constexpr std::size_t width = Network::width;
constexpr float mean_kept = 0.9F, square_kept = 0.999F;  // Adam's decays
constexpr float least_square = 1e-8F;

using Units = std::array<float, width>;

/// A layer among the weights.
struct Layer {
  std::size_t at, inputs, outputs;
};

std::array<Layer, layers> layers_of(std::size_t inputs) {
  const std::size_t second = (inputs + 1) * width;
  return {Layer{0, inputs, width}, Layer{second, width, width},
          Layer{second + (width + 1) * width, width, 1}};
}

std::size_t size_of(std::size_t inputs) {
  const Layer last = layers_of(inputs).back();
  return last.at + last.inputs + 1;
}

/// Sums of a layer's inputs by their weights. The inner loop runs over outputs: no sum is split, so
/// it runs in vectors with equal results.
template <std::size_t outputs>
void apply(const float* weights, std::span<const float> in, float* out) {
  std::copy_n(weights + in.size() * outputs, outputs, out);
  for (const float input : in) {
    for (std::size_t o = 0; o < outputs; ++o) out[o] += input * weights[o];
    weights += outputs;
  }
}

void rectify(Units& units) {
  for (float& unit : units) unit = std::max(unit, 0.0F);
}

/// Outputs of the hidden layers and of the network.
struct Pass {
  Units first, second;
  float output;
};

Pass pass_of(std::span<const float> input, const std::vector<float>& weights) {
  const std::array<Layer, layers> all = layers_of(input.size());
  Pass pass;
  apply<width>(weights.data(), input, pass.first.data());
  rectify(pass.first);
  apply<width>(weights.data() + all[1].at, pass.first, pass.second.data());
  rectify(pass.second);
  apply<1>(weights.data() + all[2].at, pass.second, &pass.output);
  return pass;
}

/// Adds the slopes of a layer's weights, and returns those of its inputs, for the slopes of its
/// outputs.
Units back(const Layer& layer, const std::vector<float>& weights, std::span<const float> in,
           std::span<const float> slopes, std::vector<float>& gradient) {
  Units of_inputs = {};
  for (std::size_t i = 0; i <= layer.inputs; ++i) {
    const float input = i < layer.inputs ? in[i] : 1.0F;
    float sum = 0.0F;
    for (std::size_t o = 0; o < layer.outputs; ++o) {
      const std::size_t at = layer.at + i * layer.outputs + o;
      gradient[at] += slopes[o] * input;
      sum += slopes[o] * weights[at];
    }
    if (i < layer.inputs) of_inputs[i] = input > 0.0F ? sum : 0.0F;
  }
  return of_inputs;
}

}  // namespace

Network::Network(std::size_t inputs, std::uint64_t seed)
    : inputs_(inputs),
      weights_(size_of(inputs)),
      gradient_(weights_),
      mean_(weights_),
      square_(weights_) {
  assert(inputs >= 1 && inputs <= width);
  Rng rng(seed);
  for (const Layer& layer : layers_of(inputs)) {
    const double largest = std::sqrt(6.0 / static_cast<double>(layer.inputs));
    for (std::size_t i = 0; i < layer.inputs * layer.outputs; ++i) {
      weights_[layer.at + i] = static_cast<float>(uniform(-largest, largest, rng));
    }
  }
}

float Network::value(std::span<const float> input) const noexcept {
  assert(input.size() == inputs_);
  return pass_of(input, weights_).output;
}

void Network::learn(std::span<const float> inputs, std::span<const float> targets, float rate) {
  assert(inputs.size() == targets.size() * inputs_);
  const std::array<Layer, layers> all = layers_of(inputs_);
  std::ranges::fill(gradient_, 0.0F);
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const std::span<const float> input = inputs.subspan(i * inputs_, inputs_);
    const Pass pass = pass_of(input, weights_);
    const float error = std::clamp(pass.output - targets[i], -1.0F, 1.0F);
    const Units second = back(all[2], weights_, pass.second, {&error, 1}, gradient_);
    const Units first = back(all[1], weights_, pass.first, second, gradient_);
    (void)back(all[0], weights_, input, first, gradient_);
  }
  mean_left_ *= mean_kept;
  square_left_ *= square_kept;
  const float samples = static_cast<float>(targets.size());
  for (std::size_t i = 0; i < weights_.size(); ++i) {
    const float slope = gradient_[i] / samples;
    mean_[i] = mean_kept * mean_[i] + (1 - mean_kept) * slope;
    square_[i] = square_kept * square_[i] + (1 - square_kept) * slope * slope;
    const float spread = std::sqrt(square_[i] / (1 - square_left_));
    weights_[i] -= rate * mean_[i] / (1 - mean_left_) / (spread + least_square);
  }
}

}  // namespace vandplan::studies
