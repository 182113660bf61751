// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// How long is the shortest word of Reeds and Shepp, in vectors of float or of double?
//
// Included once for each target, like kernels_highway-inl.h, and after hwy/highway.h.

#if defined(VANDPLAN_SIMD_KERNELS_HIGHWAY_WORDS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef VANDPLAN_SIMD_KERNELS_HIGHWAY_WORDS_INL_H
#undef VANDPLAN_SIMD_KERNELS_HIGHWAY_WORDS_INL_H
#else
#define VANDPLAN_SIMD_KERNELS_HIGHWAY_WORDS_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace vandplan::simd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// a * b + c * d, with each operation rounded.
template <typename V>
HWY_INLINE V sum_of_products(V a, V b, V c, V d) {
  return hn::Add(hn::Mul(a, b), hn::Mul(c, d));
}

/// a * b - c * d, with each operation rounded.
template <typename V>
HWY_INLINE V difference_of_products(V a, V b, V c, V d) {
  return hn::Sub(hn::Mul(a, b), hn::Mul(c, d));
}

/// Lengths by the formulas of steering/reeds_shepp_formulas.h. `Math` has the type of the vectors
/// and the functions that depend on it: atan_2, root (0 for numbers below 0), less_four_plus_pi.
template <typename Math>
struct ShortestWord {
  using V = typename Math::V;
  using Tag = hn::DFromV<V>;
  using Which = hn::Mask<Tag>;

  static HWY_INLINE V set(double value) {
    return hn::Set(Tag(), static_cast<hn::TFromD<Tag>>(value));
  }

  /// Pairs of poses in mean frames (steering/mean_frame.h), all signs positive, in turning radii.
  struct Circles {
    V x, y, a, s, c, lr, rl;
  };

  /// Parts of a word's length, line + 2 * angle. The angle is that of the vector (x, y) turned by
  /// the angle of the vector (p, q).
  struct Parts {
    V line, x, y, p, q;

    void choose(Which which, const Parts& other) {
      line = hn::IfThenElse(which, other.line, line);
      x = hn::IfThenElse(which, other.x, x);
      y = hn::IfThenElse(which, other.y, y);
      p = hn::IfThenElse(which, other.p, p);
      q = hn::IfThenElse(which, other.q, q);
    }
    [[nodiscard]] V angle() const {
      return Math::atan_2(sum_of_products(y, p, x, q), difference_of_products(x, p, y, q));
    }
  };

  /// Conditions of the scalar code, of which the first one that holds counts, and numbers that they
  /// share.
  struct Words {
    Which l_r_l, r_lsl, lsl, r_lsr_l, r_lsr, lsr;
    V less, x, ahead, square;

    explicit Words(const Circles& f) {
      const V zero = hn::Zero(Tag());
      const V two_s = hn::Mul(set(2.0), f.s);
      less = hn::Sub(f.x, two_s);
      x = hn::Add(f.x, two_s);
      ahead = difference_of_products(less, f.c, f.y, f.s);
      square = sum_of_products(x, x, f.y, f.y);
      const V beyond = hn::Sub(sum_of_products(x, f.c, f.y, f.s), set(2.0));
      const V two_cc = hn::Mul(hn::Mul(set(2.0), f.c), f.c);
      const V four_sc = hn::Mul(hn::Mul(set(4.0), f.s), f.c);
      l_r_l = hn::Le(f.rl, zero);
      r_lsl =
          hn::And(hn::Le(ahead, zero), hn::Ge(difference_of_products(f.x, f.s, f.y, f.c), two_cc));
      lsl = hn::And(hn::Ge(ahead, zero), hn::Ge(difference_of_products(less, f.s, f.y, f.c), zero));
      r_lsr_l = hn::And(hn::Ge(f.rl, set(16.0)), hn::Le(beyond, zero));
      r_lsr = hn::And(hn::And(hn::Ge(square, set(8.0)), hn::Ge(beyond, zero)),
                      hn::Le(hn::Add(ahead, four_sc), set(2.0)));
      lsr = hn::Ge(f.lr, zero);
    }
    [[nodiscard]] Which has_no_angle() const { return hn::Or(l_r_l, hn::Or(r_lsl, lsl)); }
    [[nodiscard]] Which is_of_arcs() const {
      return hn::Not(hn::Or(hn::Or(has_no_angle(), r_lsr_l), hn::Or(r_lsr, lsr)));
    }
  };

