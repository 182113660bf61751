// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "drive/preview.h"

namespace vandplan::driving {
namespace {

// The state is (e, h, k): lateral error, slant, curvature of the vehicle. In one step of length d
//   e' = e + d h + d^2/2 (k - r) + d^3/6 u,   h' = h + d (k - r) + d^2/2 u,   k' = k + d u,
// where r is the curvature of the path there and u the change of the vehicle's.
using Vector = std::array<double, 3>;
using Matrix = std::array<Vector, 3>;

constexpr double d = preview_step;
constexpr Matrix motion = {{{1, d, d* d / 2}, {0, 1, d}, {0, 0, 1}}};
constexpr Vector input = {d * d * d / 6, d* d / 2, d};
constexpr Vector path_bends = {-d * d / 2, -d, 0};

// What a step costs: e^2 + h^2 + effort * u^2. The less the effort, the more exactly clothoids are
// followed, and the more the wheels tremble with noise.
constexpr double effort = 5e-4;

Vector product(const Matrix& m, const Vector& v) {
  Vector result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) result[i] += m[i][j] * v[j];
  }
  return result;
}

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) result[i][j] += a[i][k] * b[k][j];
    }
  }
  return result;
}

Matrix transposed(const Matrix& m) {
  Matrix result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) result[i][j] = m[j][i];
  }
  return result;
}

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// The feedback that is optimal for the next step if `cost` is what states cost after it.
Vector feedback(const Matrix& cost, double& weight) {
  const Vector dear = product(cost, input);
  weight = effort * d + dot(input, dear);
  Vector gains = product(transposed(motion), dear);
  for (double& gain : gains) gain /= weight;
  return gains;
}

PreviewGains worked_out() {
  // 1. Riccati's equation, step by step until nothing changes any more.
  constexpr int rounds = 2000;
  Matrix cost = {{{d, 0, 0}, {0, d, 0}, {0, 0, 0}}};
  const Matrix step_cost = cost;
  double weight = 1.0;
  for (int n = 0; n < rounds; ++n) {
    const Vector gains = feedback(cost, weight);
    Matrix closed = motion;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) closed[i][j] -= input[i] * gains[j];
    }
    Matrix next = product(transposed(motion), product(cost, closed));
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) next[i][j] += step_cost[i][j];
    }
    cost = next;
  }
  const Vector gains = feedback(cost, weight);
  // 2. What the path does i steps ahead moves the best input of now (Tomizuka 1975).
  Matrix closed = motion;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) closed[i][j] -= input[i] * gains[j];
  }
  PreviewGains result{gains[0], gains[1], gains[2], {}};
  Vector felt = product(cost, path_bends);
  for (double& ahead : result.ahead) {
    ahead = -dot(input, felt) / weight;
    felt = product(transposed(closed), felt);
  }
  // Beyond what is looked at the path goes on bending as there.
  for (int n = 0; n < rounds; ++n) {
    result.ahead.back() -= dot(input, felt) / weight;
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
