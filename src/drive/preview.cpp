// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "drive/preview.h"

#include "drive/linear_quadratic.h"

namespace vandplan::driving {
namespace {

// The state is (e, h, k): lateral error, slant, curvature of the vehicle. In one step of length d
//   e' = e + d h + d^2/2 (k - r) + d^3/6 u,   h' = h + d (k - r) + d^2/2 u,   k' = k + d u.
// Here r is the curvature of the path, and u the derivative of the vehicle's curvature.
constexpr double d = preview_step;
constexpr Vector<3> path_bends = {-d * d / 2, -d, 0};

// A step costs e^2 + h^2 + effort * u^2. With less effort clothoids are followed more exactly, and
// the wheels tremble more with noise.
constexpr double effort = 5e-4;
constexpr LinearStep<3> one_step = {{{{1, d, d* d / 2}, {0, 1, d}, {0, 0, 1}}},
                                    {d * d * d / 6, d* d / 2, d},
                                    {{{d, 0, 0}, {0, d, 0}, {0, 0, 0}}},
                                    effort* d};

PreviewGains worked_out() {
  // 1. Riccati's equation is iterated until the cost has converged.
  constexpr int rounds = 2000;
  Matrix<3> cost = one_step.price;
  for (int n = 0; n < rounds; ++n) cost = cost_before(one_step, cost);
  const auto [gains, weight, closed] = feedback(one_step, cost);
  // 2. The curvature i steps ahead changes the optimal input (Tomizuka 1975).
  PreviewGains result{gains[0], gains[1], gains[2], {}};
  Vector<3> felt = product(cost, path_bends);
  for (double& ahead : result.ahead) {
    ahead = -dot(one_step.input, felt) / weight;
    felt = product(transposed(closed), felt);
  }
  // Beyond the preview the path keeps the last previewed curvature.
  for (int n = 0; n < rounds; ++n) {
    result.ahead.back() -= dot(one_step.input, felt) / weight;
    felt = product(transposed(closed), felt);
  }
  return result;
}

}  // namespace

const PreviewGains& preview_gains() noexcept {
  static const PreviewGains gains = worked_out();
  return gains;
}

}  // namespace vandplan::driving