  /// Parts of the words with a line. 8.3, 8.10 and 8.1 have the angle `f.a`, and get the line only.
  static Parts with_line(const Circles& f, const Words& is) {
    V square = hn::IfThenElse(is.r_lsr, hn::Sub(is.square, set(4.0)), f.lr);  // 8.9, 8.2
    square = hn::IfThenElse(is.r_lsr_l, f.rl, square);                        // 8.11
    square = hn::IfThenElse(is.lsl, sum_of_products(is.less, is.less, f.y, f.y), square);  // 8.1
    square = hn::IfThenElse(is.r_lsl, hn::Add(set(4.0), f.rl), square);                    // 8.10
    const V d = Math::root(square);
    const V two = set(2.0);
    const V two_c = hn::Mul(two, f.c);
    const V less_two = hn::Sub(d, two);
    Parts parts{d, f.x, hn::Sub(f.y, two_c), d, two};       // 8.2
    parts.choose(is.r_lsr, {less_two, is.x, f.y, d, two});  // 8.9
    const V less_arcs = Math::less_four_plus_pi(d);
    parts.choose(is.r_lsr_l, {less_arcs, hn::Add(f.y, two_c), hn::Neg(f.x), d, two});  // 8.11
    parts.line = hn::IfThenElse(is.lsl, d, parts.line);
    parts.line = hn::IfThenElse(is.r_lsl, less_two, parts.line);
    parts.line = hn::IfThenZeroElse(is.l_r_l, parts.line);
    return parts;
  }

  /// Parts of words of arcs: 8.8 in the lanes of `is_r_lr_l`, otherwise 8.4.
  static Parts of_arcs(const Circles& f, const Words& is, Which is_r_lr_l) {
    const V one = set(1.0);
    const V two = set(2.0);
    const V sixteenth = set(0.0625);
    const V cos = hn::Sub(one, hn::Mul(f.rl, sixteenth));
    const V sin = hn::Mul(Math::root(hn::Mul(f.rl, hn::Sub(set(32.0), f.rl))), sixteenth);
    Parts parts{hn::Zero(Tag()), is.x, f.y, Math::root(hn::Sub(one, hn::Mul(is.square, sixteenth))),
                hn::Mul(Math::root(is.square), set(0.25))};
    parts.choose(is_r_lr_l, {hn::Zero(Tag()), hn::Add(f.y, hn::Mul(two, f.c)), hn::Neg(f.x),
                             hn::Sub(hn::Mul(two, cos), one), hn::Mul(two, sin)});
    return parts;
  }

  /// Length of 8.7. `between`: distance from the first left to the last right circle's centre.
  static V lr_lr(const Circles& f, V between) {
    const V eight = set(8.0);
    const V sin_squared = hn::Div(hn::Neg(f.lr), hn::Mul(eight, hn::Add(set(2.0), between)));
    const V quarter =
        Math::atan_2(Math::root(sin_squared), Math::root(hn::Sub(set(1.0), sin_squared)));
    return hn::Sub(hn::Mul(eight, quarter), hn::Mul(set(2.0), f.a));
  }

  static V shortest(const Circles& f) {
    const V zero = hn::Zero(Tag());
    const V two = set(2.0);
    const Words is(f);
    Parts parts = with_line(f, is);
    const Which arcs = is.is_of_arcs();
    const bool any_arcs = !hn::AllFalse(Tag(), arcs);
    Which is_r_lr_l = arcs;
    if (any_arcs) {
      const V eight_s = hn::Mul(set(8.0), f.s);
      is_r_lr_l = hn::And(arcs, hn::Le(hn::Add(f.lr, hn::Mul(eight_s, is.x)), zero));
      parts.choose(arcs, of_arcs(f, is, is_r_lr_l));
    }
    const V angle = hn::IfThenElse(is.has_no_angle(), f.a, parts.angle());
    const V length = hn::Add(parts.line, hn::Mul(two, angle));
    if (!any_arcs) return length;

    const V across = hn::Sub(hn::Mul(two, f.c), f.y);
    const V between = Math::root(sum_of_products(f.x, f.x, across, across));
    const V rise =
        sum_of_products(f.lr, hn::Add(between, set(4.0)), hn::Mul(set(4.0), hn::Add(between, two)),
                        sum_of_products(f.s, is.x, f.y, f.c));
    const V end = hn::Add(is.ahead, hn::Mul(hn::Mul(two, f.y), f.s));
    const Which is_lr_lr = hn::And(arcs, hn::And(hn::Le(rise, zero), hn::Le(end, zero)));
    if (hn::AllFalse(Tag(), is_lr_lr)) return length;
    const V other = lr_lr(f, between);
    const Which better = hn::Or(hn::Not(is_r_lr_l), hn::Lt(other, length));
    return hn::IfThenElse(hn::And(is_lr_lr, better), other, length);
  }
};

}  // namespace vandplan::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
