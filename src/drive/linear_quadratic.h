// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which feedback minimizes a quadratic cost of errors with linear dynamics?

#include <array>
#include <cstddef>

namespace vandplan::driving {

template <std::size_t N>
using Vector = std::array<double, N>;
template <std::size_t N>
using Matrix = std::array<Vector<N>, N>;

template <std::size_t N>
Vector<N> product(const Matrix<N>& m, const Vector<N>& v) {
  Vector<N> result{};
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j < N; ++j) result[i] += m[i][j] * v[j];
  }
  return result;
}

template <std::size_t N>
Matrix<N> product(const Matrix<N>& a, const Matrix<N>& b) {
  Matrix<N> result{};
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j < N; ++j) {
      for (std::size_t k = 0; k < N; ++k) result[i][j] += a[i][k] * b[k][j];
    }
  }
  return result;
}

template <std::size_t N>
Matrix<N> transposed(const Matrix<N>& m) {
  Matrix<N> result{};
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j < N; ++j) result[j][i] = m[i][j];
  }
  return result;
}

template <std::size_t N>
double dot(const Vector<N>& a, const Vector<N>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < N; ++i) sum += a[i] * b[i];
  return sum;
}

/// Step of a linear system: the state x becomes `motion` x + `input` u. It costs x' `price` x +
/// `effort` u^2.
template <std::size_t N>
struct LinearStep {
  Matrix<N> motion = {};
  Vector<N> input = {};
  Matrix<N> price = {};
  double effort = 0.0;
};

/// Optimal feedback: the input u = -`gains` x costs least.
template <std::size_t N>
struct Feedback {
  Vector<N> gains = {};
  double weight = 0.0;    ///< weight of u^2 in the total cost
  Matrix<N> closed = {};  ///< matrix of the closed loop: the state becomes `closed` x
};

/// Optimal feedback of a step, if the state x after the step costs x' `cost` x.
template <std::size_t N>
Feedback<N> feedback(const LinearStep<N>& step, const Matrix<N>& cost) {
  const Vector<N> dear = product(cost, step.input);
  Feedback<N> result{product(transposed(step.motion), dear), step.effort + dot(step.input, dear),
                     step.motion};
  for (double& gain : result.gains) gain /= result.weight;
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j < N; ++j) result.closed[i][j] -= step.input[i] * result.gains[j];
  }
  return result;
}

/// Matrix of the optimal cost before the step, given that after it (Riccati's equation).
template <std::size_t N>
Matrix<N> cost_before(const LinearStep<N>& step, const Matrix<N>& cost) {
  const Matrix<N> closed = feedback(step, cost).closed;
  Matrix<N> result = product(transposed(step.motion), product(cost, closed));
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j < N; ++j) result[i][j] += step.price[i][j];
  }
  return result;
}

}  // namespace vandplan::driving
