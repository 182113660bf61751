// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// base::sin_cos for moderate angles and base::atan_2 in vectors of double: the same operations in
// the same order, so the same bits. Included once for each target, like kernels_highway-inl.h, and
// after hwy/highway.h.

#if defined(VANDPLAN_SIMD_KERNELS_HIGHWAY_ANGLES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef VANDPLAN_SIMD_KERNELS_HIGHWAY_ANGLES_INL_H
#undef VANDPLAN_SIMD_KERNELS_HIGHWAY_ANGLES_INL_H
#else
#define VANDPLAN_SIMD_KERNELS_HIGHWAY_ANGLES_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace vandplan::simd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Functions of angles for vectors `V` of double.
template <typename V>
struct Angles {
  using D = hn::DFromV<V>;
  using U = hn::RebindToUnsigned<D>;
  using Bits = hn::Vec<U>;
  using Which = hn::Mask<D>;

  static HWY_INLINE V set(double value) { return hn::Set(D(), value); }
  static HWY_INLINE Bits bits(std::uint64_t value) { return hn::Set(U(), value); }

  /// a + z * b, with both operations rounded.
  static HWY_INLINE V plus(V a, V z, V b) { return hn::Add(a, hn::Mul(z, b)); }

  struct SinCos {
    V sin, cos;
  };

  static HWY_INLINE V with_sign_flipped(V value, Bits bit_1) {
    return hn::BitCast(D(), hn::Xor(hn::BitCast(U(), value), hn::ShiftLeft<62>(bit_1)));
  }

  /// The polynomial (s[0] + z (s[1] + z s[2])) + z^3 (s[3] + z (s[4] + z s[5])).
  static HWY_INLINE V six_terms(const double (&s)[6], V z, V z3) {
    const V low = plus(set(s[0]), z, plus(set(s[1]), z, set(s[2])));
    return plus(low, z3, plus(set(s[3]), z, plus(set(s[4]), z, set(s[5]))));
  }

  static HWY_INLINE SinCos sin_cos(V angle) {
    const V shifted =
        hn::Add(hn::Mul(angle, set(base::series::per_quarter)), set(base::series::round));
    const V n = hn::Sub(shifted, set(base::series::round));
    const V coarse = hn::Sub(angle, hn::Mul(n, set(base::series::half_pi_1)));
    const V fine = hn::Mul(n, set(base::series::half_pi_2));
    const V difference = hn::Sub(coarse, fine);
    const V back = hn::Sub(difference, coarse);
    const V error = hn::Sub(hn::Sub(coarse, hn::Sub(difference, back)), hn::Add(fine, back));
    const V first_rest = hn::Sub(error, hn::Mul(n, set(base::series::half_pi_3)));
    const V r = hn::Add(difference, first_rest);
    const V rest = hn::Sub(first_rest, hn::Sub(r, difference));

    const V z = hn::Mul(r, r);
    const V z3 = hn::Mul(hn::Mul(z, z), z);
    const V s = six_terms(base::series::sine, z, z3);
    const V c = six_terms(base::series::cosine, z, z3);
    const V half_z = hn::Mul(set(0.5), z);
    const V large = hn::Sub(set(1.0), half_z);
    const V sine = hn::Add(r, hn::Add(hn::Mul(hn::Mul(r, z), s), hn::Mul(rest, large)));
    const V small = hn::Sub(hn::Mul(hn::Mul(z, z), c), hn::Mul(r, rest));
    const V cosine = hn::Add(large, hn::Add(hn::Sub(hn::Sub(set(1.0), large), half_z), small));

    const Bits quarters = hn::BitCast(U(), shifted);
    const Bits one = bits(1);
    const Bits two = bits(2);
    const Which odd = hn::RebindMask(D(), hn::Eq(hn::And(quarters, one), one));
    return {
        with_sign_flipped(hn::IfThenElse(odd, cosine, sine), hn::And(quarters, two)),
        with_sign_flipped(hn::IfThenElse(odd, sine, cosine), hn::And(hn::Add(quarters, one), two))};
  }

  /// The multiple of pi/4 from which the angle is counted, one of `base::series::eighths` or
  /// `base::series::rests`.
  static HWY_INLINE V of_eighths(const double (&all)[5], Which middle, Which steep, Which back) {
    const V ahead =
        hn::IfThenElse(middle, set(all[1]), hn::IfThenElse(steep, set(all[2]), set(all[0])));
    const V behind =
        hn::IfThenElse(middle, set(all[3]), hn::IfThenElse(steep, set(all[2]), set(all[4])));
    return hn::IfThenElse(back, behind, ahead);
  }

  /// base::atan_2 for numbers below 2^1020.
  static HWY_INLINE V atan_2(V y, V x) {
    const V abs_x = hn::Abs(x);
    const V abs_y = hn::Abs(y);
    const V a = hn::Min(abs_x, abs_y);
    V b = hn::Max(abs_x, abs_y);
    b = hn::IfThenElse(hn::Eq(b, hn::Zero(D())), set(1.0), b);
    const Which middle = hn::Gt(a, hn::Mul(b, set(base::series::tan_eighth)));
    const V q = hn::Div(hn::Sub(a, hn::IfThenElseZero(middle, b)),
                        hn::Add(b, hn::IfThenElseZero(middle, a)));
    const V z = hn::Mul(q, q);
    const V z2 = hn::Mul(z, z);
    const V z4 = hn::Mul(z2, z2);
    const auto& A = base::series::arc_tangent;
    const auto four_terms = [&](int i) {
      return plus(plus(set(A[i]), z, set(A[i + 1])), z2, plus(set(A[i + 2]), z, set(A[i + 3])));
    };
    const V p2 = plus(plus(set(A[8]), z, set(A[9])), z2, set(A[10]));
    const V p = plus(four_terms(0), z4, plus(four_terms(4), z4, p2));
    const V angle = hn::Add(q, hn::Mul(q, hn::Mul(z, p)));

    const Which steep = hn::Gt(abs_y, abs_x);
    const Which back = hn::MaskFromVec(
        hn::BitCast(D(), hn::BroadcastSignBit(hn::BitCast(hn::RebindToSigned<D>(), x))));
    const V turned = hn::IfThenElse(hn::Xor(steep, back), hn::Neg(angle), angle);
    const V sum = hn::Add(of_eighths(base::series::eighths, middle, steep, back),
                          hn::Add(of_eighths(base::series::rests, middle, steep, back), turned));
    return hn::CopySign(sum, y);
  }
};

}  // namespace vandplan::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
