// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which parts of C++20's library does Debian's Emscripten (3.1.6, libc++ 13) lack that the core
// uses?
//
// Included before every file of the preset `web`. A library that has these parts skips the content.
// Headers that are missing as a whole are in the folder `older`.

#include <version>
#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 15000

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <iterator>
#include <utility>

namespace std {

template <class To, class From>
[[nodiscard]] constexpr To bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}

// ---- numbers and text ----

/// Writes the shortest decimal that reads back as the same number. The C library rounds correctly,
/// so the first number of digits that does is the least.
inline to_chars_result to_chars(char* first, char* last, double value, chars_format format) {
  char text[400];
  int size = 0;
  if (format == chars_format::hex) {
    size = snprintf(text, sizeof text, "%a", value);
  } else {
    const char* const pattern = format == chars_format::scientific ? "%.*e" : "%.*g";
    const int least = format == chars_format::scientific ? 0 : 1;
    for (int digits = least; digits <= least + 16; ++digits) {
      size = snprintf(text, sizeof text, pattern, digits, value);
      if (strtod(text, nullptr) == value) break;
    }
  }
  if (size > last - first) return {last, errc::value_too_large};
  memcpy(first, text, static_cast<size_t>(size));
  return {first + size, errc()};
}
inline to_chars_result to_chars(char* first, char* last, double value) {
  return to_chars(first, last, value, chars_format::general);
}
inline to_chars_result to_chars(char* first, char* last, float value) {
  char text[64];
  int size = 0;
  for (int digits = 1; digits <= 9; ++digits) {
    size = snprintf(text, sizeof text, "%.*g", digits, static_cast<double>(value));
    if (strtof(text, nullptr) == value) break;
  }
  if (size > last - first) return {last, errc::value_too_large};
  memcpy(first, text, static_cast<size_t>(size));
  return {first + size, errc()};
}

inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  char text[400];
  const auto size = min<ptrdiff_t>(last - first, sizeof text - 1);
  memcpy(text, first, static_cast<size_t>(size));
  text[size] = '\0';
  const bool begins =
      size > 0 && (text[0] == '-' || text[0] == '.' || (text[0] >= '0' && text[0] <= '9') ||
                   text[0] == 'i' || text[0] == 'n');
  const bool is_hex = strpbrk(text, "xX") != nullptr;
  char* end = text;
  const double read = begins && !is_hex ? strtod(text, &end) : 0.0;
  if (end == text) return {first, errc::invalid_argument};
  if (read == HUGE_VAL || read == -HUGE_VAL) {
    if (strpbrk(text, "iI") == nullptr) return {first + (end - text), errc::result_out_of_range};
  }
  value = read;
  return {first + (end - text), errc()};
}

// ---- algorithms on ranges ----

namespace ranges {

template <class R, class T, class P = identity>
constexpr auto find(R&& r, const T& value, P p = {}) {
  return std::find_if(std::begin(r), std::end(r),
                      [&](const auto& each) { return std::invoke(p, each) == value; });
}
template <class R, class F, class P = identity>
constexpr auto find_if(R&& r, F f, P p = {}) {
  return std::find_if(std::begin(r), std::end(r), [&](const auto& each) {
    return static_cast<bool>(std::invoke(f, std::invoke(p, each)));
  });
}
template <class R, class F>
constexpr bool any_of(R&& r, F f) {
  return std::any_of(std::begin(r), std::end(r), f);
}
template <class R, class F>
constexpr bool all_of(R&& r, F f) {
  return std::all_of(std::begin(r), std::end(r), f);
}
template <class R, class F>
constexpr bool none_of(R&& r, F f) {
  return std::none_of(std::begin(r), std::end(r), f);
}
template <class R, class O>
constexpr void copy(R&& r, O out) {
  std::copy(std::begin(r), std::end(r), out);
}
template <class R, class T>
constexpr void fill(R&& r, const T& value) {
  std::fill(std::begin(r), std::end(r), value);
}
template <class R>
constexpr void reverse(R&& r) {
  std::reverse(std::begin(r), std::end(r));
}
template <class R, class O, class F>
constexpr void transform(R&& r, O out, F f) {
  std::transform(std::begin(r), std::end(r), out,
                 [&](const auto& each) { return std::invoke(f, each); });
}

/// Comparison of the projections of two objects.
template <class C, class P>
constexpr auto ordered_by(C c, P p) {
  return [c, p](const auto& a, const auto& b) {
    return static_cast<bool>(std::invoke(c, std::invoke(p, a), std::invoke(p, b)));
  };
}
template <class R, class C = std::less<>, class P = identity>
constexpr void sort(R&& r, C c = {}, P p = {}) {
  std::sort(std::begin(r), std::end(r), ordered_by(c, p));
}
template <class R, class C = std::less<>, class P = identity>
void stable_sort(R&& r, C c = {}, P p = {}) {
  std::stable_sort(std::begin(r), std::end(r), ordered_by(c, p));
}
template <class R, class I, class C = std::less<>, class P = identity>
constexpr void nth_element(R&& r, I nth, C c = {}, P p = {}) {
  std::nth_element(std::begin(r), nth, std::end(r), ordered_by(c, p));
}
template <class R, class C = std::less<>, class P = identity>
constexpr auto min_element(R&& r, C c = {}, P p = {}) {
  return std::min_element(std::begin(r), std::end(r), ordered_by(c, p));
}
template <class R, class C = std::less<>, class P = identity>
constexpr auto max_element(R&& r, C c = {}, P p = {}) {
  return std::max_element(std::begin(r), std::end(r), ordered_by(c, p));
}
template <class R, class T, class C = std::less<>, class P = identity>
constexpr auto lower_bound(R&& r, const T& value, C c = {}, P p = {}) {
  return std::lower_bound(std::begin(r), std::end(r), value,
                          [&](const auto& each, const T& wanted) {
                            return static_cast<bool>(std::invoke(c, std::invoke(p, each), wanted));
                          });
}
template <class R, class T, class C = std::less<>, class P = identity>
constexpr auto upper_bound(R&& r, const T& value, C c = {}, P p = {}) {
  return std::upper_bound(std::begin(r), std::end(r), value,
                          [&](const T& wanted, const auto& each) {
                            return static_cast<bool>(std::invoke(c, wanted, std::invoke(p, each)));
                          });
}

}  // namespace ranges
}  // namespace std

#endif
