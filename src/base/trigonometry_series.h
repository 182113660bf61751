// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which constants do sine, cosine and arc tangent rest on?
//
// They serve single angles (trigonometry.cpp) and vectors of angles (simd).

namespace vandplan::base::series {

/// Quarter turns in a radian: 2 / pi.
inline constexpr double per_quarter = 0x1.45f306dc9c883p-1;
/// pi/2 in three parts, the first two so short that their multiples by up to 255 are exact.
inline constexpr double half_pi_1 = 0x1.921fb54442p+0;
inline constexpr double half_pi_2 = 0x1.a308d31318p-41;
inline constexpr double half_pi_3 = 0x1.8a2e03707344ap-81;
/// Adding this number rounds to a whole number.
inline constexpr double round = 0x1.8p52;
/// The largest angle whose quarter turns can be taken off with the three parts of pi/2 [rad].
inline constexpr double moderate = 400;

// Minimax polynomials in z = r^2 up to pi/4, first term first, relative error 2^-58:
// sin r = r + r^3 S(z), cos r = 1 - z/2 + z^2 C(z).
inline constexpr double sine[] = {-0x1.5555555555549p-3,  0x1.111111110f880p-7,
                                  -0x1.a01a019c12698p-13, 0x1.71de357872f0bp-19,
                                  -0x1.ae5e66d3b513bp-26, 0x1.5d932eece0247p-33};
inline constexpr double cosine[] = {0x1.555555555554cp-5,  -0x1.6c16c16c15184p-10,
                                    0x1.a01a019cb26dap-16, -0x1.27e4f80a75567p-22,
                                    0x1.1ee9ec46f8c3dp-29, -0x1.8faececa1dcc4p-37};

/// Minimax polynomial in z = q^2 up to tan(pi/8), relative error 2^-59: atan q = q + q z A(z).
inline constexpr double arc_tangent[] = {
    -0x1.555555555553dp-2, 0x1.99999999958fap-3, -0x1.24924922b1848p-3, 0x1.c71c70e7cb136p-4,
    -0x1.745cf90fdcd2ap-4, 0x1.3b111cbc033a1p-4, -0x1.10ebe19dd74c3p-4, 0x1.df11a33190cbcp-5,
    -0x1.9cdd3a259de15p-5, 0x1.37f00a92da422p-5, -0x1.25a3844610dbdp-6};
inline constexpr double tan_eighth = 0x1.a827999fcef32p-2;  ///< tan(pi/8)

// Multiples of pi/4 as sums eighths[i] + rests[i].
inline constexpr double eighths[] = {0, 0x1.921fb54442d18p-1, 0x1.921fb54442d18p+0,
                                     0x1.2d97c7f3321d2p+1, 0x1.921fb54442d18p+1};
inline constexpr double rests[] = {0, 0x1.1a62633145c07p-55, 0x1.1a62633145c07p-54,
                                   0x1.a79394c9e8a0ap-54, 0x1.1a62633145c07p-53};

}  // namespace vandplan::base::series
